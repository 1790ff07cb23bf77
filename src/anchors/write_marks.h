/* Marks on bases, on ligatures and on marks as subtables (OpenType spec, "GPOS": lookup types 4 to 6). */
#pragma once

#include "anchors/anchor.h"

/* In parts where 16-bit offsets would not reach. MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_attachment_write(const mt_attachment *attachment, int type, const mt_places *places,
                              mt_arena *arena, mt_subtables *subtables);
