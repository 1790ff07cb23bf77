/* An animation as GIF ("GIF89a Specification", with the NETSCAPE2.0 extension for plays), by giflib. */
#pragma once

#include "base/buffer.h"
#include "motion/raster.h"

/* GIF counts time in hundredths of a second, and programs slow down what is faster than this. */
#define MT_GIF_FPS_MAX 50

/* Each frame has a palette of the 256 mixes of its two colours, so that no colour is lost. Without a background a pixel is ink or
 * nothing. The bytes are the caller's. As mt_raster_play; MT_BAD_PARAMETER over MT_GIF_FPS_MAX. */
mt_status mt_gif(const mt_motion *motion, mt_buffer *file);
