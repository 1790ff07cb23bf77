/* What a blended font is called and says of its origin. A source's text over its share of 'name', whose offsets have 16
 * bits, is cut short and ends in an ellipsis. */
#include "font/recipe.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "font/reserved.h"

/* Bytes of one source's text. */
enum {
    COPYRIGHT_MAX = 2500,
    LICENSE_MAX = 10000,
    TRADEMARK_MAX = 700,
    DESIGNER_MAX = 500,
    URL_MAX = 300,
    VERSION_MAX = 200,
    NAME_MAX_BYTES = 150,
};

typedef struct mt_namer {
    mt_arena *arena;
    bool failed; /* for want of memory; every text is "" from then on */
} mt_namer;

/* ---- texts --------------------------------------------------------------------------------------------- */

static char *room(mt_namer *namer, size_t length) {
    static char nothing[1];
    char *text = mt_arena_new(namer->arena, length + 1, 1);
    if (!text) namer->failed = true;
    return text ? text : nothing;
}

/* As printf. */
static const char *formed(mt_namer *namer, const char *format, ...) {
    va_list list, again;
    va_start(list, format);
    va_copy(again, list);
    int length = vsnprintf(NULL, 0, format, list);
    char *text = room(namer, length > 0 ? (size_t)length : 0);
    if (length > 0 && !namer->failed) vsnprintf(text, (size_t)length + 1, format, again);
    va_end(again);
    va_end(list);
    return text;
}

/* The text, cut between two characters where it is over the limit; "" for NULL. */
static const char *clipped(mt_namer *namer, const char *text, size_t limit) {
    if (!text) return "";
    if (strlen(text) <= limit) return text;
    while (limit > 0 && ((unsigned char)text[limit] & 0xC0) == 0x80) limit--;
    return formed(namer, "%.*s…", (int)limit, text);
}

/* Both texts, or the one when the other is the same or missing; NULL when both are missing. */
static const char *both(mt_namer *namer, const char *a, const char *b, const char *between, size_t limit) {
    a = clipped(namer, a, limit);
    b = clipped(namer, b, limit);
    bool single = !*a || !*b || strcmp(a, b) == 0;
    const char *text = single ? (*a ? a : b) : formed(namer, "%s%s%s", a, between, b);
    return *text ? text : NULL;
}

/* ---- the sources --------------------------------------------------------------------------------------- */

typedef struct mt_source {
    const mt_font *font;
    mt_names names;
    const char *title;   /* family, style, and the face and place that were chosen */
    const char *version; /* without the word at its start; "" for none */
} mt_source;

static mt_source read_source(mt_namer *namer, const mt_font *font) {
    mt_source source = {.font = font};
    mt_font_names(font, &source.names);
    const char *family = clipped(namer, source.names.family, NAME_MAX_BYTES);
    const char *style = clipped(namer, source.names.style, NAME_MAX_BYTES);
    const char *choice = clipped(namer, mt_font_choice(font), NAME_MAX_BYTES);
    source.title = formed(namer, "%s%s%s%s%s", family, *style ? " " : "", style, *choice ? " " : "", choice);
    source.version = clipped(namer, source.names.version, VERSION_MAX);
    if (strncmp(source.version, "Version ", 8) == 0) source.version += 8;
    return source;
}

/* ---- the family ---------------------------------------------------------------------------------------- */

/* FNV-1a (Fowler, Noll, Vo), folded to 16 bits: enough to keep the families of different pairs apart in a
 * font menu. */
static unsigned short_hash(const char *text, unsigned hash) {
    for (; *text; text++) hash = (hash ^ (unsigned char)*text) * 16777619u;
    return hash;
}

/* A word and a number made of the sources' names; another word where the sources keep the first one for themselves. */
static mt_status make_family(mt_namer *namer, const mt_source *a, const mt_source *b, const char **family) {
    static const char *const words[] = {"Morphotype", "Between", "Halfway"};
    mt_reserved in_a, in_b;
    unsigned hash = short_hash(b->title, short_hash(a->title, 2166136261u) * 16777619u);
    mt_status status = mt_reserved_find(a->font, namer->arena, &in_a);
    if (status == MT_OK) status = mt_reserved_find(b->font, namer->arena, &in_b);
    if (status != MT_OK) return status;
    const char *made = "";
    for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
        made = formed(namer, "%s %04X", words[i], (hash >> 16 ^ hash) & 0xFFFF);
        if (!mt_reserved_in(&in_a, made) && !mt_reserved_in(&in_b, made)) break;
    }
    *family = made;
    return MT_OK;
}

/* ---- the names ----------------------------------------------------------------------------------------- */

static void describe(mt_namer *namer, const mt_source *a, const mt_source *b, double t, mt_font_data *data) {
    data->style = formed(namer, "At %g", t);
    data->unique_id = formed(namer, "Morphotype %s: %s %s, %s %s, %g", MORPHOTYPE_VERSION, a->title,
                             a->version, b->title, b->version, t);
    data->version = "Version 1.000; Morphotype " MORPHOTYPE_VERSION;
    data->description =
        formed(namer, "Between %s%s%s (T = 0) and %s%s%s (T = 1), at T = %g, by Morphotype %s", a->title,
               *a->version ? ", version " : "", a->version, b->title, *b->version ? ", version " : "",
               b->version, t, MORPHOTYPE_VERSION);
}

static void join_notices(mt_namer *namer, const mt_names *a, const mt_names *b, mt_font_data *data) {
    data->copyright = both(namer, a->copyright, b->copyright, "\n", COPYRIGHT_MAX);
    data->trademark = both(namer, a->trademark, b->trademark, "\n", TRADEMARK_MAX);
    data->designer = both(namer, a->designer, b->designer, ", ", DESIGNER_MAX);
    data->license = both(namer, a->license, b->license, "\n", LICENSE_MAX);
    data->license_url = both(namer, a->license_url, b->license_url, " ", URL_MAX);
}

mt_status mt_recipe_names(const mt_font *a, const mt_font *b, double t, const char *family, mt_arena *arena,
                          mt_font_data *data) {
    mt_namer namer = {.arena = arena};
    mt_source in_a = read_source(&namer, a), in_b = read_source(&namer, b);
    data->family = family;
    mt_status status = family ? MT_OK : make_family(&namer, &in_a, &in_b, &data->family);
    if (status != MT_OK) return status;
    describe(&namer, &in_a, &in_b, t, data);
    join_notices(&namer, &in_a.names, &in_b.names, data);
    return namer.failed ? MT_NO_MEMORY : MT_OK;
}
