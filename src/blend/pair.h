/* One glyph between two neighbours of a row: read from both fonts, its hints found, its morph prepared. Blends, variable
 * fonts, reports and inspections all take it from here; any place between the two is then asked of the morph. */
#pragma once

#include "blend/row.h"
#include "morph/check/reach.h"
#include "morph/model/morph.h"
#include "write/font_data.h"

/* The room that a glyph takes in a line, grid units. */
typedef struct mt_glyph_room {
    double advance;
    mt_vertical vertical;
} mt_glyph_room;

typedef struct mt_glyph_pair {
    mt_shape a, b;
    mt_glyph_room room_a, room_b;
    mt_morph morph;
    int at_fault; /* why it could not be prepared: 0 for A's glyph, 1 for B's; -1 for neither alone */
} mt_glyph_pair;

/* Reads the room that both glyphs take between fonts number `step` and step + 1: 0 where it cannot be read. With
 * MT_NO_PARTNER for `b` both rooms are A's. MT_NO_MEMORY. */
mt_status mt_pair_read_rooms(mt_row *row, int step, uint32_t a, uint32_t b, mt_glyph_pair *pair);

/* Fills in by how much each font leans more than the one before, once; with MT_METHOD_PAPER, which does not ask, 0. Reads the fonts: under the row's lock, or before work begins.
 * MT_NO_MEMORY. */
mt_status mt_row_find_leans(mt_row *row);

/* Bounds what is done with one glyph in this arena from here on: the row's effort (MT_GLYPH_STEPS, MT_GLYPH_BYTES). */
void mt_pair_allow(const mt_row *row, mt_arena *arena);

/* Reads both glyphs' shapes and advances, and prepares their morph by their hints, in the arena; with MT_NO_PARTNER for `b`
 * it reads A's shape and advance alone. A shape that cannot be read is empty. All of it within an
 * allowance: where it is spent, the morph is the best until then (cut_short), or MT_TOO_COSTLY. MT_STOPPED; as mt_font_outline, mt_outline_shape and mt_morph_prepare. */
mt_status mt_pair_prepare(mt_row *row, int step, uint32_t a, uint32_t b, mt_arena *arena,
                          mt_glyph_pair *pair);

/* The same by these hints in place of the row's. */
mt_status mt_pair_prepare_by(mt_row *row, int step, uint32_t a, uint32_t b, const mt_hints *hints,
                             mt_arena *arena, mt_glyph_pair *pair);

/* The same of a character between the first two fonts, or of a row's one font. MT_NO_GLYPH when a font lacks it. */
mt_status mt_pair_prepare_char(mt_row *row, uint32_t code_point, mt_arena *arena, mt_glyph_pair *pair);

/* How far past its ends a prepared pair goes on: as its morph does (check/reach.h), and as far as its room is not less than none.
 * As mt_morph_reach. */
mt_status mt_pair_reach(const mt_glyph_pair *pair, mt_reach wanted, const mt_params *params, mt_arena *arena,
                        mt_reach *reach);

/* Where the pair stands for a place that is asked for: there, or as near as it goes: along `reach`, which is that of the pair, and from there
 * aside (check/reach.h), as far as its room is not less than none. As mt_morph_aside. */
mt_status mt_pair_stand(const mt_glyph_pair *pair, mt_reach reach, mt_at asked, const mt_params *params,
                        mt_arena *arena, mt_at *stands);

/* The room at a place between two glyphs: advances of lines across, and those of vertical ones. */
static inline mt_glyph_room mt_room_between(const mt_glyph_room *a, const mt_glyph_room *b, mt_at at) {
    return (mt_glyph_room){(1 - at.x) * a->advance + at.x * b->advance,
                           {(1 - at.y) * a->vertical.advance + at.y * b->vertical.advance,
                            (1 - at.y) * a->vertical.origin + at.y * b->vertical.origin}};
}
