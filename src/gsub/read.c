/* The substitutions of one subtable. Each format's reader goes by the covered glyphs; one whose outputs reach past the
 * table's end, or name a glyph that the font has not, is passed over. */
#include "gsub/gsub.h"

#include <string.h>

typedef struct mt_filling {
    mt_gsub_reader *reader;
    mt_gsub_subtable *subtable;
    int room;
} mt_filling;

static mt_status make_room(mt_filling *filling) {
    mt_gsub_subtable *subtable = filling->subtable;
    mt_substitution *list = mt_arena_grow_list(filling->reader->arena, subtable->list, subtable->count,
                                               &filling->room, sizeof *list);
    if (!list) return MT_NO_MEMORY;
    subtable->list = list;
    return MT_OK;
}

/* Adds the substitution of `first` and the `inputs` - 1 glyphs at `more` by the `outputs` glyphs at `to`. */
static mt_status add(mt_filling *filling, unsigned first, mt_bytes more, unsigned inputs, mt_bytes to,
                     unsigned outputs) {
    mt_gsub_reader *reader = filling->reader;
    mt_gsub_subtable *subtable = filling->subtable;
    size_t count = (size_t)inputs + outputs;
    if (inputs == 0 || first >= (unsigned)reader->glyph_count) return MT_OK;
    if (!mt_ot_has(more, 0, 2 * (size_t)(inputs - 1)) || !mt_ot_has(to, 0, 2 * (size_t)outputs)) return MT_OK;
    reader->left -= (int64_t)count;
    if (reader->left < 0) return MT_OK;
    uint16_t *glyphs = mt_arena_new(reader->arena, count, sizeof *glyphs);
    if (!glyphs || make_room(filling) != MT_OK) return MT_NO_MEMORY;
    glyphs[0] = (uint16_t)first;
    for (size_t i = 1; i < count; i++)
        glyphs[i] = (uint16_t)(i < inputs ? mt_ot_u16(more, 2 * (i - 1)) : mt_ot_u16(to, 2 * (i - inputs)));
    for (size_t i = 1; i < count; i++)
        if (glyphs[i] >= reader->glyph_count) return MT_OK;
    subtable->list[subtable->count++] = (mt_substitution){glyphs, (uint16_t)inputs, (uint16_t)outputs};
    return MT_OK;
}

/* ---- the formats --------------------------------------------------------------------------------------- */

static mt_status read_single(mt_filling *filling, mt_covered covered) {
    mt_bytes table = filling->subtable->table, to = {0};
    uint8_t moved[2];
    unsigned format = mt_ot_u16(table, 0), glyph = (covered.glyph + mt_ot_u16(table, 4)) & 0xFFFF;
    moved[0] = (uint8_t)(glyph >> 8);
    moved[1] = (uint8_t)glyph;
    if (format == 1) to = (mt_bytes){moved, 2};
    if (format == 2 && covered.index < mt_ot_u16(table, 4))
        to = mt_ot_at(table, 6 + 2 * (size_t)covered.index);
    return add(filling, covered.glyph, (mt_bytes){0}, 1, to, 1);
}

/* Multiple and alternate substitution look alike. */
static mt_status read_sequence(mt_filling *filling, mt_covered covered) {
    mt_bytes table = filling->subtable->table;
    if (covered.index >= mt_ot_u16(table, 4)) return MT_OK;
    mt_bytes sequence = mt_ot_follow(table, 6 + 2 * (size_t)covered.index);
    return add(filling, covered.glyph, (mt_bytes){0}, 1, mt_ot_at(sequence, 2), mt_ot_u16(sequence, 0));
}

static mt_status read_ligatures(mt_filling *filling, mt_covered covered) {
    mt_bytes table = filling->subtable->table;
    if (covered.index >= mt_ot_u16(table, 4)) return MT_OK;
    mt_bytes set = mt_ot_follow(table, 6 + 2 * (size_t)covered.index);
    int count = mt_ot_fit(set, 2, mt_ot_u16(set, 0), 2);
    mt_status status = MT_OK;
    for (int i = 0; i < count && status == MT_OK; i++) {
        mt_bytes ligature = mt_ot_follow(set, 2 + 2 * (size_t)i);
        filling->reader->left--;
        status = add(filling, covered.glyph, mt_ot_at(ligature, 4), mt_ot_u16(ligature, 2), ligature, 1);
    }
    return status;
}

/* The substitutes stand behind the coverages of what comes before and after. */
static mt_status read_reverse(mt_filling *filling, mt_covered covered) {
    mt_bytes table = filling->subtable->table;
    size_t at = 6 + 2 * (size_t)mt_ot_u16(table, 4);
    at += 2 + 2 * (size_t)mt_ot_u16(table, at);
    if (covered.index >= mt_ot_u16(table, at)) return MT_OK;
    return add(filling, covered.glyph, (mt_bytes){0}, 1, mt_ot_at(table, at + 2 + 2 * (size_t)covered.index),
               1);
}

mt_status mt_gsub_read(mt_gsub_reader *reader, int type, mt_bytes table, mt_gsub_subtable *subtable) {
    static mt_status (*const readers[])(mt_filling *, mt_covered) = {
        [MT_GSUB_SINGLE] = read_single,      [MT_GSUB_MULTIPLE] = read_sequence,
        [MT_GSUB_ALTERNATE] = read_sequence, [MT_GSUB_LIGATURE] = read_ligatures,
        [MT_GSUB_REVERSE] = read_reverse,
    };
    bool known = type > 0 && type < (int)(sizeof readers / sizeof *readers) && readers[type];
    unsigned format = mt_ot_u16(table, 0);
    if (!known || (format != 1 && (format != 2 || type != MT_GSUB_SINGLE))) return MT_OK;
    mt_filling filling = {.reader = reader, .subtable = subtable};
    mt_covered *covered;
    mt_bytes coverage = mt_ot_follow(table, 2);
    int count;
    reader->left -= mt_ot_u16(coverage, 2);
    if (reader->left < 0) return MT_OK;
    mt_status status = mt_coverage_list(coverage, reader->arena, &covered, &count);
    if (status == MT_OK) reader->left -= count;
    for (int i = 0; i < count && status == MT_OK && reader->left >= 0; i++)
        status = readers[type](&filling, covered[i]);
    return status;
}
