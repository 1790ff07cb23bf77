/* Morphotype: the fonts between two fonts.
 *
 * Open two fonts, make a blend of them, ask it for a whole font or for one glyph at any T:
 *
 *     mt_font *a, *b;
 *     mt_blend *blend;
 *     mt_params params = mt_params_default();
 *     mt_font_open("Sans.ttf", &a);
 *     mt_font_open("Serif.otf@wght=700", &b);
 *     mt_blend_new(a, b, &params, &blend);
 *     mt_blend_save(blend, 0.5, "Between.ttf");
 *
 * T is 0 for the first font and 1 for the second. (The paper's r is 1 - T.)
 *
 * Every fallible call returns an mt_status and writes its result last, only when it returns MT_OK.
 * A handle that such a call hands out belongs to the caller, who gives it back with the matching close or
 * free. Handles are not locked: use one handle from one thread at a time. */
#ifndef MORPHOTYPE_H
#define MORPHOTYPE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#if defined(__GNUC__)
#define MT_API __attribute__((visibility("default")))
#else
#define MT_API
#endif

#define MORPHOTYPE_VERSION "0.2.0"

/* The version of the library that runs, which is MORPHOTYPE_VERSION of the header that it was built with. */
MT_API const char *mt_version(void);

typedef enum mt_status {
    MT_OK = 0,
    MT_NO_MEMORY,      /* an allocation failed */
    MT_NO_FILE,        /* the file is missing or cannot be read */
    MT_NOT_A_FONT,     /* the file is empty, truncated or in no format that FreeType reads */
    MT_NO_FACE,        /* the collection has no face of that number */
    MT_NO_AXIS,        /* the font has no axis of that tag, or does not vary at all */
    MT_BAD_AXIS,       /* an axis setting is malformed or out of the axis' range */
    MT_NO_OUTLINES,    /* a bitmap font */
    MT_NO_CHARMAP,     /* the font maps no Unicode characters */
    MT_NO_GLYPH,       /* the font has no glyph for that character */
    MT_BAD_GLYPH,      /* the glyph's outline cannot be read */
    MT_NO_COUNTERPART, /* one font draws the character, the other leaves it blank */
    MT_TOO_LARGE,      /* a coordinate or a count is over the limits in limits.h */
    MT_BAD_GEOMETRY,   /* an outline broke an invariant of the engine: a bug, reported instead of drawn */
    MT_NOTHING_SHARED, /* the two fonts have no character in common */
    MT_BAD_PARAMETER,  /* a parameter is out of its documented range */
    MT_CANNOT_WRITE,   /* the output file cannot be written */
    MT_UNKNOWN_FORMAT, /* the output file's extension is none that can be written */
    MT_BAD_HINTS,      /* the hints file is malformed */
    MT_ENDLESS_LOOKUPS, /* lookups of GSUB or GPOS call each other in a circle, or make a text longer without end */
    MT_NO_FEATURE,  /* the font has no substitution feature of that tag */
    MT_BAD_FEATURE, /* a feature setting is malformed */
    MT_BLANK,       /* there is no ink to work with */
    MT_BAD_DRAWING, /* a file is no SVG drawing, or a damaged one */
    MT_TOO_COSTLY,  /* the work or memory that a glyph may take did not do: mt_params.effort */
    MT_BAD_MESH,    /* a file is no mesh, or a damaged one */
    MT_NOT_SOLID,   /* a mesh is not closed or not oriented, crosses itself, or is empty */
    MT_STOPPED,     /* mt_blend_stop or mt_variable_stop was called */
} mt_status;

/* One line of English, without a full stop; static storage. */
MT_API const char *mt_status_text(mt_status status);

/* ---- fonts --------------------------------------------------------------------------------------------- */

typedef struct mt_font mt_font;

/* Opens FILE[#FACE][@AXIS=VALUE,…][:FEATURE[=VALUE],…]: face FACE of a collection, counted from 0, at a place of a variable
 * font in user coordinates; its characters lead to the glyphs that the features of GSUB make of theirs, one by one. Reads TrueType, CFF, CFF2, Type 1, collections, WOFF and WOFF2, through FreeType. */
MT_API mt_status mt_font_open(const char *spec, mt_font **font);
/* The same of the bytes of such a file, which are copied. `name` stands for the font in warnings and need not be a file's; `choice` is what a
 * spec has after FILE: "#1@wght=650". Either may be NULL. Kerning beside a Type 1 font is not looked for. MT_BAD_PARAMETER for a
 * choice that begins with none of #, @ and :. */
MT_API mt_status mt_font_open_memory(const uint8_t *bytes, size_t length, const char *name,
                                     const char *choice, mt_font **font);
MT_API void mt_font_close(mt_font *font); /* NULL is fine */

/* From now on the font is as one without layout: no GSUB, GPOS, GDEF and kern, no kerning beside it, and no glyphs but those of
 * its characters. What features of its spec made of these stays. */
MT_API void mt_font_drop_layout(mt_font *font);

