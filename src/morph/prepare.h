/* From two shapes to a morph: done once, before any place between them. */
#pragma once

#include "morph/model/morph.h"

/* Matches, joins where the method is MT_METHOD_JOINT, decomposes and links; `hints`, unless NULL, decide first. Everything lives in the
 * arena, and the shapes must stay as long as the morph. MT_NO_MEMORY, MT_TOO_LARGE, MT_BAD_GEOMETRY; MT_NO_COUNTERPART when one shape
 * has ink and the other none. */
mt_status mt_morph_prepare(const mt_shape *a, const mt_shape *b, const mt_hints *hints,
                           const mt_params *params, mt_arena *arena, mt_morph *morph);
