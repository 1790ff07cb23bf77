#include "motion/output.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

#include "base/file.h"
#include "base/file_set.h"
#include "motion/gif.h"
#include "motion/lottie.h"
#include "motion/png.h"
#include "motion/svg.h"
#include "motion/webp.h"

bool mt_motion_format_of(const char *path, mt_motion_format *format) {
    static const char *const extensions[] = {".svg",  ".png",  ".apng", ".gif",
                                             ".webp", ".json", ".mp4",  ".webm"};
    const char *dot = strrchr(path, '.');
    for (size_t i = 0; dot && i < sizeof extensions / sizeof *extensions; i++) {
        if (strcasecmp(dot, extensions[i]) != 0) continue;
        *format = (mt_motion_format)i;
        return true;
    }
    return false;
}

/* ---- one file ------------------------------------------------------------------------------------------ */

static mt_status make_file(const mt_motion *motion, mt_motion_format format, bool css, mt_buffer *file) {
    switch (format) {
    case MT_MOTION_SVG: return css ? mt_svg_css(motion, file) : mt_svg_smil(motion, file);
    case MT_MOTION_APNG: return mt_apng(motion, file);
    case MT_MOTION_GIF: return mt_gif(motion, file);
    case MT_MOTION_WEBP: return mt_webp(motion, file);
    default: return mt_lottie(motion, file);
    }
}

static mt_status save_file(const mt_motion *motion, mt_motion_format format, const mt_motion_output *output,
                           mt_motion_outcome *outcome) {
    mt_buffer file = {0};
    mt_status status = make_file(motion, format, output->css, &file);
    if (status == MT_OK) status = mt_file_write(output->path, file.bytes, file.length);
    int why = errno;
    *outcome = (mt_motion_outcome){.files = 1, .length = file.length};
    mt_buffer_free(&file);
    errno = why;
    return status;
}

/* ---- numbered files ------------------------------------------------------------------------------------ */

typedef struct mt_numbered {
    const mt_motion_output *output;
    int digits;
    mt_file_set set;
    char *path; /* room for a file's */
} mt_numbered;

static void set_path(mt_numbered *files, int number) {
    const char *path = files->output->path, *dot = strrchr(path, '.');
    sprintf(files->path, "%.*s-%0*d%s", (int)(dot - path), path, files->digits, number, dot);
}

static mt_status begin(const mt_motion_output *output, int count, mt_numbered *files) {
    enum { NUMBER_ROOM = 16 };
    char last[NUMBER_ROOM];
    *files = (mt_numbered){.output = output,
                           .digits = snprintf(last, sizeof last, "%d", count),
                           .path = mt_new(strlen(output->path) + NUMBER_ROOM, 1)};
    mt_status status = files->path ? mt_file_set_begin(output->path, &files->set) : MT_NO_MEMORY;
    if (status != MT_OK) mt_free(files->path);
    return status;
}

static mt_status write_next(mt_numbered *files, const mt_buffer *file) {
    set_path(files, files->set.count + 1);
    return mt_file_set_add(&files->set, files->path, file->bytes, file->length);
}

/* Places the files, or removes them where not all could be written. */
static mt_status end(mt_numbered *files, mt_status status, mt_motion_outcome *outcome) {
    int failed;
    if (status == MT_OK) status = mt_file_set_place(&files->set, &failed);
    int why = errno;
    *outcome = (mt_motion_outcome){.files = files->set.count, .length = files->set.folder.length};
    mt_file_set_free(&files->set);
    mt_free(files->path);
    errno = why;
    return status;
}

/* Takes a frame as often as it is shown. */
static mt_status take_frame(const mt_drawn_frame *frame, void *user) {
    mt_buffer file;
    mt_status status = mt_png(frame, &file);
    if (status != MT_OK) return status;
    for (int i = 0; i < frame->length && status == MT_OK; i++) status = write_next(user, &file);
    mt_buffer_free(&file);
    return status;
}

static mt_status count_frames(const mt_motion *motion, int *count) {
    mt_arena arena = {0};
    mt_timed_frames frames;
    mt_status status = mt_timeline_frames(&motion->timeline, &motion->request.timing, &arena, &frames);
    if (status == MT_OK) *count = frames.all;
    mt_arena_release(&arena);
    return status;
}

static mt_status save_frames(const mt_motion *motion, const mt_motion_output *output,
                             mt_motion_outcome *outcome) {
    int count;
    mt_numbered files;
    mt_status status = count_frames(motion, &count);
    if (status == MT_OK) status = begin(output, count, &files);
    return status == MT_OK ? end(&files, mt_raster_play(motion, take_frame, &files), outcome) : status;
}

static mt_status make_still(const mt_motion *motion, mt_motion_format format, mt_moment moment,
                            mt_buffer *file) {
    mt_arena arena = {0};
    mt_drawn_frame frame;
    if (format == MT_MOTION_SVG) return mt_svg_still(motion, moment, file);
    mt_status status = mt_raster_draw(motion, moment, &arena, &frame);
    if (status == MT_OK) status = mt_png(&frame, file);
    mt_arena_release(&arena);
    return status;
}

static mt_status save_stills(const mt_motion *motion, mt_motion_format format, const mt_motion_output *output,
                             mt_motion_outcome *outcome) {
    mt_numbered files;
    mt_status status = begin(output, output->steps, &files);
    if (status != MT_OK) return status;
    for (int i = 0; i < output->steps && status == MT_OK; i++) {
        mt_buffer file = {0};
        double place = (double)motion->stretch_count * i / (output->steps - 1);
        status = make_still(motion, format, mt_moment_of(place, motion->stretch_count), &file);
        if (status == MT_OK) status = write_next(&files, &file);
        mt_buffer_free(&file);
    }
    return end(&files, status, outcome);
}

mt_status mt_motion_save(const mt_motion *motion, const mt_motion_output *output,
                         mt_motion_outcome *outcome) {
    mt_motion_format format;
    *outcome = (mt_motion_outcome){0};
    if (!mt_motion_format_of(output->path, &format)) return MT_UNKNOWN_FORMAT;
    bool stills = format == MT_MOTION_SVG || format == MT_MOTION_PNG;
    if (output->steps && (output->steps < 2 || !stills)) return MT_BAD_PARAMETER;
    if (output->steps) return save_stills(motion, format, output, outcome);
    if (format == MT_MOTION_PNG) return save_frames(motion, output, outcome);
    if (format != MT_MOTION_MP4 && format != MT_MOTION_WEBM)
        return save_file(motion, format, output, outcome);
    outcome->files = 1;
    return mt_movie_save(motion, format == MT_MOTION_MP4 ? MT_MOVIE_MP4 : MT_MOVIE_WEBM, output->path,
                         &outcome->movie);
}