/* The family name and the style name, UTF-8; belong to the font. */
MT_API const char *mt_font_family(const mt_font *font);
MT_API const char *mt_font_style(const mt_font *font);

/* The smallest code point that the font maps and that is at least `from`; false when there is none. */
MT_API bool mt_font_next_char(const mt_font *font, uint32_t from, uint32_t *code_point);

/* The number of the glyph that a name stands for: the font's own name for it; gid12 for number 12; uni0661 for a character's; f_i
 * for the ligature of f and i. MT_NO_GLYPH, MT_ENDLESS_LOOKUPS, MT_NO_MEMORY. */
MT_API mt_status mt_font_glyph_of_name(mt_font *font, const char *name, uint32_t *glyph);

/* What draws an outline. Contours are closed: `close` comes after the last curve, which ends where the contour began. */
typedef struct mt_draw {
    void (*move_to)(double x, double y, void *user);
    void (*line_to)(double x, double y, void *user);
    void (*quadratic_to)(double cx, double cy, double x, double y, void *user);
    void (*close)(void *user);
    /* Only fonts' own outlines have cubic curves: NULL where none are drawn. */
    void (*cubic_to)(double c1x, double c1y, double c2x, double c2y, double x, double y, void *user);
} mt_draw;

/* The number of the glyph that a character leads to, by the features of the font's spec too; in a symbol font, for a code up to U+00FF that is
 * not mapped, that of U+F000 and the code, as HarfBuzz and Windows have it; 0 where there is none. */
MT_API uint32_t mt_font_glyph(const mt_font *font, uint32_t code_point);
MT_API int mt_font_units_per_em(const mt_font *font);
/* Draws a glyph as the font has it, unhinted, references resolved and overlaps and all, in font units; y runs upwards. MT_NO_GLYPH for a number that the
 * font has not, MT_BAD_GLYPH, MT_TOO_LARGE, MT_BAD_PARAMETER for cubic curves without a cubic_to, MT_NO_MEMORY. */
MT_API mt_status mt_font_draw(mt_font *font, uint32_t glyph, const mt_draw *draw, void *user,
                              double *advance);

/* ---- caches -------------------------------------------------------------------------------------------- */

/* Glyphs that were prepared before, in this run or another one, in a directory: each is found by all that it depends on, which is both
 * drawings, hints, parameters and the version of the engine. So what comes out is the same, and only sooner. Several
 * processes may have one directory at once, and several threads and blends a handle. What is damaged there is as none; but a cache is
 * trusted as fonts are not: glyphs are as whoever may write to it has them. */
typedef struct mt_cache mt_cache;

#define MT_CACHE_BYTES ((uint64_t)4 << 30)
#define MT_CACHE_BYTES_LEAST ((uint64_t)1 << 20)

/* Opens a directory, which is made where none is. It has `most` bytes at most; 0 means MT_CACHE_BYTES. When there would be more, those
 * glyphs go that were used longest ago. MT_BAD_PARAMETER under MT_CACHE_BYTES_LEAST, MT_CANNOT_WRITE (errno says why), MT_NO_MEMORY. */
MT_API mt_status mt_cache_open(const char *directory, uint64_t most, mt_cache **cache);
MT_API void mt_cache_close(mt_cache *cache); /* NULL is fine */

/* What has been asked of it since it was opened: glyphs of two fonts that were there, that were made, and of these such as
 * could not be kept. */
typedef struct mt_cache_counts {
    int found, made, lost;
} mt_cache_counts;
MT_API mt_cache_counts mt_cache_count(const mt_cache *cache);

/* ---- blends -------------------------------------------------------------------------------------------- */

typedef enum mt_rotation {
    MT_ROTATION_NONE,  /* the paper's formula (4) */
    MT_ROTATION_GIVEN, /* formula (5) with `degrees` */
    MT_ROTATION_FOUND, /* formula (5), the angle found for each glyph from its components' principal axes */
} mt_rotation;

/* Glyphs are also compared with this taken off, since an upright and a slanted drawing look less alike than they are. */
typedef enum mt_slant {
    MT_SLANT_FOUND, /* measured on the stems of both fonts */
    MT_SLANT_GIVEN, /* `lean` */
} mt_slant;

typedef enum mt_method {
    MT_METHOD_JOINT, /* matched components are aligned along their boundaries; the paper's links for the rest
                      */
    MT_METHOD_PAPER, /* the paper's own mapping throughout */
} mt_method;

