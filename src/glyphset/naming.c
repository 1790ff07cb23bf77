#include "glyphset/naming.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "base/utf.h"
#include "glyphset/shaper.h"
#include "gsub/gsub.h"
#include "source/glyph_names.h"

enum {
    NAME_MAX_BYTES = 255, /* what FreeType gives of a name */
    PARTS_MAX = 16,       /* of a ligature's name */
};

struct mt_naming {
    mt_font *font;
    mt_arena arena;
    mt_name_index index;
    const char **names; /* of each glyph; NULL: it has none */
    bool has_ligatures; /* what follows is read once a ligature is looked for */
    uint32_t *codes;    /* of each glyph, the first character that leads to it; 0: none does */
    mt_gsub gsub;
    mt_shaper shaper;
};

/* ---- own names ----------------------------------------------------------------------------------------- */

static mt_status list_names(mt_naming *naming) {
    mt_status status = mt_name_index_make(naming->font, &naming->arena, &naming->index);
    size_t count = (size_t)mt_font_glyph_count(naming->font);
    if (status != MT_OK) return status;
    naming->names = mt_arena_new(&naming->arena, count + 1, sizeof *naming->names);
    if (!naming->names) return MT_NO_MEMORY;
    for (int i = 0; i < naming->index.count; i++)
        naming->names[naming->index.list[i].glyph] = naming->index.list[i].name;
    return MT_OK;
}

mt_status mt_naming_open(mt_font *font, mt_naming **naming) {
    mt_naming *made = mt_new(1, sizeof *made);
    if (!made) return MT_NO_MEMORY;
    made->font = font;
    mt_status status = list_names(made);
    if (status == MT_OK)
        *naming = made;
    else
        mt_naming_close(made);
    return status;
}

void mt_naming_close(mt_naming *naming) {
    if (!naming) return;
    mt_shaper_close(&naming->shaper);
    mt_arena_release(&naming->arena);
    mt_free(naming);
}

static bool find_own(const mt_naming *naming, const char *name, uint32_t *glyph) {
    uint32_t found = mt_name_index_find(&naming->index, name);
    if (!found && (!naming->names[0] || strcmp(naming->names[0], name) != 0)) return false;
    *glyph = found;
    return true;
}

/* ---- numbers and code points --------------------------------------------------------------------------- */

static bool find_number(const mt_naming *naming, const char *name, uint32_t *glyph) {
    long count = mt_font_glyph_count(naming->font), number = 0;
    if (strncmp(name, "gid", 3) != 0) return false;
    const char *first = name + 3, *digit = first;
    for (; *digit >= '0' && *digit <= '9' && number < count; digit++) number = 10 * number + (*digit - '0');
    if (digit == first || *digit || number >= count) return false;
    *glyph = (uint32_t)number;
    return true;
}

/* uniXXXX or uXXXX … uXXXXXX, in capitals. */
static bool read_code(const char *name, uint32_t *code) {
    bool uni = strncmp(name, "uni", 3) == 0;
    const char *digits = name + (uni ? 3 : 1);
    size_t length = strlen(digits);
    if (*name != 'u' || length < 4 || length > (uni ? 4 : 6)) return false;
    if (strspn(digits, "0123456789ABCDEF") != length) return false;
    *code = (uint32_t)strtoul(digits, NULL, 16);
    return true;
}

static bool find_code(const mt_naming *naming, const char *name, uint32_t *glyph) {
    uint32_t code, found = 0;
    if (read_code(name, &code)) found = mt_font_mapped_glyph(naming->font, code);
    if (found) *glyph = found;
    return found != 0;
}

static bool find_one(const mt_naming *naming, const char *name, uint32_t *glyph) {
    return find_own(naming, name, glyph) || find_number(naming, name, glyph) ||
           find_code(naming, name, glyph);
}

/* ---- ligatures ----------------------------------------------------------------------------------------- */

/* The parts that a ligature's name tells. */
typedef struct mt_parts {
    int count;
    uint32_t glyphs[PARTS_MAX];
    uint32_t codes[PARTS_MAX]; /* as in mt_naming */
} mt_parts;

static mt_status list_codes(mt_naming *naming) {
    const mt_font *font = naming->font;
    uint32_t *codes = mt_arena_new(&naming->arena, (size_t)mt_font_glyph_count(font) + 1, sizeof *codes);
    if (!codes) return MT_NO_MEMORY;
    uint32_t code = 0;
    for (bool more = mt_font_next_char(font, 0, &code); more;
         more = mt_font_next_char(font, code + 1, &code)) {
        uint32_t glyph = mt_font_mapped_glyph(font, code);
        if (!codes[glyph]) codes[glyph] = code;
    }
    naming->codes = codes;
    return MT_OK;
}

static mt_status open_ligatures(mt_naming *naming) {
    if (naming->has_ligatures) return MT_OK;
    mt_status status = list_codes(naming);
    if (status == MT_OK) status = mt_gsub_open(naming->font, &naming->arena, &naming->gsub);
    if (status != MT_OK) return status;
    status = mt_shaper_open(naming->font, &naming->gsub, &naming->arena, &naming->shaper);
    if (status != MT_OK) mt_shaper_close(&naming->shaper);
    naming->has_ligatures = status == MT_OK;
    return status;
}

