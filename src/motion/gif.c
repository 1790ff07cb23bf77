#include "motion/gif.h"

#include <gif_lib.h>
#include <math.h>

enum { MIXES = 256, HALF = 128, BITS = 8 };

typedef struct mt_gif_writing {
    mt_buffer *file;
    const mt_timing *timing;
    GifFileType *gif;
    ColorMapObject *palette;
    mt_status status; /* of the buffer */
} mt_gif_writing;

static int write_bytes(GifFileType *gif, const GifByteType *bytes, int length) {
    mt_gif_writing *w = gif->UserData;
    if (w->status == MT_OK) w->status = mt_buffer_add(w->file, bytes, (size_t)length);
    return w->status == MT_OK ? length : 0;
}

/* giflib fails when the buffer does, or when memory runs out. */
static mt_status from_gif(int outcome) {
    return outcome == GIF_OK ? MT_OK : MT_NO_MEMORY;
}

/* What plays it more than once: a sub-block with how often again, 0 for ever. */
static mt_status add_plays(mt_gif_writing *w) {
    unsigned again = w->timing->plays > 0 ? (unsigned)w->timing->plays - 1 : 0;
    const uint8_t loop[3] = {1, (uint8_t)again, (uint8_t)(again >> 8)};
    if (w->timing->plays == 1) return MT_OK;
    bool added = EGifPutExtensionLeader(w->gif, APPLICATION_EXT_FUNC_CODE) == GIF_OK &&
                 EGifPutExtensionBlock(w->gif, 11, "NETSCAPE2.0") == GIF_OK &&
                 EGifPutExtensionBlock(w->gif, sizeof loop, loop) == GIF_OK &&
                 EGifPutExtensionTrailer(w->gif) == GIF_OK;
    return added ? MT_OK : MT_NO_MEMORY;
}

static mt_status begin(mt_gif_writing *w, const mt_drawn_frame *frame) {
    int error;
    w->palette = GifMakeMapObject(MIXES, NULL);
    w->gif = EGifOpen(w, write_bytes, &error);
    if (!w->palette || !w->gif) return MT_NO_MEMORY;
    EGifSetGifVersion(w->gif, true);
    mt_status status = from_gif(EGifPutScreenDesc(w->gif, frame->width, frame->height, BITS, 0, NULL));
    return status == MT_OK ? add_plays(w) : status;
}

/* Hundredths of a second from the start to a frame. */
static long time_of(const mt_gif_writing *w, int frame) {
    return lround(100.0 * frame / w->timing->fps);
}

static mt_status add_control(mt_gif_writing *w, const mt_drawn_frame *frame) {
    long delay = time_of(w, frame->number + frame->length) - time_of(w, frame->number);
    GraphicsControlBlock control = {.DisposalMode =
                                        frame->has_background ? DISPOSE_DO_NOT : DISPOSE_BACKGROUND,
                                    .DelayTime = delay < UINT16_MAX ? (int)delay : UINT16_MAX,
                                    .TransparentColor = frame->has_background ? NO_TRANSPARENT_COLOR : 0};
    GifByteType bytes[4];
    size_t length = EGifGCBToExtension(&control, bytes);
    return from_gif(EGifPutExtension(w->gif, GRAPHICS_EXT_FUNC_CODE, (int)length, bytes));
}

/* Colour i has i of 255 parts of ink; without a background each is ink, but for the first, which is not seen. */
static void fill_palette(mt_gif_writing *w, const mt_drawn_frame *frame) {
    for (int i = 0; i < MIXES; i++) {
        mt_colour colour =
            frame->has_background ? mt_colour_mix(frame->background, frame->ink, i / 255.0) : frame->ink;
        w->palette->Colors[i] = (GifColorType){colour.red, colour.green, colour.blue};
    }
}

/* Without a background a pixel is seen where at least half of it is ink. */
static void cut_rows(const mt_drawn_frame *frame) {
    size_t count = (size_t)frame->width * (size_t)frame->height;
    for (size_t i = 0; !frame->has_background && i < count; i++)
        frame->coverage[i] = frame->coverage[i] >= HALF ? UINT8_MAX : 0;
}

static mt_status add_rows(mt_gif_writing *w, const mt_drawn_frame *frame) {
    cut_rows(frame);
    mt_status status =
        from_gif(EGifPutImageDesc(w->gif, 0, 0, frame->width, frame->height, false, w->palette));
    for (int y = 0; status == MT_OK && y < frame->height; y++)
        status =
            from_gif(EGifPutLine(w->gif, frame->coverage + (size_t)y * (size_t)frame->width, frame->width));
    return status;
}

static mt_status take(const mt_drawn_frame *frame, void *user) {
    mt_gif_writing *w = user;
    mt_status status = w->gif ? MT_OK : begin(w, frame);
    if (status == MT_OK) fill_palette(w, frame);
    if (status == MT_OK) status = add_control(w, frame);
    return status == MT_OK ? add_rows(w, frame) : status;
}

mt_status mt_gif(const mt_motion *motion, mt_buffer *file) {
    mt_gif_writing w = {.file = file, .timing = &motion->request.timing};
    int error;
    *file = (mt_buffer){0};
    if (w.timing->fps > MT_GIF_FPS_MAX) return MT_BAD_PARAMETER;
    mt_status status = mt_raster_play(motion, take, &w);
    if (w.gif && EGifCloseFile(w.gif, &error) != GIF_OK && status == MT_OK) status = MT_NO_MEMORY;
    GifFreeMapObject(w.palette);
    if (status == MT_OK) status = w.status;
    if (status != MT_OK) mt_buffer_free(file);
    return status;
}
