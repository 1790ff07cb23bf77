/* An animation as MP4 or WebM, by the command ffmpeg, which is fed frames through a pipe. */
#pragma once

#include "motion/raster.h"

typedef enum mt_movie_kind { MT_MOVIE_MP4, MT_MOVIE_WEBM } mt_movie_kind;

typedef enum mt_movie_fault {
    MT_MOVIE_FINE,
    MT_MOVIE_MISSING, /* there is no command ffmpeg */
    MT_MOVIE_FAILED,  /* ffmpeg could not make it */
} mt_movie_fault;

/* Makes the file whole or not at all, of as many plays as the timing has, or one where it has no end. Without a background WebM is
 * transparent. MP4 is MT_BAD_PARAMETER without one, and so is a canvas with odd sides. MT_CANNOT_WRITE (errno says why, or *fault),
 * and as mt_raster_play. */
mt_status mt_movie_save(const mt_motion *motion, mt_movie_kind kind, const char *path, mt_movie_fault *fault);