typedef struct mt_params {
    mt_method method;
    double tolerance;  /* flattening error bound, 1/1000 em, 0.05 … 10 */
    double fit;        /* curve fitting error bound, 1/1000 em, 0.05 … 10 */
    double weights[3]; /* w1 (place), w2 (area), w3 (box) of section 2.2.1; each 0 … 1, sum 1 */
    int rounds;        /* of the relaxation, formulas (1) and (2); 0 … 1000 */
    double threshold; /* T of section 2.2.1: matches under it, relative to the best, count as none; 0 … 1 */
    bool one_scale; /* formula (3) as printed: both axes by the longer side of the box, not each by its own */
    mt_rotation rotation;
    double degrees; /* q of formula (5), anticlockwise, -360 … 360; read with MT_ROTATION_GIVEN */
    mt_slant slant;
    double lean; /* by how many degrees B leans to the right of A, -45 … 45; read with MT_SLANT_GIVEN */
    int threads; /* that work on a font; 0: as many as the machine has cores */
    double
        effort; /* how much work and memory a glyph may take, 0.01 … 100; 1: about two seconds, and 200 MB */
} mt_params;

MT_API mt_params mt_params_default(void);

typedef struct mt_blend mt_blend;

/* A blend keeps using both fonts: close them after it. `params` is copied. */
MT_API mt_status mt_blend_new(mt_font *a, mt_font *b, const mt_params *params, mt_blend **blend);
MT_API void mt_blend_free(mt_blend *blend); /* NULL is fine */

/* Called once for each glyph that cannot be blended and takes the nearer font's own outline instead: with its character, or
 * the one that it is a form of, or 0 where there is none. */
typedef void (*mt_glyph_failed)(uint32_t code_point, mt_status why, void *user);
/* Called after each glyph while a font is made: `done` of `all`, which grows by one from call to call. */
typedef void (*mt_progress)(int done, int all, void *user);
MT_API void mt_blend_on_failure(mt_blend *blend, mt_glyph_failed call, void *user);

/* What is told of a glyph. */
typedef struct mt_glyph_note {
    uint32_t code_point; /* the character that leads to it, or that it is a form of; 0: none */
    bool is_form;        /* no character leads to the glyph itself */
    uint32_t glyph;      /* its number in the first font */
    const char *name;    /* its name there, which lasts as long as the call; NULL: none */
    int font;            /* the font that is the reason, counted from 0; -1: no single one */
    mt_status why;
    double t, up;           /* with mt_blend_on_held, where it stays: T across, and upwards … */
    double asked, asked_up; /* … and where it was to be */
} mt_glyph_note;
typedef void (*mt_glyph_noted)(const mt_glyph_note *note, void *user);
/* The same as mt_blend_on_failure, and besides it, with all that is known of the glyph. */
MT_API void mt_blend_on_glyph_failure(mt_blend *blend, mt_glyph_noted call, void *user);
/* Called once for each glyph that is the first font's own because the second has none for it (MT_NO_GLYPH). */
MT_API void mt_blend_on_unblended(mt_blend *blend, mt_glyph_noted call, void *user);
/* Called once for each glyph whose effort was spent before all ways were tried (MT_TOO_COSTLY): it is blended by the best of those that were. */
MT_API void mt_blend_on_cut_short(mt_blend *blend, mt_glyph_noted call, void *user);
/* Called for each glyph that stays where its topology ends, note.t and note.up, short of a place that was asked for: outside 0 … 1, or with
 * another T upwards than across (MT_TOO_LARGE). */
MT_API void mt_blend_on_held(mt_blend *blend, mt_glyph_noted call, void *user);
MT_API void mt_blend_on_progress(mt_blend *blend, mt_progress call, void *user);

/* Stops the work: what is under way for the blend ends as soon as it can, and what is asked of it later ends at once, with MT_STOPPED; nothing is
 * written. From any thread, and from the calls above. With false it works again, once nothing is under way. */
MT_API void mt_blend_stop(mt_blend *blend, bool stop);

/* Names the fonts that follow: the family NAME in place of a name made from both; NULL goes back to that. */
MT_API mt_status mt_blend_set_family(mt_blend *blend, const char *name);

/* The styles of the fonts that follow, names[i] for the font at the i-th T, in place of those made of T; count 0 goes back to
 * these. A name of a weight or a width (SemiBold Italic, Condensed Bold) is the font's weight and width too, and one that
 * ends in Regular, Bold, Italic or Bold Italic is linked as that. */
MT_API mt_status mt_blend_set_styles(mt_blend *blend, const char *const *names, int count);

/* Called with a line of English, without a full stop; it lasts as long as the call. */
typedef void (*mt_warning)(const char *line, void *user);
/* What to know before a font of this blend goes out, a call for each: what a source's embedding bits or licence restrict,
 * a family name given that has a name in it which a source keeps for itself, tables that are left out. It is no judgement
 * on rights, and silence is none. MT_NO_MEMORY. */
MT_API mt_status mt_blend_warnings(const mt_blend *blend, mt_warning call, void *user);

/* Keeps only these characters (code points in any order), for a strip or a subset, and the forms that shaping makes of them
 * by itself: joined letters, ligatures, but no small capitals; count 0 means all shared ones and all forms. */