/* A part is a name, or a character itself. */
static bool add_part(const mt_naming *naming, const char *name, mt_parts *parts) {
    const char *after = name;
    uint32_t code = 0, glyph = 0;
    if (parts->count == PARTS_MAX || !*name) return false;
    bool is_character = mt_utf8_next(&after, &code) && !*after;
    if (!find_one(naming, name, &glyph)) glyph = is_character ? mt_font_mapped_glyph(naming->font, code) : 0;
    if (!glyph) return false;
    parts->glyphs[parts->count] = glyph;
    parts->codes[parts->count++] = naming->codes[glyph];
    return true;
}

/* Cuts the name at its underscores, in place. */
static bool split(const mt_naming *naming, char *name, mt_parts *parts) {
    parts->count = 0;
    for (char *end; name; name = end) {
        end = strchr(name, '_');
        if (end) *end++ = '\0';
        if (!add_part(naming, name, parts)) return false;
    }
    return parts->count > 1;
}

/* What the text of the parts' characters becomes, with the features that are on by default. */
static bool shape_parts(mt_naming *naming, const mt_parts *parts, uint32_t *glyph) {
    for (int i = 0; i < parts->count; i++)
        if (!parts->codes[i]) return false;
    mt_shaped_text shaped = mt_shaper_shape(&naming->shaper, parts->codes, parts->count);
    if (shaped.count != 1 || shaped.glyphs[0].codepoint == 0) return false;
    *glyph = shaped.glyphs[0].codepoint;
    return true;
}

/* How many of the first parts the substitution makes one of; 0: it is no ligature of them. */
static int fit(const mt_substitution *substitution, const mt_parts *parts) {
    if (substitution->outputs != 1 || substitution->inputs > parts->count) return 0;
    for (int i = 0; i < substitution->inputs; i++)
        if (substitution->glyphs[i] != parts->glyphs[i]) return 0;
    return substitution->inputs;
}

/* The ligature of most of the first parts; of several the first lookup's. */
static const mt_substitution *longest_ligature(const mt_gsub *gsub, const mt_parts *parts) {
    const mt_substitution *longest = NULL;
    for (int i = 0; i < gsub->layout.lookup_count; i++) {
        const mt_gsub_lookup *lookup = &gsub->lookups[i];
        for (int k = 0; lookup->type == MT_GSUB_LIGATURE && k < lookup->subtable_count; k++)
            for (int n = 0; n < lookup->subtables[k].count; n++) {
                const mt_substitution *one = &lookup->subtables[k].list[n];
                if (fit(one, parts) > (longest ? longest->inputs : 1)) longest = one;
            }
    }
    return longest;
}

/* Puts ligatures in place of the first parts until one glyph is left, as f_f and i become f_f_i. */
static bool join_parts(const mt_gsub *gsub, mt_parts *parts, uint32_t *glyph) {
    while (parts->count > 1) {
        const mt_substitution *ligature = longest_ligature(gsub, parts);
        if (!ligature) return false;
        parts->glyphs[0] = ligature->glyphs[ligature->inputs];
        for (int i = ligature->inputs; i < parts->count; i++)
            parts->glyphs[i - ligature->inputs + 1] = parts->glyphs[i];
        parts->count -= ligature->inputs - 1;
    }
    *glyph = parts->glyphs[0];
    return true;
}

/* Cuts the name up. */
static mt_status find_ligature(mt_naming *naming, char *name, uint32_t *glyph) {
    mt_parts parts;
    mt_status status = strchr(name, '_') ? open_ligatures(naming) : MT_NO_GLYPH;
    if (status != MT_OK) return status;
    bool found = split(naming, name, &parts) &&
                 (shape_parts(naming, &parts, glyph) || join_parts(&naming->gsub, &parts, glyph));
    if (naming->shaper.endless) return MT_ENDLESS_LOOKUPS;
    return found ? MT_OK : MT_NO_GLYPH;
}

/* ---- both ways ----------------------------------------------------------------------------------------- */

mt_status mt_naming_find(mt_naming *naming, const char *name, size_t length, uint32_t *glyph) {
    char text[NAME_MAX_BYTES + 1] = "";
    if (length < 1 || length > NAME_MAX_BYTES) return MT_NO_GLYPH;
    memcpy(text, name, length);
    return find_one(naming, text, glyph) ? MT_OK : find_ligature(naming, text, glyph);
}

mt_status mt_font_glyph_of_name(mt_font *font, const char *name, uint32_t *glyph) {
    mt_naming *naming;
    mt_status status = mt_naming_open(font, &naming);
    if (status != MT_OK) return status;
    status = mt_naming_find(naming, name, strlen(name), glyph);
    mt_naming_close(naming);
    return status;
}

/* Whether a text can have the name: nothing in it ends it, and all of it shows. */
static bool can_stand(const char *name) {
    uint32_t code;
    while (*name)
        if (!mt_utf8_next(&name, &code) || code <= ' ' || code == '/' || (code >= 0x7f && code < 0xa0))
            return false;
    return true;
}

void mt_naming_label(const mt_naming *naming, uint32_t glyph, char label[MT_GLYPH_LABEL_ROOM]) {
    const char *name = glyph < (uint32_t)mt_font_glyph_count(naming->font) ? naming->names[glyph] : NULL;
    uint32_t found;
    if (name && can_stand(name) && find_own(naming, name, &found) && found == glyph)
        snprintf(label, MT_GLYPH_LABEL_ROOM, "/%s", name);
    else
        snprintf(label, MT_GLYPH_LABEL_ROOM, "/gid%lu", (unsigned long)glyph);
}
