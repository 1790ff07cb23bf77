/* morphotype animate: what moves from one key frame to the next. */
#include "commands.h"
#include "key_frames.h"
#include "messages.h"
#include "motion/gif.h"
#include "motion/output.h"
#include "sources.h"
#include "work.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

/* ---- what is asked ------------------------------------------------------------------------------------- */

static bool is_movie(mt_motion_format format) {
    return format == MT_MOTION_MP4 || format == MT_MOTION_WEBM;
}

static int check_format(const cli_options *options, mt_motion_format format) {
    const char *output = options->output;
    bool stills = format == MT_MOTION_SVG || format == MT_MOTION_PNG;
    const cli_motion *motion = &options->motion;
    if (motion->css && format != MT_MOTION_SVG)
        return misuse(options->command, "-o %s: --css is for .svg", output);
    if (options->steps && !stills)
        return misuse(options->command, "-o %s: --steps is for .svg and .png", output);
    if (options->steps && motion->css)
        return misuse(options->command, "--css and --steps exclude each other");
    if (format == MT_MOTION_GIF && motion->timing.fps > MT_GIF_FPS_MAX)
        return misuse(options->command, "-o %s: a GIF has at most %d frames a second", output,
                      MT_GIF_FPS_MAX);
    if (format == MT_MOTION_MP4 && !motion->has_background)
        return misuse(options->command, "-o %s: an MP4 has a background", output);
    if (is_movie(format) && (motion->width % 2 || motion->height % 2))
        return misuse(options->command, "-o %s: a video's sides are even numbers", output);
    return DONE;
}

static int check(const cli_options *options) {
    mt_motion_format format;
    int colours = options->motion.colour_count, keys = options->font_count;
    if (!options->output)
        return misuse(options->command, "-o OUT.svg|json|apng|gif|webp|png|mp4|webm is wanted");
    if (!mt_motion_format_of(options->output, &format))
        return misuse(options->command,
                      "-o %s: animate writes .svg, .json, .apng, .gif, .webp, .png, .mp4 and .webm",
                      options->output);
    if (keys < 2) return misuse(options->command, "two key frames are wanted: FONT=TEXT or DRAWING.svg");
    if (colours > 2 && colours != keys)
        return misuse(options->command, "--color: %d colours for %d key frames", colours, keys);
    return check_format(options, format);
}

/* ---- the work ------------------------------------------------------------------------------------------ */

/* Parts that could not be morphed are told; with --strict they are an error. */
static int tell_failures(const cli_options *options, const mt_motion *motion) {
    int count = 0;
    mt_status why = MT_OK;
    for (int i = 0; i < motion->stretch_count; i++)
        for (int k = 0; k < motion->stretches[i].pairs.count; k++) {
            mt_status failed = motion->stretches[i].parts[k].failed;
            count += failed != MT_OK;
            if (failed != MT_OK) why = failed;
        }
    if (count == 0) return DONE;
    if (options->strict)
        return fail("%d part%s could not be morphed: %s; nothing written (--strict)", count,
                    count == 1 ? "" : "s", mt_status_text(why));
    if (!options->quiet)
        say("%d part%s could not be morphed: %s; the one shrinks while the other grows", count,
            count == 1 ? "" : "s", mt_status_text(why));
    return DONE;
}

static int fail_to_write(const cli_options *options, mt_status status, mt_movie_fault movie) {
    if (movie == MT_MOVIE_MISSING)
        return fail("%s: the command ffmpeg makes .mp4 and .webm, and is not installed", options->output);
    if (movie == MT_MOVIE_FAILED) return fail("%s: ffmpeg could not make it", options->output);
    if (status == MT_TOO_LARGE)
        return fail("%s: too large: over %d frames in a play, over 2^35 pixels in all of them, or over 2^22 "
                    "segments at all key times",
                    options->output, MT_FRAMES_MAX);
    return fail_status(options->output, status);
}

