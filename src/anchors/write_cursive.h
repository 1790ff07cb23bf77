/* Cursive attachment as subtables (OpenType spec, "GPOS": lookup type 3). */
#pragma once

#include "anchors/anchor.h"

/* In parts where 16-bit offsets would not reach. MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_cursive_write(const mt_cursive *cursive, const mt_places *places, mt_arena *arena,
                           mt_subtables *subtables);
