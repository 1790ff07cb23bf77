#include "motion/webp.h"

#include <math.h>
#include <webp/encode.h>
#include <webp/mux.h>

typedef struct mt_webp_writing {
    const mt_timing *timing;
    WebPAnimEncoder *encoder;
    int end; /* the number of the frame after the last */
} mt_webp_writing;

/* Milliseconds from the start to a frame. */
static int time_of(const mt_webp_writing *w, int frame) {
    return (int)lround(1000.0 * frame / w->timing->fps);
}

static mt_status begin(mt_webp_writing *w, const mt_drawn_frame *frame) {
    WebPAnimEncoderOptions options;
    if (!WebPAnimEncoderOptionsInit(&options)) return MT_NO_MEMORY;
    options.anim_params.loop_count = w->timing->plays;
    w->encoder = WebPAnimEncoderNew(frame->width, frame->height, &options);
    return w->encoder ? MT_OK : MT_NO_MEMORY;
}

static mt_status from_webp(WebPEncodingError error) {
    bool memory = error == VP8_ENC_ERROR_OUT_OF_MEMORY || error == VP8_ENC_ERROR_BITSTREAM_OUT_OF_MEMORY;
    return memory ? MT_NO_MEMORY : MT_TOO_LARGE;
}

static mt_status add_picture(mt_webp_writing *w, const mt_drawn_frame *frame, const uint8_t *pixels) {
    WebPConfig config;
    WebPPicture picture;
    if (!WebPConfigInit(&config) || !WebPConfigLosslessPreset(&config, 6) || !WebPPictureInit(&picture))
        return MT_NO_MEMORY;
    int stride = frame->width * mt_raster_channels(frame);
    picture.use_argb = true;
    picture.width = frame->width;
    picture.height = frame->height;
    bool imported = frame->has_background ? WebPPictureImportRGB(&picture, pixels, stride)
                                          : WebPPictureImportRGBA(&picture, pixels, stride);
    mt_status status = imported ? MT_OK : MT_NO_MEMORY;
    if (imported && !WebPAnimEncoderAdd(w->encoder, &picture, time_of(w, frame->number), &config))
        status = from_webp(picture.error_code);
    WebPPictureFree(&picture);
    return status;
}

static mt_status take(const mt_drawn_frame *frame, void *user) {
    mt_webp_writing *w = user;
    mt_arena arena = {0};
    mt_status status = w->encoder ? MT_OK : begin(w, frame);
    const uint8_t *pixels = status == MT_OK ? mt_raster_pixels(frame, &arena) : NULL;
    if (status == MT_OK) status = pixels ? add_picture(w, frame, pixels) : MT_NO_MEMORY;
    w->end = frame->number + frame->length;
    mt_arena_release(&arena);
    return status;
}

static mt_status finish(mt_webp_writing *w, mt_buffer *file) {
    WebPData data;
    WebPDataInit(&data);
    bool made = WebPAnimEncoderAdd(w->encoder, NULL, time_of(w, w->end), NULL) &&
                WebPAnimEncoderAssemble(w->encoder, &data);
    mt_status status = made ? mt_buffer_add(file, data.bytes, data.size) : MT_NO_MEMORY;
    WebPDataClear(&data);
    return status;
}

mt_status mt_webp(const mt_motion *motion, mt_buffer *file) {
    mt_webp_writing w = {.timing = &motion->request.timing};
    *file = (mt_buffer){0};
    mt_status status = mt_raster_play(motion, take, &w);
    if (status == MT_OK) status = finish(&w, file);
    WebPAnimEncoderDelete(w.encoder);
    return status;
}