MT_API mt_status mt_blend_set_chars(mt_blend *blend, const uint32_t *code_points, int count);
/* Glyphs that go together, before all others: `count` rows of a glyph of the first font and one of the second, by their numbers
 * in the fonts, in any order. The characters of the first font that lead there are then characters of both. They count for hints
 * that are set later. Copied; count 0 means none. MT_BAD_PARAMETER for two rows with the same glyph of the first font, for
 * glyph 0, and for a glyph that a font has not; MT_NO_MEMORY. */
MT_API mt_status mt_blend_set_pairs(mt_blend *blend, const uint32_t *glyphs, int count);
/* Whether the forms are kept, too, that text has to ask for by a feature, whatever characters are set. */
MT_API void mt_blend_set_alternates(mt_blend *blend, bool alternates);
/* Called when fonts of set characters leave such forms out: how many glyphs, and the tags of the features that lead to them, with
 * commas between; they last as long as the call. */
typedef void (*mt_left_out_noted)(int glyphs, const char *features, void *user);
MT_API void mt_blend_on_left_out(mt_blend *blend, mt_left_out_noted call, void *user);

/* Keeps these glyphs, by their numbers in the first font, with the characters that lead to them and with what its
 * substitutions make of them, besides the characters of mt_blend_set_chars; with neither, all. A glyph is paired as in a font of all
 * characters. Copied; count 0 means none. MT_BAD_PARAMETER for a number that the font has not, MT_NO_MEMORY. */
MT_API mt_status mt_blend_set_glyph_numbers(mt_blend *blend, const uint32_t *glyphs, int count);

typedef enum mt_glyph_set {
    MT_GLYPHS_BOTH,  /* those that both fonts have */
    MT_GLYPHS_FIRST, /* all of the first font's; what the second has not stays as it is */
} mt_glyph_set;

/* Which glyphs the fonts that follow have; both fonts' without this. */
MT_API void mt_blend_set_glyphs(mt_blend *blend, mt_glyph_set set);

typedef enum mt_curves {
    MT_CURVES_CUBIC,     /* as most editors draw */
    MT_CURVES_QUADRATIC, /* as in TrueType */
} mt_curves;

/* The curves of a UFO's outlines; cubic without this. Other formats have quadratic ones. */
MT_API void mt_blend_set_curves(mt_blend *blend, mt_curves curves);
/* Glyphs are taken from the cache, and kept there; the blend keeps using it: close it after the blend. NULL means none. */
MT_API void mt_blend_set_cache(mt_blend *blend, mt_cache *cache);
/* T of heights: the font at the i-th T is there across alone (x, advances, widths), and at t[i] upwards (y, heights), so that weight
 * and width come apart. As many as the fonts that follow, which are refused otherwise (MT_BAD_PARAMETER), as they are with a
 * rotation; each as T. A glyph stays as near to such a place as it has the components and holes that its ends have. Copied; count 0: as
 * across, as it is without this. MT_NO_MEMORY. */
MT_API mt_status mt_blend_set_heights(mt_blend *blend, const double *t, int count);
/* Places of glyphs by themselves, by their numbers in the first font, in all fonts that follow: at t[i] across and at heights[i] upwards, or with
 * NULL at t[i] too. Outlines, advances, marks and adjustments are there; the kerning of two glyphs is at the mean of their places; an accented letter
 * is at its own place, not at that of its letter. Copied; count 0 means none. MT_BAD_PARAMETER for a number that the font
 * has not and for one that is there twice, MT_NO_MEMORY; fonts are refused for places that T may not have. */
MT_API mt_status mt_blend_set_places(mt_blend *blend, const uint32_t *glyphs, const double *t,
                                     const double *heights, int count);
/* How many glyphs of the last fonts made are the first font's own, because the second has none for them. */
MT_API int mt_blend_unblended(const mt_blend *blend);

/* The font at t as TrueType bytes; give them back with mt_bytes_free. t is 0 … 1, or goes past an end: down to -1, up to 2. There each glyph
 * goes on as it came, as far as it keeps the components and holes of that end, and stays there. */
MT_API mt_status mt_blend_font(mt_blend *blend, double t, uint8_t **bytes, size_t *length);
/* Fonts at `count` places in one go, for little more than the price of one: each glyph is read, cut and
 * matched once. Fills bytes[count] and lengths[count], or none of them. */
MT_API mt_status mt_blend_fonts(mt_blend *blend, const double *t, int count, uint8_t **bytes,
                                size_t *lengths);
/* The font at t, written to `path` whole or not at all, in the format of its extension: .ttf, .woff2, or .ufo, which is
 * a directory and takes the place of another UFO only. MT_UNKNOWN_FORMAT for any other, MT_CANNOT_WRITE. */
MT_API mt_status mt_blend_save(mt_blend *blend, double t, const char *path);
/* Fonts at `count` places in one go, paths[i] for t[i]: all of them or none. */
MT_API mt_status mt_blend_save_fonts(mt_blend *blend, const double *t, int count, const char *const *paths);
MT_API void mt_bytes_free(uint8_t *bytes);

