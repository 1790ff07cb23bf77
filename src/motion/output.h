/* An animation's files: one in the format of its extension, or numbered ones. */
#pragma once

#include "motion/motion.h"
#include "motion/movie.h"

typedef enum mt_motion_format {
    MT_MOTION_SVG,
    MT_MOTION_PNG, /* numbered frames */
    MT_MOTION_APNG,
    MT_MOTION_GIF,
    MT_MOTION_WEBP,
    MT_MOTION_LOTTIE, /* .json */
    MT_MOTION_MP4,
    MT_MOTION_WEBM,
} mt_motion_format;

/* The format that a file name's extension asks for, in either case. False for any other. */
bool mt_motion_format_of(const char *path, mt_motion_format *format);

typedef struct mt_motion_output {
    const char
        *path; /* of numbered files, NAME.png for NAME-1.png and so on, with as many digits as the last has */
    bool css;  /* SVG that moves by CSS, not by SMIL */
    int steps; /* stills at so many evenly spaced places, SVG or PNG; 0: the animation */
} mt_motion_output;

/* What was written, or where it went wrong. */
typedef struct mt_motion_outcome {
    int files;
    size_t length; /* bytes, of all of them; 0 for a movie */
    mt_movie_fault movie;
} mt_motion_outcome;

/* Writes all files or none. MT_UNKNOWN_FORMAT, MT_CANNOT_WRITE (errno says why, or outcome->movie), and what the formats give. */
mt_status mt_motion_save(const mt_motion *motion, const mt_motion_output *output, mt_motion_outcome *outcome);
