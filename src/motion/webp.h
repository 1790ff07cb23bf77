/* An animation as WebP, without loss, by libwebp. */
#pragma once

#include "base/buffer.h"
#include "motion/raster.h"

/* The bytes are the caller's. As mt_raster_play; MT_TOO_LARGE for what WebP cannot hold. */
mt_status mt_webp(const mt_motion *motion, mt_buffer *file);