/* One glyph at t (0 … 1), in font units of mt_blend_units_per_em; a contour has lines and quadratic curves. MT_NO_GLYPH where a font lacks it,
 * MT_BAD_PARAMETER, MT_NO_MEMORY, and why it cannot be blended; nothing is then drawn. */
MT_API mt_status mt_blend_glyph(mt_blend *blend, uint32_t code_point, double t, const mt_draw *draw,
                                void *user, double *advance);
/* The same of a glyph by its number in the first font, with the glyph that a blend of all characters pairs with it. */
MT_API mt_status mt_blend_glyph_numbered(mt_blend *blend, uint32_t glyph, double t, const mt_draw *draw,
                                         void *user, double *advance);
MT_API int mt_blend_units_per_em(const mt_blend *blend);

/* ---- judging ------------------------------------------------------------------------------------------- */

/* What a picture is of: a character, or a glyph of the first font. */
typedef struct mt_choice {
    uint32_t code_point; /* of a character */
    const char *name;    /* of a glyph, as it is to be shown, without a slash; NULL: it is a character */
    uint32_t glyph;      /* its number in the first font */
} mt_choice;

/* What a picture may be asked for; beyond it is MT_BAD_PARAMETER. */
#define MT_STEPS_MAX 1000
#define MT_SIZE_MIN 4.0 /* picture units an em, or a cell */
#define MT_SIZE_MAX 8192.0
#define MT_TEXT_MAX (1 << 20) /* characters */

/* Called once all fonts are made and before anything is drawn, unless it is NULL; what it returns other than
 * MT_OK ends the call, which then returns that. */
typedef mt_status (*mt_fonts_made)(void *user);

typedef struct mt_strip {
    const mt_choice *text; /* of `length`; the character '\n' starts a new line */
    int length;
    const double *at; /* T of each step, as many as step_count */
    int step_count;
    double size; /* pixels (or points, in SVG and PDF) an em */
    bool labels; /* T under each step */
    mt_fonts_made made;
    void *user;
} mt_strip;

/* A text at several T, in the format of the extension: .png, .svg or .pdf. One row a line of text, one column a step; a text wider than three em gives one row a step instead. A named glyph is set at its
 * place as it is, whatever stands beside it. Sets the blend's characters and glyphs to those of the text. MT_NO_GLYPH when one of them is in one font only,
 * MT_UNKNOWN_FORMAT, MT_TOO_LARGE for a picture of more than 32 767 pixels a side, MT_CANNOT_WRITE, and what
 * mt_blend_font gives. */
MT_API mt_status mt_strip_save(mt_blend *blend, const mt_strip *strip, const char *path);

typedef struct mt_sheet {
    const mt_choice *choices; /* one row each */
    int count;
    const double *at; /* T of each column */
    int step_count;
    double size;                   /* of a cell, pixels or points */
    int rows_per_page;             /* 0: what fits a page of A4's proportions */
    const char *title_a, *title_b; /* names of the two fonts */
    mt_fonts_made made;
    void *user;
} mt_sheet;

/* A grid of characters or glyphs × steps, with code points or names, a heading and page numbers. PDF takes all pages; of PNG and
 * SVG each page is a file of its own, NAME-2.png and so on after the first. Sets the blend's characters and
 * glyphs to those of the sheet; errors as for the strip. */
MT_API mt_status mt_sheet_save(mt_blend *blend, const mt_sheet *sheet, const char *path);

/* Every glyph of a blend measured at seventeen places, and those flagged that an eye would stumble over. */
typedef struct mt_report mt_report;

/* Why a glyph is flagged; bits. */
typedef enum mt_report_flag {
    MT_FLAG_FAILED = 1,     /* it cannot be blended */
    MT_FLAG_COMPONENTS = 2, /* a count is out of the ends' range at some place */
    MT_FLAG_HOLES = 4,
    MT_FLAG_STRAYS = 8, /* ink is far off the way between the ends */
    MT_FLAG_CLOTS = 16, /* a stroke is thicker than any of the ends' */
    MT_FLAG_INK = 32,   /* the area of ink is out of the ends' range */
    MT_FLAG_ALL = 63,
} mt_report_flag;

typedef enum mt_report_format { MT_REPORT_HTML, MT_REPORT_JSON } mt_report_format;

/* Measures each glyph that the blend has: of all characters that both fonts have, or of those set. Characters that lead to the same two glyphs are
 * one. Glyphs that fail are in the report. The report keeps using the blend: free it first. MT_NOTHING_SHARED, MT_TOO_LARGE, MT_STOPPED,
 * MT_NO_MEMORY. */
MT_API mt_status mt_report_new(mt_blend *blend, mt_report **report);
MT_API void mt_report_free(mt_report *report);       /* NULL is fine */
MT_API int mt_report_count(const mt_report *report); /* glyphs measured */
/* How many of them have one of these flags. */
MT_API int mt_report_flagged(const mt_report *report, unsigned flags);
/* A flag's name, such as "strays"; static storage. */
MT_API const char *mt_report_flag_name(mt_report_flag flag);
/* The report as a page with strips, or as data, whose schema is in docs/guide.md; give the bytes back with mt_bytes_free. MT_STOPPED,
 * MT_NO_MEMORY. */