static int save(const cli_options *options, const mt_motion *motion) {
    mt_motion_output output = {options->output, options->motion.css, options->steps};
    mt_motion_outcome outcome;
    int told = tell_failures(options, motion);
    if (told != DONE) return told;
    errno = 0;
    mt_status status = mt_motion_save(motion, &output, &outcome);
    if (status != MT_OK) return fail_to_write(options, status, outcome.movie);
    if (options->verbose)
        say("%s: %d file%s, %d x %d pixels, %g s a play, %zu bytes", options->output, outcome.files,
            outcome.files == 1 ? "" : "s", motion->page.width, motion->page.height, motion->timeline.length,
            outcome.length);
    return DONE;
}

/* `colours` has room for one of each key frame. */
static mt_motion_request request_of(const cli_options *options, const key_frames *keys, mt_colour *colours) {
    int colour_count;
    key_frames_colours(options, keys, colours, &colour_count);
    const cli_motion *motion = &options->motion;
    return (mt_motion_request){.key_count = keys->count,
                               .keys = keys->list,
                               .params = options->params,
                               .hints = keys->hints,
                               .timing = key_frames_timing(options),
                               .page = {options->size, motion->width, motion->height},
                               .colour_count = colour_count,
                               .colours = colours,
                               .has_background = motion->has_background,
                               .background = motion->background};
}

static int animate(const cli_options *options, const key_frames *keys) {
    mt_motion motion;
    mt_motion_fault fault;
    mt_colour colours[MT_VARIABLE_FONTS_MAX];
    progress bar = progress_begin(options->quiet, "parts");
    mt_motion_request request = request_of(options, keys, colours);
    request.progress = progress_draw;
    request.progress_user = &bar;
    mt_status status = mt_motion_open(&request, &motion, &fault);
    progress_erase(&bar);
    int outcome = status == MT_OK ? save(options, &motion) : key_frames_fail(options, keys, &fault, status);
    mt_motion_close(&motion);
    return outcome;
}

/* Whether files with numbers are written: as many as steps, or a number that the frames will tell. */
static bool is_numbered(const cli_options *options) {
    mt_motion_format format;
    return options->steps || (mt_motion_format_of(options->output, &format) && format == MT_MOTION_PNG);
}

static int run(cli_options *options) {
    key_frames keys;
    int outcome = check(options);
    if (outcome == DONE && !options->steps) outcome = output_check(options->output);
    if (outcome == DONE && options->steps) outcome = directory_check(options->output);
    if (outcome == DONE && is_numbered(options))
        outcome = sources_spare_numbered(options, options->output, options->steps);
    if (outcome != DONE) return outcome;
    outcome = key_frames_open(options, &keys);
    if (outcome == DONE) outcome = animate(options, &keys);
    key_frames_close(&keys);
    return outcome;
}

const cli_command animate_command = {
    .name = "animate",
    .summary = "an animation from one drawing to the next",
    .synopsis = "KEY KEY [KEY...] -o OUT [OPTION...]",
    .text = "Key frames follow one another. KEY is FONT=TEXT or an SVG drawing. TEXT is a character or a "
            "word; /name is a glyph by its name, and /a/b are two glyphs."
            "\nOUT.svg moves by SMIL, or with --css by CSS; OUT.json is Lottie; OUT.apng, .gif and .webp "
            "are pictures that move, .mp4 and .webm videos by an installed ffmpeg, and OUT.png numbered "
            "frames: OUT-01.png and so on.",
    .examples = {{"From a letter to another and back, as SVG:",
                  "morphotype animate A.ttf=g B.otf=8 --yoyo -o g-8.svg"},
                 {"From a word to a word, at rest for half a second at each:",
                  "morphotype animate A.ttf=type B.otf=Morph --hold 0.5 --yoyo -o words.webp"}},
    .reads = CLI_FONT_FILES " svg",
    .writes = "svg json apng gif webp png mp4 webm",
    .takes = "onzSDUeOdNyCkbK",
    .fonts_min = 0,
    .fonts_max = MT_VARIABLE_FONTS_MAX,
    .run = run,
};
