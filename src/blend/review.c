/* Warnings of two sources: each kind of them by itself, in lines of English. */
#include "blend/review.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "math/table/open.h"
#include "sfnt/sfnt.h"
#include "source/reserved.h"

typedef struct mt_reviewer {
    const char *family;
    mt_warning call;
    void *user;
} mt_reviewer;

/* ---- lines --------------------------------------------------------------------------------------------- */

typedef struct mt_notice {
    char text[1024];
    size_t length;
} mt_notice;

/* As printf, at the end of the line; what does not fit is cut off. */
static void add(mt_notice *line, const char *format, ...) {
    va_list list;
    va_start(list, format);
    vsnprintf(line->text + line->length, sizeof line->text - line->length, format, list);
    line->length += strlen(line->text + line->length);
    va_end(list);
}

static void say(const mt_reviewer *reviewer, const mt_notice *line) {
    reviewer->call(line->text, reviewer->user);
}

/* ---- rights -------------------------------------------------------------------------------------------- */

/* The bits of OS/2 fsType that a blend has to mind (OpenType spec, "OS/2": fsType). */
static void review_embedding(const mt_reviewer *reviewer, const mt_font *font) {
    static const struct {
        unsigned bit;
        const char *meaning;
    } restrictions[] = {
        {2, "restricted: not to be embedded or changed without its owner's permission"},
        {4, "preview and print embedding only"},
        {0x100, "no subsetting"},
        {0x200, "bitmap embedding only"},
    };
    mt_notice line = {0};
    unsigned embedding = mt_font_embedding(font);
    for (size_t i = 0; i < sizeof restrictions / sizeof *restrictions; i++) {
        if (!(embedding & restrictions[i].bit)) continue;
        if (line.length == 0)
            add(&line, "%s restricts its embedding (OS/2 fsType): ", mt_font_spec(font));
        else
            add(&line, "; ");
        add(&line, "%s", restrictions[i].meaning);
    }
    if (line.length > 0) say(reviewer, &line);
}

/* What licences say that forbid a changed font. Licences that permit one do not say it. */
static const char *find_restriction(const char *text) {
    static const char *const phrases[] = {
        "may not be modified",   "must not be modified",
        "cannot be modified",    "not be altered",
        "may not modify",        "may not alter",
        "not to modify",         "not to alter",
        "no derivative",         "may not create derivative",
        "modification is not",   "modifications are not",
        "not be used to create", "noderiv",
        "not adapt, translate",  "not be converted",
    };
    const char *first = NULL;
    for (size_t i = 0; i < sizeof phrases / sizeof *phrases; i++) {
        const char *found = text ? mt_find_phrase(text, phrases[i]) : NULL;
        if (found && (!first || found < first)) first = found;
    }
    return first;
}

/* Quotes the licence from the word before the phrase on, so that a person can judge. */
static void review_license(const mt_reviewer *reviewer, const mt_font *font) {
    enum { QUOTE_MOST = 100 };
    mt_notice line = {0};
    mt_names names;
    mt_font_names(font, &names);
    const char *text = names.license, *found = find_restriction(text);
    if (!found) found = find_restriction(text = names.copyright);
    if (!found) return;
    int length = (int)strcspn(found, ".");
    if (length > QUOTE_MOST) length = QUOTE_MOST;
    while (length > 0 && ((unsigned char)found[length] & 0xC0) == 0x80) length--;
    add(&line, "%s may not permit a changed font; its licence has: “… %.*s …”", mt_font_spec(font), length,
        found);
    say(reviewer, &line);
}

static mt_status review_family(const mt_reviewer *reviewer, const mt_font *font) {
    mt_notice line = {0};
    mt_reserved reserved;
    mt_arena arena = {0};
    mt_status status = reviewer->family ? mt_reserved_find(font, &arena, &reserved) : MT_OK;
    const char *held =
        status == MT_OK && reviewer->family ? mt_reserved_in(&reserved, reviewer->family) : NULL;
    if (held) {
        add(&line, "the family name “%s” has “%s” in it, a name of %s", reviewer->family, held,
            mt_font_spec(font));
        say(reviewer, &line);
    }
    mt_arena_release(&arena);
    return status;
}