MT_API mt_status mt_report_bytes(const mt_report *report, mt_report_format format, uint8_t **bytes,
                                 size_t *length);
/* The same written to `path`, .html or .json, whole or not at all. MT_UNKNOWN_FORMAT, MT_CANNOT_WRITE. */
MT_API mt_status mt_report_save(const mt_report *report, const char *path);

/* ---- variable fonts ------------------------------------------------------------------------------------ */

/* One font that varies along an axis, by default MORF from 0 (the first font, and the default) to 100 (the last), with the fonts in
 * between at even distances. Where the outlines of two neighbours need not be compatible, its contours are: each moves on
 * straight lines. */
typedef struct mt_variable mt_variable;

enum { MT_VARIABLE_FONTS_MAX = 64 };

/* Of 2 … MT_VARIABLE_FONTS_MAX fonts, which it keeps using: close them after it. `params` is copied. */
MT_API mt_status mt_variable_new(mt_font *const *fonts, int count, const mt_params *params,
                                 mt_variable **variable);
MT_API void mt_variable_free(mt_variable *variable); /* NULL is fine */

/* As the calls for a blend. A glyph that cannot be blended is the nearer font's own, switched over half-way. The glyphs are
 * those that all of the fonts have, or the first font's. Hints are for each two neighbours that have their characters. */
MT_API void mt_variable_on_failure(mt_variable *variable, mt_glyph_failed call, void *user);
MT_API void mt_variable_on_glyph_failure(mt_variable *variable, mt_glyph_noted call, void *user);
MT_API void mt_variable_on_unblended(mt_variable *variable, mt_glyph_noted call, void *user);
MT_API void mt_variable_on_cut_short(mt_variable *variable, mt_glyph_noted call, void *user);
MT_API void mt_variable_on_progress(mt_variable *variable, mt_progress call, void *user);
MT_API void mt_variable_stop(mt_variable *variable, bool stop);
MT_API mt_status mt_variable_set_family(mt_variable *variable, const char *name);
/* Of the font as it stands without a setting; NULL goes back to the name of the first place on its axis. */
MT_API mt_status mt_variable_set_style(mt_variable *variable, const char *name);
MT_API mt_status mt_variable_warnings(const mt_variable *variable, mt_warning call, void *user);
MT_API mt_status mt_variable_set_chars(mt_variable *variable, const uint32_t *code_points, int count);
MT_API mt_status mt_variable_set_pairs(mt_variable *variable, const uint32_t *glyphs,
                                       int count); /* a row has a glyph of each font */
MT_API void mt_variable_set_alternates(mt_variable *variable, bool alternates);
MT_API void mt_variable_on_left_out(mt_variable *variable, mt_left_out_noted call, void *user);
MT_API mt_status mt_variable_set_glyph_numbers(mt_variable *variable, const uint32_t *glyphs, int count);
MT_API void mt_variable_set_glyphs(mt_variable *variable, mt_glyph_set set);
/* The curves of a designspace's masters. */
MT_API void mt_variable_set_curves(mt_variable *variable, mt_curves curves);
MT_API void mt_variable_set_cache(mt_variable *variable, mt_cache *cache);
MT_API int mt_variable_unblended(const mt_variable *variable);

/* Another axis than MORF: its tag, of four letters, and what users set for the first font and for the last, which may be
 * less. A registered tag (wght, wdth, slnt, ital, opsz) brings its name, the names of its places and what the tables say of
 * weight, width or slant; any other is of capitals and digits. MT_BAD_PARAMETER. */
MT_API mt_status mt_variable_set_axis(mt_variable *variable, const char *tag, double from, double to);

/* The fonts as a family: each at a value of its own on the axis, as many as there are fonts, ascending; 0.01 is always enough. Without a setting
 * the font stands at the plain one (a weight of 400, a width of 100, a slant of 0) where a font has that, otherwise at the first. Its named
 * places are the fonts', by their names, and its family is what their families' names have in common, unless one is set. It takes the place
 * of mt_variable_set_axis, has the same tags, and no map with it. Copied. MT_BAD_PARAMETER, MT_NO_MEMORY. */
MT_API mt_status mt_variable_set_stops(mt_variable *variable, const char *tag, const double *values);
/* Whether the family has an italic file besides this upright one, which the font's table of styles then links. A family of italic fonts
 * says by itself that it is one. */
MT_API void mt_variable_set_italic(mt_variable *variable, bool has_italic);

/* How far the font gets where users set its axis: at values[i] as far as it is at places[i] without a map, in between on
 * straight lines. Both are from 0, the first font, to 100, the last, whatever the axis; the ends, 0 at 0 and 100 at 100, go without saying. Values ascend, of which 0.01 is
 * always enough (rounded to 2^-14 of the axis they must differ); places do not descend. The fonts have it as 'avar', a
 * designspace as its axis' map. Both arrays are copied; count 0 means no map, as it is without this call. MT_BAD_PARAMETER,
 * MT_NO_MEMORY; the map is then what it was. */
