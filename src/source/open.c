/* Opening a font: the spec, the file or the bytes, the face, the axes, the names, the figures, the features. */
#include "source/handle.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

#include "base/file.h"
#include "geometry/limits.h"
#include "sfnt/sfnt.h"
#include "sfnt/woff2.h"

/* ---- the stages of opening ----------------------------------------------------------------------------- */

static mt_status open_face(mt_font *font) {
    FT_Face probe;
    int number = font->spec.face;
    if (FT_New_Memory_Face(font->library, font->bytes, (FT_Long)font->length, -1, &probe) != 0)
        return MT_NOT_A_FONT;
    long count = probe->num_faces;
    FT_Done_Face(probe);
    if (number >= count) return MT_NO_FACE;
    if (!mt_sfnt_is_whole(font->bytes, font->length, number)) return MT_NOT_A_FONT;
    FT_Error error =
        FT_New_Memory_Face(font->library, font->bytes, (FT_Long)font->length, number, &font->face);
    if (error) return MT_NOT_A_FONT;
    if (!FT_IS_SCALABLE(font->face)) return MT_NO_OUTLINES;
    return font->face->units_per_EM > 0 ? MT_OK : MT_NOT_A_FONT;
}

/* The character map for Windows' symbol fonts (OpenType spec, "cmap": platform 3, encoding 0); NULL where there is none. */
static FT_CharMap find_symbol_map(FT_Face face) {
    for (int i = 0; i < face->num_charmaps; i++)
        if (face->charmaps[i]->encoding == FT_ENCODING_MS_SYMBOL) return face->charmaps[i];
    return NULL;
}

/* Unicode's before the one for symbols. */
static mt_status choose_charmap(mt_font *font) {
    uint32_t first;
    FT_CharMap symbols = find_symbol_map(font->face);
    font->is_symbol = symbols;
    if (FT_Select_Charmap(font->face, FT_ENCODING_UNICODE) == 0 && mt_font_next_char(font, 0, &first))
        return MT_OK;
    if (!symbols || FT_Set_Charmap(font->face, symbols) != 0) return MT_NO_CHARMAP;
    return mt_font_next_char(font, 0, &first) ? MT_OK : MT_NO_CHARMAP;
}

static mt_status read_face(mt_font *font, void *user) {
    (void)user;
    mt_status status = mt_font_start(font);
    if (status == MT_OK) status = open_face(font);
    if (status == MT_OK) status = mt_font_set_axes(font);
    if (status == MT_OK) status = choose_charmap(font);
    if (status == MT_OK) status = mt_font_read_names(font);
    if (status == MT_OK) mt_font_read_metrics(font);
    return status == MT_OK ? mt_font_attach_metrics(font) : status;
}

/* FreeType 2.12 refuses some WOFF2 that hold to the format, such as those packed to a small part of their size: what is in
 * such a file is opened in its place. */
static mt_status read_unpacked(mt_font *font) {
    uint8_t *bytes;
    size_t length;
    mt_status status = mt_woff2_unpack(font->bytes, font->length, &bytes, &length);
    if (status != MT_OK) return status;
    mt_font_discard(font);
    mt_free(font->bytes);
    font->bytes = bytes;
    font->length = length;
    return mt_font_guard(font, read_face, NULL);
}

/* What a font is opened from: a file by its spec, or bytes by a name and a choice. */
typedef struct mt_font_origin {
    const char *spec; /* NULL: the font is in memory */
    const uint8_t *bytes;
    size_t length;
    const char *name, *choice; /* NULL is fine */
} mt_font_origin;

static mt_status load_file(const char *spec, mt_font *font) {
    font->text = mt_copy_text(spec);
    if (!font->text) return MT_NO_MEMORY;
    mt_status status = mt_spec_parse(spec, &font->spec);
    return status == MT_OK ? mt_file_read(font->spec.path, MT_FONT_FILE_MAX, &font->bytes, &font->length)
                           : status;
}

static mt_status load_memory(const mt_font_origin *origin, mt_font *font) {
    const char *name = origin->name ? origin->name : "the font in memory",
               *choice = origin->choice ? origin->choice : "";
    size_t room = strlen(name) + strlen(choice) + 1;
    if (origin->length > MT_FONT_FILE_MAX) return MT_TOO_LARGE;
    font->in_memory = true;
    font->text = mt_new(room, 1);
    font->bytes = mt_new(origin->length, 1);
    font->length = origin->length;
    if (!font->text || !font->bytes) return MT_NO_MEMORY;
    snprintf(font->text, room, "%s%s", name, choice);
    if (origin->length) memcpy(font->bytes, origin->bytes, origin->length);
    return mt_spec_parse_choice(name, choice, &font->spec);
}

