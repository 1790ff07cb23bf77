/* The key frames of animate: FONT=TEXT or the file of an SVG drawing, as many as there are.
 *
 * FONT is what other commands take, with an = of its own where it has a place on axes or a feature's number. It ends at the last = before
 * which there is a whole font: Inter.ttf@wght=650=A, Serif.otf:salt=2=A, Serif.otf== for an equals sign.
 * TEXT is as in --text: glyphs stand there by their names too (notation.h). A file is a drawing if it looks like XML, whatever its name.
 */
#pragma once

#include "characters.h"
#include "motion/motion.h"
#include "options.h"

typedef struct key_frames {
    int count;
    mt_key list[MT_VARIABLE_FONTS_MAX];
    char *specs[MT_VARIABLE_FONTS_MAX]; /* the fonts' */
    choices texts[MT_VARIABLE_FONTS_MAX];
    mt_svg_drawing drawings[MT_VARIABLE_FONTS_MAX];
    mt_arena arena; /* of the drawings */
    mt_hint_table *hints;
} key_frames;

/* Reads the key frames, and opens their fonts, each once. What a drawing has that is left out is told. DONE or, said, an exit code; either way they are to be closed. */
int key_frames_open(const cli_options *options, key_frames *keys);
void key_frames_close(key_frames *keys);

/* Says why a motion could not be opened, and gives COULD_NOT. */
int key_frames_fail(const cli_options *options, const key_frames *keys, const mt_motion_fault *fault,
                    mt_status status);

/* The colours that the options ask for, or else those of drawings that have one each, and black for others; as many as *count. */
void key_frames_colours(const cli_options *options, const key_frames *keys, mt_colour *colours, int *count);

/* The timing that the options ask for: a second for each stretch, unless they say otherwise. */
mt_timing key_frames_timing(const cli_options *options);