MT_API mt_status mt_variable_set_map(mt_variable *variable, const double *values, const double *places,
                                     int count);

/* The font as TrueType bytes; give them back with mt_bytes_free. */
MT_API mt_status mt_variable_font(mt_variable *variable, uint8_t **bytes, size_t *length);
/* Written to `path` whole or not at all, in the format of its extension: .ttf, .woff2 or .designspace, the last for
 * masters with the same points, as UFOs in the folder NAME-masters beside NAME.designspace. MT_UNKNOWN_FORMAT,
 * MT_CANNOT_WRITE. */
MT_API mt_status mt_variable_save(mt_variable *variable, const char *path);

typedef struct mt_specimen_request {
    mt_variable *variable; /* with its settings */
    const char *text;      /* that the page begins with, UTF-8; NULL: a sample */
    mt_fonts_made made;    /* called when the font is made, unless NULL */
    void *user;
} mt_specimen_request;

/* Makes the font, and a page of HTML to try it on, which has it in it and fetches nothing; written to `path` whole or not at all. What
 * mt_variable_save gives. */
MT_API mt_status mt_specimen_save(const mt_specimen_request *request, const char *path);

/* ---- drawings that move -------------------------------------------------------------------------------- */

/* A drawing from memory: closed contours of lines and of quadratic and cubic Bézier curves, filled where they go around a place, in
 * either direction (nonzero). y runs upwards as in a font, or downwards in both drawings. */
typedef struct mt_path mt_path;

/* `em` is about the drawing's height, in its own units, 10^-6 … 10^9: tolerances are thousandths of it. MT_BAD_PARAMETER,
 * MT_NO_MEMORY. */
MT_API mt_status mt_path_new(double em, mt_path **path);
MT_API void mt_path_free(mt_path *path); /* NULL is fine */
/* A contour begins here; the one before it is closed. MT_BAD_PARAMETER for what is no number, MT_TOO_LARGE for places over 32 em
 * from the origin and for a million segments, MT_NO_MEMORY; the drawing then stays as it was, but that the one before may be closed. */
MT_API mt_status mt_path_move_to(mt_path *path, double x, double y);
/* The contour goes on. The same, and MT_BAD_PARAMETER where none has begun. */
MT_API mt_status mt_path_line_to(mt_path *path, double x, double y);
MT_API mt_status mt_path_quadratic_to(mt_path *path, double cx, double cy, double x, double y);
MT_API mt_status mt_path_cubic_to(mt_path *path, double c1x, double c1y, double c2x, double c2y, double x,
                                  double y);

/* Contours that move from one drawing to another: as many, of the same segments, at every place. */
typedef struct mt_moving mt_moving;

/* Keeps neither drawing, nor `params`. MT_BLANK when one has no ink, MT_BAD_PARAMETER, MT_TOO_LARGE, MT_BAD_GEOMETRY, MT_NO_MEMORY. */
MT_API mt_status mt_moving_new(const mt_path *a, const mt_path *b, const mt_params *params,
                               mt_moving **moving);
MT_API void mt_moving_free(mt_moving *moving); /* NULL is fine */
/* Draws the contours at t, 0 … 1, in the units of the first drawing; where they overlap, ink is ink (nonzero). With every t the same
 * calls come in the same order, and without rotation each point moves on a straight line, or on two that meet at 0.5. MT_BAD_PARAMETER,
 * MT_NO_MEMORY. */
MT_API mt_status mt_moving_draw(const mt_moving *moving, double t, const mt_draw *draw, void *user);

/* ---- solids -------------------------------------------------------------------------------------------- */

/* A place or a direction in space. */
typedef struct mt_vector3 {
    double x, y, z;
} mt_vector3;

typedef struct mt_triangle {
    int at[3]; /* points of the mesh, anticlockwise as seen from outside */
} mt_triangle;

/* Triangles in space, in the units of the file that they come from. */
typedef struct mt_mesh {
    int n_points, n_triangles;
    mt_vector3 *points;
    mt_triangle *triangles;
} mt_mesh;

/* What is wrong with a mesh, with its place. */
typedef struct mt_mesh_fault {
    char line[256]; /* one line of English, without a full stop; "": nothing more is known than the status */
} mt_mesh_fault;

/* The surface of a solid: closed, with every edge between two triangles, which face the same side; not crossing or touching itself;
 * in one part or in several, with or without hollows. */
typedef struct mt_solid mt_solid;

/* Reads .obj, .stl, .ply, .off and .glb. Points at one place are welded, polygons cut into triangles, those without an area left out, and
 * surfaces that face inwards turned over. `fault`, unless NULL, is filled in where it returns MT_BAD_MESH, MT_NOT_SOLID or MT_TOO_LARGE. Also
 * MT_NO_FILE, MT_UNKNOWN_FORMAT, MT_NO_MEMORY. */
