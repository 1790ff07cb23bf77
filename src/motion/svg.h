/* An animation as SVG. It has no script and fetches nothing. */
#pragma once

#include "base/buffer.h"
#include "motion/motion.h"

/* By SMIL: animate elements with key times (W3C, "SVG Animations Level 2"). The bytes are the caller's. MT_NO_MEMORY, and as mt_runs_make. */
mt_status mt_svg_smil(const mt_motion *motion, mt_buffer *file);
/* By CSS: keyframes of the property d ("SVG 2", 9.3.1). */
mt_status mt_svg_css(const mt_motion *motion, mt_buffer *file);
/* One moment, without motion; path commands are those of every moment on its stretch. */
mt_status mt_svg_still(const mt_motion *motion, mt_moment moment, mt_buffer *file);
