/* What blend, strip, sheet and report have in common: two fonts or more, the characters asked for, and a blend that reports
 * on itself. */
#pragma once

#include "characters.h"
#include "glyph_notes.h"
#include "options.h"
#include "progress.h"
#include "source/given_pairs.h"

typedef struct cli_work {
    const cli_options *options;
    mt_font *fonts[MT_VARIABLE_FONTS_MAX]; /* as many as the options have */
    mt_blend *blend;                       /* NULL for a variable font */
    mt_variable *variable;                 /* NULL for a blend */
    mt_cache *cache;                       /* of --cache; NULL without it */
    mt_given_pairs pairs;                  /* of --pairs */
    characters chosen; /* those of --text or --chars that both fonts have; empty without either */
    choices text;      /* of --text, with its line ends */
    progress bar;
    glyph_notes failures, unblended, cut_short, held;
    bool stopped; /* work_made has said why */
} cli_work;

/* Whether the file can be written as far as can be told before the work. DONE or, said, COULD_NOT. */
int output_check(const char *path);
/* The same of the directory that the file will stand in. */
int directory_check(const char *path);

/* Says why a status on a file, a font or a pair came about, and gives COULD_NOT. */
int fail_status(const char *what, mt_status status);

/* Opens a font, with --no-layout without its layout; DONE or, said, COULD_NOT or WRONG_USAGE. */
int font_open(const cli_options *options, const char *spec, mt_font **font);

/* Opens the fonts of the options, with --no-layout without theirs; DONE or, said, COULD_NOT or WRONG_USAGE. Those that were
 * opened are to be closed either way. */
int fonts_open(const cli_options *options, mt_font **fonts);

/* Collects the characters of --text, all of which each of the `count` fonts must have, or those of --chars that all have, in the
 * first a glyph and in the others that or one that is paired with it; and the glyphs that either names, which the first font must
 * have. Those that are left out are told once. `text` has all of --text as it stands there. DONE or, said, COULD_NOT. */
int characters_choose(const cli_options *options, mt_font *const *fonts, int count,
                      const mt_given_pairs *pairs, characters *chosen, choices *text);

/* Opens both fonts and makes the blend, of the characters chosen, for `options->at_count` fonts. DONE or,
 * said, COULD_NOT; either way the work is to be ended. */
int work_begin(const cli_options *options, cli_work *work);
/* The same of all fonts' variable font. */
int work_begin_variable(const cli_options *options, cli_work *work);
/* Says what is to be known before a font goes out, of sources and tables that are left out; and, as soon as that is known, which
 * forms are. MT_NO_MEMORY. */
mt_status work_warn(const cli_work *work);
/* Says which glyphs could not be blended and which had no partner, once all fonts are made. COULD_NOT with --strict and any of them,
 * otherwise DONE. */
int work_failures(cli_work *work);
/* Says what the features.fea of UFOs cannot say, in one line; nothing with --quiet, or where it says all. */
void work_say_unsaid(const cli_options *options, int unsaid);
/* With --verbose, says of how many glyphs of the fonts that were made the topology is proved. */
void work_say_proved(const cli_work *work);
/* The same as what a strip or a sheet calls when its fonts are made; the user data is the work. */
mt_status work_made(void *user);
/* Says why a call that worked on the blend came to nothing, naming the output or the fonts, unless work_made
 * has said it; COULD_NOT. */
int work_fail(cli_work *work, mt_status status);
void work_end(cli_work *work);

/* "A and B", or "A, B and C", as the fonts were given, for messages; cut where it does not fit. */
void work_name(const cli_options *options, char *text, size_t room);