MT_API mt_status mt_solid_open(const char *path, mt_solid **solid, mt_mesh_fault *fault);
/* The same of a mesh from memory, which is copied. */
MT_API mt_status mt_solid_new(const mt_mesh *mesh, mt_solid **solid, mt_mesh_fault *fault);
MT_API void mt_solid_free(mt_solid *solid); /* NULL is fine */
/* Its mesh, which belongs to it. */
MT_API const mt_mesh *mt_solid_mesh(const mt_solid *solid);

#define MT_SOLID_DEPTH_MIN 0.001
#define MT_SOLID_DEPTH_MAX 0.5

typedef struct mt_solid_params {
    mt_method method; /* MT_METHOD_PAPER: exact convex pieces, Definition 1 */
    double depth;     /* how far a piece's hull may leave the piece, as a share of the solid's diagonal */
    mt_vector3 axis;  /* formula (5): B is turned about it; of any length but 0 */
    double degrees; /* by this angle, -360 … 360, anticlockwise as the axis points at the eye; 0 for none */
} mt_solid_params;

MT_API mt_solid_params mt_solid_params_default(void);

/* What is between two solids. */
typedef struct mt_solid_blend mt_solid_blend;

/* Keeps neither solid. MT_BAD_PARAMETER, MT_BAD_GEOMETRY, MT_NO_MEMORY. */
MT_API mt_status mt_solid_blend_new(const mt_solid *a, const mt_solid *b, const mt_solid_params *params,
                                    mt_solid_blend **blend);
MT_API void mt_solid_blend_free(mt_solid_blend *blend); /* NULL is fine */

/* The solid at t, 0 … 1: the sources themselves at 0 and 1; in between closed meshes that may overlap, and whose union it is. Give it
 * back with mt_mesh_free. MT_BAD_PARAMETER, MT_NO_MEMORY. */
MT_API mt_status mt_solid_blend_mesh(const mt_solid_blend *blend, double t, mt_mesh *mesh);
MT_API void mt_mesh_free(mt_mesh *mesh);
/* The same, written to `path` whole or not at all, in the format of its extension, which are those that are read. MT_UNKNOWN_FORMAT,
 * MT_CANNOT_WRITE. */
MT_API mt_status mt_solid_blend_save(const mt_solid_blend *blend, double t, const char *path);
/* The whole way as one .glb: a mesh whose morph target is the second solid, with an animation of the target's weight that takes `duration`
 * seconds, 0.01 … 600, and with `yoyo` goes back again. MT_UNKNOWN_FORMAT, MT_BAD_PARAMETER, MT_CANNOT_WRITE, MT_TOO_LARGE, MT_NO_MEMORY. */
MT_API mt_status mt_solid_blend_save_morph(const mt_solid_blend *blend, double duration, bool yoyo,
                                           const char *path);

/* ---- hints --------------------------------------------------------------------------------------------- */

/* What a person has decided, by characters or glyphs: which component goes with which, and which place on the boundary
 * with which. docs/guide.md has the format of the file. */
typedef struct mt_hint_table mt_hint_table;

typedef struct mt_hint_error {
    int line;           /* from 1 */
    const char *reason; /* one line of English, without a full stop; static storage */
} mt_hint_error;

/* Reads a file, or a text in memory, which need not end with a NUL. MT_BAD_HINTS, with `error` (unless NULL)
 * filled in, MT_NO_FILE, MT_TOO_LARGE, MT_NO_MEMORY. */
MT_API mt_status mt_hint_table_open(const char *path, mt_hint_table **table, mt_hint_error *error);
MT_API mt_status mt_hint_table_read(const char *text, size_t length, mt_hint_table **table,
                                    mt_hint_error *error);
MT_API void mt_hint_table_free(mt_hint_table *table); /* NULL is fine */

/* The smallest code point that has hints and that is at least `from`; false when there is none. */
MT_API bool mt_hint_table_next_char(const mt_hint_table *table, uint32_t from, uint32_t *code_point);

/* The blend goes by these hints from now on; NULL: by none. The table is copied. Hints for characters that the
 * fonts do not share are passed over, and those for glyphs without a partner. Characters that lead to the same two glyphs have their
 * hints in common. MT_BAD_HINTS, with `error` (unless NULL) filled in, for a place over 32 em from the origin, for more than
 * 256 hints for one glyph and for a name that no glyph of the first font has; MT_ENDLESS_LOOKUPS where glyphs have names; MT_NO_MEMORY. The blend then goes by the hints it had. */
MT_API mt_status mt_blend_set_hints(mt_blend *blend, const mt_hint_table *table, mt_hint_error *error);
MT_API mt_status mt_variable_set_hints(mt_variable *variable, const mt_hint_table *table,
                                       mt_hint_error *error);

#ifdef __cplusplus
}
#endif

#endif