static mt_status open_stages(const mt_font_origin *origin, mt_font *font) {
    font->instance_name = -1;
    mt_status status = origin->spec ? load_file(origin->spec, font) : load_memory(origin, font);
    if (status == MT_OK) status = mt_font_guard(font, read_face, NULL);
    if (status == MT_NOT_A_FONT && mt_woff2_is(font->bytes, font->length)) status = read_unpacked(font);
    if (status == MT_OK) status = mt_font_read_features(font);
    mt_arena_release(&font->scratch);
    return status;
}

static mt_status open_font(const mt_font_origin *origin, mt_font **font) {
    mt_font *opened = mt_new(1, sizeof *opened);
    if (!opened) return MT_NO_MEMORY;
    mt_status status = open_stages(origin, opened);
    if (status == MT_OK) {
        *font = opened;
        return MT_OK;
    }
    int why = errno;
    mt_font_close(opened);
    errno = why;
    return status;
}

mt_status mt_font_open(const char *spec, mt_font **font) {
    return open_font(&(mt_font_origin){.spec = spec}, font);
}

mt_status mt_font_open_memory(const uint8_t *bytes, size_t length, const char *name, const char *choice,
                              mt_font **font) {
    const mt_font_origin origin = {.bytes = bytes, .length = length, .name = name, .choice = choice};
    return open_font(&origin, font);
}

void mt_font_close(mt_font *font) {
    if (!font) return;
    mt_font_free_names(font);
    mt_font_free_composed(font);
    mt_font_discard(font);
    mt_free(font->forms);
    mt_free(font->weights);
    mt_arena_release(&font->scratch);
    mt_free(font->metrics_path);
    mt_free(font->metrics_bytes);
    mt_free(font->bytes);
    mt_spec_clear(&font->spec);
    mt_free(font->text);
    mt_free(font);
}

/* ---- what it is ---------------------------------------------------------------------------------------- */

const char *mt_font_spec(const mt_font *font) {
    return font->text;
}

const char *mt_font_choice(const mt_font *font) {
    return font->text + strlen(font->spec.path);
}

int mt_font_units_per_em(const mt_font *font) {
    return font->units;
}

int mt_font_glyph_count(const mt_font *font) {
    FT_Long count = font->face ? font->face->num_glyphs : 0;
    return (int)(count < MT_GLYPHS_MAX ? count : MT_GLYPHS_MAX);
}

/* ---- characters ---------------------------------------------------------------------------------------- */

enum { LAST_CHAR = 0x10FFFF, FIRST_SURROGATE = 0xD800, LAST_SURROGATE = 0xDFFF };

/* Symbol fonts have their glyphs for the codes of one byte here. */
enum { LAST_BYTE = 0xFF, FIRST_SYMBOL = 0xF000 };

static bool is_char(uint32_t code_point) {
    return code_point <= LAST_CHAR && (code_point < FIRST_SURROGATE || code_point > LAST_SURROGATE);
}

uint32_t mt_font_mapped_glyph(const mt_font *font, uint32_t code_point) {
    FT_UInt glyph = font->face && is_char(code_point) ? FT_Get_Char_Index(font->face, code_point) : 0;
    return glyph < MT_GLYPHS_MAX ? mt_font_form(font, code_point, glyph) : 0;
}

uint32_t mt_font_glyph(const mt_font *font, uint32_t code_point) {
    uint32_t glyph = mt_font_mapped_glyph(font, code_point);
    if (glyph || !font->is_symbol || code_point > LAST_BYTE) return glyph;
    return mt_font_mapped_glyph(font, FIRST_SYMBOL + code_point);
}

bool mt_font_is_symbol(const mt_font *font) {
    return font->is_symbol;
}

bool mt_font_next_char(const mt_font *font, uint32_t from, uint32_t *code_point) {
    if (from >= FIRST_SURROGATE && from <= LAST_SURROGATE) from = LAST_SURROGATE + 1;
    if (!font->face || from > LAST_CHAR) return false;
    FT_ULong found = from;
    FT_UInt glyph = FT_Get_Char_Index(font->face, from);
    if (glyph == 0) found = FT_Get_Next_Char(font->face, from, &glyph);
    if (glyph == 0 || found > LAST_CHAR) return false;
    if (!is_char((uint32_t)found)) return mt_font_next_char(font, LAST_SURROGATE + 1, code_point);
    *code_point = (uint32_t)found;
    return true;
}
