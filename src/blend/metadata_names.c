/* What a blended font is called and says of its origin. A source's text over its share of 'name', whose offsets have 16
 * bits, is cut short and ends in an ellipsis. */
#include "blend/metadata.h"

#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "sfnt/axis.h"
#include "source/reserved.h"

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

static const char *text_of(const mt_source *source, size_t field) {
    return *(const char *const *)((const char *)&source->names + field);
}

/* Whether one of the first `count` sources has the same text. */
static bool is_told(const mt_source *sources, int count, size_t offset, const char *text) {
    for (int i = 0; i < count; i++) {
        const char *earlier = text_of(&sources[i], offset);
        if (earlier && strcmp(earlier, text) == 0) return true;
    }
    return false;
}

/* The texts of all sources in a field of mt_names, each once; NULL when all are missing. */
static const char *joined(mt_namer *namer, const mt_source *sources, int count, size_t field,
                          const char *between, size_t limit) {
    const char *all = NULL;
    for (int i = 0; i < count; i++) {
        const char *text = text_of(&sources[i], field);
        if (!text || !*text || is_told(sources, i, field, text)) continue;
        text = clipped(namer, text, limit / (size_t)(count > 2 ? count - 1 : 1));
        all = all ? formed(namer, "%s%s%s", all, between, text) : text;
    }
    return all;
}

/* ---- the family ---------------------------------------------------------------------------------------- */

/* FNV-1a (Fowler, Noll, Vo), folded to 16 bits: enough to keep the families of different pairs apart in a
 * font menu. */
static unsigned short_hash(const char *text, unsigned hash) {
    for (; *text; text++) hash = (hash ^ (unsigned char)*text) * 16777619u;
    return hash;
}

/* Whether one of the sources keeps the name for itself. */
static mt_status is_reserved(mt_namer *namer, const mt_source *sources, int count, const char *name,
                             bool *reserved) {
    *reserved = false;
    for (int i = 0; i < count && !*reserved; i++) {
        mt_reserved kept;
        mt_status status = mt_reserved_find(sources[i].font, namer->arena, &kept);
        if (status != MT_OK) return status;
        *reserved = mt_reserved_in(&kept, name);
    }
    return MT_OK;
}

/* A word and a number made of the sources' names; another word where the sources keep the first one for themselves. */
static mt_status make_family(mt_namer *namer, const mt_source *sources, int count, const char **family) {
    static const char *const words[] = {"Morphotype", "Between", "Halfway"};
    unsigned hash = 2166136261u;
    bool reserved = true;
    for (int i = 0; i < count; i++) hash = short_hash(sources[i].title, i ? hash * 16777619u : hash);
    for (size_t i = 0; i < sizeof words / sizeof *words && reserved; i++) {
        *family = formed(namer, "%s %04X", words[i], (hash >> 16 ^ hash) & 0xFFFF);
        mt_status status = is_reserved(namer, sources, count, *family, &reserved);
        if (status != MT_OK) return status;
    }
    return MT_OK;
}

/* ---- the names ----------------------------------------------------------------------------------------- */

/* As --at has it. */
static const char *place_text(mt_namer *namer, mt_at at) {
    return at.x == at.y ? formed(namer, "%g", at.x) : formed(namer, "%g,y=%g", at.x, at.y);
}

static void describe(mt_namer *namer, const mt_source *a, const mt_source *b, mt_at at, mt_font_data *data) {
    const char *t = place_text(namer, at);
    data->style = formed(namer, "At %s", t);
    data->unique_id = formed(namer, "Morphotype %s: %s %s, %s %s, %s", MORPHOTYPE_VERSION, a->title,
                             a->version, b->title, b->version, t);
    data->description =
        formed(namer, "Between %s%s%s (T = 0) and %s%s%s (T = 1), at T = %s, by Morphotype %s", a->title,
               *a->version ? ", version " : "", a->version, b->title, *b->version ? ", version " : "",
               b->version, t, MORPHOTYPE_VERSION);
}

/* The place on the axis of each. */
static void describe_axis(mt_namer *namer, const mt_source *sources, const double *values, int count,
                          mt_font_data *data) {
    const char *id = formed(namer, "Morphotype %s:", MORPHOTYPE_VERSION), *fonts = "";
    const uint32_t t = data->variation->axis.tag;
    const char tag[] = {(char)(t >> 24), (char)(t >> 16 & 0xFF), (char)(t >> 8 & 0xFF), (char)(t & 0xFF),
                        '\0'};
    for (int i = 0; i < count; i++) {
        const mt_source *s = &sources[i];
        const char *between = i == 0 ? "" : i + 1 < count ? ", " : " and ";
        id = formed(namer, "%s %s %s,", id, s->title, s->version);
        fonts = formed(namer, "%s%s%s%s%s (%s = %.4g)", fonts, between, s->title,
                       *s->version ? ", version " : "", s->version, tag, values[i]);
    }
    data->unique_id = formed(namer, "%s variable", id);
    data->description = formed(namer, "Varies between %s, by Morphotype %s", fonts, MORPHOTYPE_VERSION);
}

static void join_notices(mt_namer *namer, const mt_source *sources, int count, mt_font_data *data) {
    data->version = "Version 1.000; Morphotype " MORPHOTYPE_VERSION;
    data->copyright = joined(namer, sources, count, offsetof(mt_names, copyright), "\n", COPYRIGHT_MAX);
    data->trademark = joined(namer, sources, count, offsetof(mt_names, trademark), "\n", TRADEMARK_MAX);
    data->designer = joined(namer, sources, count, offsetof(mt_names, designer), ", ", DESIGNER_MAX);
    data->license = joined(namer, sources, count, offsetof(mt_names, license), "\n", LICENSE_MAX);
    data->license_url = joined(namer, sources, count, offsetof(mt_names, license_url), " ", URL_MAX);
}

/* All but what is said of a place, or of an axis. */
static mt_status name_family(mt_namer *namer, const mt_source *sources, int count, const char *family,
                             mt_font_data *data) {
    data->family = family;
    mt_status status = family ? MT_OK : make_family(namer, sources, count, &data->family);
    if (status == MT_OK) join_notices(namer, sources, count, data);
    return status;
}

mt_status mt_metadata_names(const mt_font *a, const mt_font *b, mt_at at, const char *family, mt_arena *arena,
                            mt_font_data *data) {
    mt_namer namer = {.arena = arena};
    const mt_source sources[] = {read_source(&namer, a), read_source(&namer, b)};
    mt_status status = name_family(&namer, sources, 2, family, data);
    if (status != MT_OK) return status;
    describe(&namer, &sources[0], &sources[1], at, data);
    return namer.failed ? MT_NO_MEMORY : MT_OK;
}

mt_status mt_metadata_axis_names(mt_font *const *fonts, const double *values, int count, const char *family,
                                 mt_arena *arena, mt_font_data *data) {
    mt_namer namer = {.arena = arena};
    mt_source *sources = mt_arena_new(arena, (size_t)count, sizeof *sources);
    if (!sources) return MT_NO_MEMORY;
    for (int i = 0; i < count; i++) sources[i] = read_source(&namer, fonts[i]);
    mt_status status = name_family(&namer, sources, count, family, data);
    if (status != MT_OK) return status;
    describe_axis(&namer, sources, values, count, data);
    return namer.failed ? MT_NO_MEMORY : MT_OK;
}
