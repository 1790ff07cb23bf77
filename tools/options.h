/* The command line after the subcommand's name. Options may stand before or after the fonts. */
#pragma once

#include "morphotype.h"
#include "motion_options.h"
#include "option_table.h"
#include "solid_options.h"

typedef struct cli_options {
    const char *command;
    const char *fonts[MT_VARIABLE_FONTS_MAX]; /* specs; the second NULL where there is one */
    int font_count;
    const char *output, *format; /* NULL: not given */
    double *at, *at_up;          /* T's, and T's of heights; from mt_new */
    bool own_heights;            /* of any place they are not the same */
    int at_count;                /* 0: not given */
    double *map_values;          /* of --avar, and … */
    double *map_places;          /* … how far the font has got there; from mt_new */
    int map_count;               /* 0: not given */
    int steps;                   /* 0: not given */
    char *text;                  /* UTF-8; the --text arguments, a line each; NULL: not given */
    const char *chars_file;      /* NULL: not given */
    const char *pairs_file;      /* NULL: not given */
    const char *hints_file;      /* NULL: not given */
    const char *places_file;     /* NULL: not given */
    const char *family;          /* NULL: not given */
    char *style_text;            /* from mt_new; the styles are cut out of it */
    const char **styles;         /* from mt_new */
    int style_count;             /* 0: not given */
    char axis_tag[5];            /* "": not given */
    double axis_from, axis_to;
    bool own_stops;       /* --axis without them: each font at a place of its own */
    bool has_italic;      /* of a family: it has italics in another file */
    double *stops;        /* where each font stands; from mt_new */
    int stop_count;       /* 0: not given */
    const char *cache;    /* a directory; NULL: not given */
    uint64_t cache_bytes; /* 0: not given */
    double size;          /* 0: not given */
    int rows;             /* 0: not given */
    mt_glyph_set glyphs;
    mt_curves curves;
    cli_motion motion;   /* of animate */
    cli_solid solid;     /* of solid */
    unsigned fail_flags; /* of --fail-on; mt_report_flag */
    int fail_count;      /* the same; 0: not given */
    bool alternates, no_layout, no_labels, json, strict, quiet, verbose;
    mt_params params;
} cli_options;

typedef struct cli_example {
    const char *what, *line; /* a command line as it is typed */
} cli_example;

enum { CLI_EXAMPLES = 4 };

/* The extensions of fonts, as cli_command has them. */
#define CLI_FONT_FILES "ttf otf ttc otc woff woff2 pfa pfb"

/* A subcommand: what reads its command line, runs it, and shows it in --help, in the manual and to a shell. */
struct cli_command {
    const char *name;
    const char *summary;                /* one line of the program's help */
    const char *synopsis;               /* what follows the name */
    const char *text;                   /* paragraphs, a line each */
    cli_example examples[CLI_EXAMPLES]; /* those that are not used are all zero */
    const char *reads, *writes;         /* extensions of files, with blanks between */
    const char *takes;                  /* the letters of its own options */
    const char *leaves;   /* of those of every other command it does not take these; NULL: takes all */
    bool text_with_chars; /* --text may stand beside --chars */
    int fonts_min, fonts_max;
    double at_past;                   /* how far past the ends --at may be */
    bool at_up;                       /* it may be another one upwards */
    int (*run)(cli_options *options); /* an exit code */
};

/* Reads the arguments after the subcommand's name, argv[0]. An exit code, or -1 to run the command; either
 * way the options are to be freed. Wrong usage is said; --help prints the help. */
int options_read(const cli_command *command, int argc, char **argv, cli_options *options);
void options_free(cli_options *options);

/* Fills in options->at and at_up: the --at list, or `steps` (--steps before it) evenly spaced from 0 to 1. DONE or
 * COULD_NOT. */
int options_spread(cli_options *options, int steps);
