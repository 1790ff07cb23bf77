/* PNG and animated PNG (W3C, "Portable Network Graphics", third edition, section 11.3.4.2), by zlib. */
#pragma once

#include "base/buffer.h"
#include "motion/raster.h"

/* A frame as a picture by itself. The bytes are the caller's. MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_png(const mt_drawn_frame *frame, mt_buffer *file);

/* A play as an animated PNG, which shows its first frame where animations are not known. As mt_raster_play. */
mt_status mt_apng(const mt_motion *motion, mt_buffer *file);
