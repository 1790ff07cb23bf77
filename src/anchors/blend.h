/* Marks on bases, on ligatures and on marks, of all fonts in one. */
#pragma once

#include "anchors/rivals.h"

/* Adds what becomes of a subtable of A's to the lookup; `rivals` are those of each font, none of the first. MT_NO_MEMORY. */
mt_status mt_attachment_blend(mt_anchor_job *job, mt_bytes subtable, const mt_rivals *rivals,
                              mt_anchor_lookup *lookup);
