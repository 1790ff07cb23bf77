/* An animation as Lottie: the JSON that players of animated vectors read (lottie.github.io, "Lottie Specs" 1.0). */
#pragma once

#include "base/buffer.h"
#include "motion/motion.h"

/* The bytes are the caller's. How often it plays is the player's to say. MT_NO_MEMORY. */
mt_status mt_lottie(const mt_motion *motion, mt_buffer *file);