/* ---- tables -------------------------------------------------------------------------------------------- */

/* The MATH tables of the fonts. */
typedef struct mt_math_states {
    mt_math_state of[MT_VARIABLE_FONTS_MAX];
} mt_math_states;

static mt_status read_math(mt_font *const *fonts, int count, mt_math_states *states) {
    mt_arena arena = {0};
    mt_status status = MT_OK;
    for (int i = 0; i < count && status == MT_OK; i++) {
        mt_math_table table;
        status = mt_math_table_open(fonts[i], &arena, &table);
        states->of[i] = status == MT_OK ? table.state : MT_MATH_NONE;
        mt_arena_reset(&arena);
    }
    mt_arena_release(&arena);
    return status;
}

/* MATH is blended where the first font has one. */
static bool is_blended(const mt_math_states *math, int font) {
    return math->of[0] == MT_MATH_WHOLE && math->of[font] == MT_MATH_WHOLE;
}

/* Adds "COLR, CPAL of FONT" to the line, where the font has any of the tables, whose tags stand one after another. */
static void add_tables(const mt_font *font, const char *tags, bool but_math, mt_notice *line) {
    int count = 0;
    for (const char *tag = tags; *tag; tag += 4) {
        if (!mt_font_has_table(font, MT_TAG(tag[0], tag[1], tag[2], tag[3]))) continue;
        if (but_math && strncmp(tag, "MATH", 4) == 0) continue;
        add(line, "%s%.*s", count ? ", " : line->length ? "; " : "", tag[3] == ' ' ? 3 : 4, tag);
        count++;
    }
    if (count > 0) add(line, " of %s", mt_font_spec(font));
}

/* A line for each kind of table that a blend has none of. */
static void review_tables(const mt_reviewer *reviewer, mt_font *const *fonts, int count,
                          const mt_math_states *math) {
    static const struct {
        const char *what, *tags;
    } kinds[] = {
        {"colour, bitmap and math tables are", "COLRCPALCBDTCBLCsbixSVG EBDTEBLCEBSCbdatblocMATH"},
        {"Graphite's rules are", "SilfGlatGlocFeatSill"},
        {"Apple's layout tables are", "mortmorxkerxankrfeatjustopbdproptraklcar"},
    };
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
        mt_notice tables = {0}, line = {0};
        for (int k = 0; k < count; k++) add_tables(fonts[k], kinds[i].tags, is_blended(math, k), &tables);
        for (int k = 0; k < count && i == 0; k++)
            if (math->of[k] == MT_MATH_DAMAGED)
                add(&tables, "; MATH of %s is damaged", mt_font_spec(fonts[k]));
        add(&line, "%s left out: %s", kinds[i].what, tables.text);
        if (tables.length > 0) say(reviewer, &line);
    }
}

/* Metrics beside a Type 1 font that could not be read. */
static void review_metrics(const mt_reviewer *reviewer, const mt_font *font) {
    mt_notice line = {0};
    const char *path = mt_font_unread_metrics(font);
    add(&line, "%s cannot be read: no kerning from it for %s", path ? path : "", mt_font_spec(font));
    if (path) say(reviewer, &line);
}

static void review_features(const mt_reviewer *reviewer, const mt_font *font) {
    mt_notice line = {0};
    add(&line, "no character of %s has another form by these features", mt_font_spec(font));
    if (mt_font_features_do_nothing(font)) say(reviewer, &line);
}

/* ---- all of it ----------------------------------------------------------------------------------------- */

mt_status mt_review(mt_font *const *fonts, int count, const char *family, mt_warning call, void *user) {
    const mt_reviewer reviewer = {family, call, user};
    mt_status status = MT_OK;
    for (int i = 0; i < count && status == MT_OK; i++) {
        review_embedding(&reviewer, fonts[i]);
        review_license(&reviewer, fonts[i]);
        review_metrics(&reviewer, fonts[i]);
        review_features(&reviewer, fonts[i]);
        status = review_family(&reviewer, fonts[i]);
    }
    mt_math_states math = {0};
    if (status == MT_OK) status = read_math(fonts, count, &math);
    if (status == MT_OK) review_tables(&reviewer, fonts, count, &math);
    return status;
}
