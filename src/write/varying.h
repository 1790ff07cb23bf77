/* The metrics of a varying font: what its default has, and HVAR, VVAR and MVAR with what each other stop adds to it.
 * Stops are those of stops.h, in the order of tables; each has its own metrics, of a whole font in the same glyphs and units. */
#pragma once

#include "base/memory.h"
#include "sfnt/sfnt.h"
#include "sfnt/stops.h"
#include "write/font_data.h"

/* Gives each stop one height of lines, that in use there: OS/2's typographic lines and hhea's are the same, and the
 * former are used. For MVAR's "hasc", "hdsc" and "hlgp" are of OS/2, and readers add them to whichever lines they use. */
void mt_varying_lines(mt_metrics *stops, int stop_count);

/* Gives each stop a caret that rises as far as that of any: where one leans (its rise is the em then) the others lean by none
 * of it, and only the run varies. */
void mt_varying_caret(mt_metrics *stops, int stop_count);

/* HVAR and VVAR: the advances of `glyph_count` glyphs at each stop, those of glyphs[0] being the default. Of bearings both have
 * nothing: these follow from the outlines, and from gvar's points for the origins. In the arena. MT_NO_MEMORY,
 * MT_TOO_LARGE. */
mt_status mt_hvar_write(mt_glyf *const *glyphs, const mt_stops *stops, int glyph_count, mt_arena *arena,
                        mt_bytes *hvar);
mt_status mt_vvar_write(mt_glyf *const *glyphs, const mt_stops *stops, int glyph_count, mt_arena *arena,
                        mt_bytes *vvar);

/* MVAR: the font-wide figures that have a tag there and are not the same at all stops; vhea's where the first stop has
 * vertical metrics. In the arena; no bytes where nothing varies. MT_NO_MEMORY,
 * MT_TOO_LARGE. */
mt_status mt_mvar_write(const mt_metrics *metrics, const mt_stops *stops, mt_arena *arena, mt_bytes *mvar);
