/* The limits that several files share, each with its unit and its reason. A tolerance of one algorithm stands at the top of its file,
 * one of two files in the header of the lower one. */
#pragma once

/* Grid units in the em. All geometry is in integers on this grid. 256 000 is a common multiple of 1000, 1024,
 * 2000 and 2048, so that nearly every font's own units fall on it exactly, and a unit of a 1000-unit em is
 * 256 of it. */
#define MT_EM 256000

/* Thousandths of the em, in which tolerances are given, as grid units. */
static inline double mt_grid_units(double thousandths) {
    return thousandths * MT_EM / 1000;
}

/* The largest absolute coordinate of an input point, grid units: some 32 em. Differences then fit 25 bits, an
 * orientation 51 bits (int64_t) and an in-circle determinant 103 bits (mt_wide). */
#define MT_COORD_MAX ((1 << 23) - 1)

/* Points in one glyph after flattening. The largest Han glyphs have some 3 000. */
#define MT_POINTS_MAX 1000000

/* Components in one glyph: matching keeps a table of every pair. Braille and dotted faces have some tens. */
#define MT_COMPONENTS_MAX 2048

/* Chords instead of curves move the point where two curves cross at a small angle by much more than the tolerance, or miss
 * the crossing, or cross where the curves do not: there the tolerance is divided by this. */
#define MT_OVERLAP_CARE 8

/* Cells of the table of one alignment (morph/align/align.c) or ring match (morph/divide/ring_matching.c): samples of one ring times
 * samples of the other, 5 or 4 bytes each. Two rings of 8 000 samples are past anything drawn. */
#define MT_ALIGNMENT_MAX (1 << 26)

/* What the morph of one glyph may do, in steps (base/memory.h), and take of memory, with an effort of 1; its outline, once more. A step is some
 * two nanoseconds. Drawings of the same kind take some millions, the most ornate of 500 that are unlike 4 000 millions for all settings. */
#define MT_GLYPH_STEPS ((int64_t)1000000000)
#define MT_GLYPH_BYTES ((size_t)96 << 20)

/* A file of hints: bytes, hints in it, and hints for one glyph. A person sets some ten for a glyph, and needs them for a few
 * hundred glyphs. */
#define MT_HINT_FILE_MAX (1 << 24)
#define MT_HINTS_MAX (1 << 18)
#define MT_GLYPH_HINTS_MAX 256

/* The most glyphs that a TrueType font can hold ('maxp' numGlyphs, uint16). */
#define MT_GLYPHS_MAX 65535

/* What is read of a font's GSUB: substitutions, glyphs in them, and what they are reached by. The largest fonts have some
 * 200 000. And how often two fonts' substitutions are compared before their forms are left as they are paired then. */
#define MT_SUBSTITUTIONS_MAX (1 << 22)
#define MT_COMPARISONS_MAX (1 << 28)

/* Variation sequences that are read of a font. The largest have some 40 000. */
#define MT_VARIATION_SEQUENCES_MAX (1 << 18)

/* The longest name of a glyph that is written, in bytes (Adobe Glyph List specification, section 2). */
#define MT_GLYPH_NAME_MAX 63

/* Contours and points of one output glyph ('glyf' counts and indices are 16-bit). */
#define MT_GLYF_CONTOURS_MAX 32767
#define MT_GLYF_POINTS_MAX 65535

/* A curve is flattened into at least one chord for each so many degrees that it turns, so that a small round
 * stays distinct from a corner (geometry/fit.c) however loose the tolerance. */
#define MT_CHORD_TURN 20.0

/* Where a curve meets a line or a curve, the drawing is smooth if the direction changes by no more than so many degrees, plus
 * what a control point moved by so many grid units (1/1000 em) makes of it: sources round theirs to whole font units. Never by
 * more than the last figure, however small the curve. */
#define MT_SMOOTH_JOIN 2.0
#define MT_SMOOTH_ROUNDING 256.0
#define MT_SMOOTH_JOIN_MOST 10.0

/* What a drawing's smooth vertices, and those of a union's crossings, may turn by and still be taken for a
 * part of a curve, degrees. A smooth vertex turns by up to MT_CHORD_TURN in each of the two drawings; a
 * crossing comes from neither. */
#define MT_SMOOTH_TURN 45.0
#define MT_CROSSING_TURN 20.0

/* A crossing that dents the outline by no more than so many grid units is where two neighbouring sums meet,
 * and is bridged: 1.5/1000 em. */
#define MT_DENT 384

/* Rings whose mean width (twice the area over the length) is under this many grid units are seams of the
 * union, where two sums that should touch were rounded apart: 0.25/1000 em; drawn hairlines are ten times
 * wider. */
#define MT_SEAM_WIDTH 64

/* A component or a hole of a smaller area is a crumb, in square thousandths of the em: a fifth of a pixel at
 * 100 pixels an em, where nobody sees a part of its own. The dots of a light face's i have 4000. */
#define MT_CRUMB 20.0

/* How far the ink of an in-between may leave the range of the ends', relative to the larger end. */
#define MT_INK_EXCESS 0.03

/* Places between the ends at which an in-between's counts are looked at, evenly spaced. */
#define MT_TOPOLOGY_STEPS 19
