/* The references of a composite glyph (OpenType spec, "glyf": Composite Glyph Description).
 *
 * Where a reference moves its glyph to is measured on what FreeType draws, and not read from its arguments: points are
 * matched, side bearings shift glyphs, and variations move offsets. A reference that does anything but move is found
 * out at the same time. */
#include "source/handle.h"

#include "sfnt/sfnt.h"

enum {
    FLAGS = FT_LOAD_NO_SCALE | FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP | FT_LOAD_IGNORE_TRANSFORM,
    REFERENCES_MAX = 64, /* accented letters have two or three */
};

typedef struct mt_reader {
    uint32_t glyph;
    mt_arena *arena;
    uint32_t glyphs[REFERENCES_MAX]; /* that the composite names */
    int count;
    FT_Vector *points; /* of the composite as it is drawn */
    char *tags;
    int point_count, matched; /* points, and how many of them the references so far account for */
    mt_references found;
} mt_reader;

/* Fills `glyphs`; false for what is no composite. */
static bool list_glyphs(FT_Face face, mt_reader *reader) {
    if (FT_Load_Glyph(face, reader->glyph, FLAGS | FT_LOAD_NO_RECURSE) != 0) return false;
    FT_GlyphSlot slot = face->glyph;
    if (slot->format != FT_GLYPH_FORMAT_COMPOSITE || slot->num_subglyphs > REFERENCES_MAX) return false;
    for (FT_UInt i = 0; i < slot->num_subglyphs; i++) {
        FT_Int index, first, second;
        FT_UInt flags;
        FT_Matrix matrix;
        if (FT_Get_SubGlyph_Info(slot, i, &index, &flags, &first, &second, &matrix) != 0) return false;
        reader->glyphs[reader->count++] = (uint32_t)index;
    }
    return true;
}

/* The whole as it is drawn. */
static bool draw_whole(mt_font *font, mt_reader *reader, mt_status *status) {
    *status = mt_font_load(font, reader->glyph, FLAGS);
    if (*status != MT_OK) return false;
    const FT_Outline *outline = &font->face->glyph->outline;
    int count = outline->n_points;
    reader->points = mt_arena_new(reader->arena, (size_t)count, sizeof *reader->points);
    reader->tags = mt_arena_new(reader->arena, (size_t)count, 1);
    if (!reader->points || !reader->tags) *status = MT_NO_MEMORY;
    if (*status != MT_OK) return false;
    for (int i = 0; i < count; i++) {
        reader->points[i] = outline->points[i];
        reader->tags[i] = outline->tags[i];
    }
    reader->point_count = count;
    return true;
}

/* Whether the glyph, moved, is the whole's next points; adds it where it has any. */
static bool match_reference(FT_Face face, uint32_t glyph, mt_reader *reader) {
    if (FT_Load_Glyph(face, glyph, FLAGS) != 0) return false;
    const FT_Outline *outline = &face->glyph->outline;
    int count = outline->n_points;
    if (count > reader->point_count - reader->matched) return false;
    if (count == 0) return true;
    const FT_Vector *points = reader->points + reader->matched;
    const char *tags = reader->tags + reader->matched;
    FT_Pos dx = points[0].x - outline->points[0].x, dy = points[0].y - outline->points[0].y;
    for (int i = 0; i < count; i++) {
        bool same = points[i].x - outline->points[i].x == dx && points[i].y - outline->points[i].y == dy;
        if (!same || FT_CURVE_TAG(tags[i]) != FT_CURVE_TAG(outline->tags[i])) return false;
    }
    reader->matched += count;
    reader->found.list[reader->found.count++] = (mt_reference){glyph, (int)dx, (int)dy};
    return true;
}

static bool match_all(FT_Face face, mt_reader *reader) {
    for (int i = 0; i < reader->count; i++)
        if (!match_reference(face, reader->glyphs[i], reader)) return false;
    return reader->matched == reader->point_count;
}

static mt_status read_references(mt_font *font, void *user) {
    mt_reader *reader = user;
    mt_status status = MT_OK;
    if (!list_glyphs(font->face, reader)) return MT_OK;
    if (!draw_whole(font, reader, &status)) return status == MT_NO_MEMORY ? status : MT_OK;
    reader->found.list = mt_arena_new(reader->arena, (size_t)reader->count, sizeof(mt_reference));
    if (!reader->found.list) return MT_NO_MEMORY;
    if (!match_all(font->face, reader)) reader->found.count = 0;
    return MT_OK;
}

mt_status mt_font_references(mt_font *font, uint32_t glyph, mt_arena *arena, mt_references *references) {
    mt_reader reader = {.glyph = glyph, .arena = arena};
    const mt_composed *composed = mt_font_composed(font, glyph);
    if (!font->face) return MT_NO_MEMORY;
    if (composed) *references = composed->parts;
    if (composed) return MT_OK;
    bool truetype = mt_font_has_table(font, MT_TAG('g', 'l', 'y', 'f'));
    mt_status status = truetype ? mt_font_guard(font, read_references, &reader) : MT_OK;
    if (status == MT_OK) *references = reader.found;
    return status;
}
