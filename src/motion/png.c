/* Rows are filtered by what is above them (section 9.2, "Up"): most of a letter is as the row before. */
#include "motion/png.h"

#include <string.h>
#include <zlib.h>

enum { FILTER_UP = 2, COLOURS = 2, COLOURS_ALPHA = 6, CHUNK_HEAD = 8 };

static void put_u32(uint8_t *bytes, uint32_t value) {
    for (int i = 0; i < 4; i++) bytes[i] = (uint8_t)(value >> (24 - 8 * i));
}

static void put_u16(uint8_t *bytes, unsigned value) {
    bytes[0] = (uint8_t)(value >> 8);
    bytes[1] = (uint8_t)value;
}

/* A chunk of `head` and then `body`. */
static mt_status add_chunk(mt_buffer *file, const char *type, const uint8_t *head, size_t head_length,
                           const uint8_t *body, size_t body_length) {
    uint8_t start[CHUNK_HEAD], end[4];
    if (head_length + body_length > INT32_MAX) return MT_TOO_LARGE;
    put_u32(start, (uint32_t)(head_length + body_length));
    memcpy(start + 4, type, 4);
    uLong sum = crc32(0, start + 4, 4);
    if (head_length) sum = crc32(sum, head, (uInt)head_length);
    if (body_length) sum = crc32(sum, body, (uInt)body_length);
    put_u32(end, (uint32_t)sum);
    mt_status status = mt_buffer_add(file, start, sizeof start);
    if (status == MT_OK && head_length) status = mt_buffer_add(file, head, head_length);
    if (status == MT_OK && body_length) status = mt_buffer_add(file, body, body_length);
    return status == MT_OK ? mt_buffer_add(file, end, sizeof end) : status;
}

static mt_status add_header(mt_buffer *file, const mt_drawn_frame *frame) {
    static const uint8_t signature[8] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    uint8_t header[13] = {0};
    put_u32(header, (uint32_t)frame->width);
    put_u32(header + 4, (uint32_t)frame->height);
    header[8] = 8;
    header[9] = frame->has_background ? COLOURS : COLOURS_ALPHA;
    mt_status status = mt_buffer_add(file, signature, sizeof signature);
    return status == MT_OK ? add_chunk(file, "IHDR", header, sizeof header, NULL, 0) : status;
}

static mt_status add_end(mt_buffer *file) {
    return add_chunk(file, "IEND", NULL, 0, NULL, 0);
}

/* The filtered rows; NULL without memory. */
static uint8_t *filter(const mt_drawn_frame *frame, mt_arena *arena, size_t *length) {
    size_t stride = (size_t)frame->width * (size_t)mt_raster_channels(frame);
    size_t height = (size_t)frame->height;
    const uint8_t *pixels = mt_raster_pixels(frame, arena);
    uint8_t *rows = mt_arena_new(arena, height, stride + 1);
    if (!pixels || !rows) return NULL;
    for (size_t y = 0; y < height; y++) {
        uint8_t *row = rows + y * (stride + 1);
        const uint8_t *own = pixels + y * stride;
        row[0] = FILTER_UP;
        for (size_t i = 0; i < stride; i++) row[i + 1] = (uint8_t)(own[i] - (y ? own[i - stride] : 0));
    }
    *length = height * (stride + 1);
    return rows;
}

/* The frame's pixels as they stand in IDAT. */
static mt_status compress_frame(const mt_drawn_frame *frame, mt_arena *arena, uint8_t **packed,
                                size_t *length) {
    size_t plain;
    uint8_t *rows = filter(frame, arena, &plain);
    if (!rows) return MT_NO_MEMORY;
    uLongf room = compressBound((uLong)plain);
    uint8_t *bytes = mt_arena_new(arena, room, 1);
    if (!bytes || compress2(bytes, &room, rows, (uLong)plain, Z_BEST_COMPRESSION) != Z_OK)
        return MT_NO_MEMORY;
    *packed = bytes;
    *length = room;
    return MT_OK;
}

mt_status mt_png(const mt_drawn_frame *frame, mt_buffer *file) {
    mt_arena arena = {0};
    uint8_t *packed;
    size_t length;
    *file = (mt_buffer){0};
    mt_status status = compress_frame(frame, &arena, &packed, &length);
    if (status == MT_OK) status = add_header(file, frame);
    if (status == MT_OK) status = add_chunk(file, "IDAT", NULL, 0, packed, length);
    if (status == MT_OK) status = add_end(file);
    mt_arena_release(&arena);
    if (status != MT_OK) mt_buffer_free(file);
    return status;
}

/* ---- animated ------------------------------------------------------------------------------------------ */

typedef struct mt_apng_writing {
    mt_buffer *file;
    const mt_timing *timing;
    int frames;        /* of the play */
    uint32_t sequence; /* of the next chunk that counts */
} mt_apng_writing;

static mt_status add_control(mt_apng_writing *w) {
    uint8_t control[8];
    put_u32(control, (uint32_t)w->frames);
    put_u32(control + 4, (uint32_t)w->timing->plays);
    return add_chunk(w->file, "acTL", control, sizeof control, NULL, 0);
}

static mt_status add_frame_control(mt_apng_writing *w, const mt_drawn_frame *frame) {
    uint8_t control[26] = {0}; /* at (0, 0), put in place of what was there */
    put_u32(control, w->sequence++);
    put_u32(control + 4, (uint32_t)frame->width);
    put_u32(control + 8, (uint32_t)frame->height);
    put_u16(control + 20, (unsigned)frame->length);
    put_u16(control + 22, (unsigned)w->timing->fps);
    return add_chunk(w->file, "fcTL", control, sizeof control, NULL, 0);
}

static mt_status add_pixels(mt_apng_writing *w, const mt_drawn_frame *frame) {
    mt_arena arena = {0};
    uint8_t *packed, number[4];
    size_t length;
    mt_status status = compress_frame(frame, &arena, &packed, &length);
    put_u32(number, w->sequence);
    if (status == MT_OK && frame->number == 0)
        status = add_chunk(w->file, "IDAT", NULL, 0, packed, length);
    else if (status == MT_OK)
        status = add_chunk(w->file, "fdAT", number, sizeof number, packed, length);
    if (frame->number > 0) w->sequence++;
    mt_arena_release(&arena);
    return status;
}

static mt_status take(const mt_drawn_frame *frame, void *user) {
    mt_apng_writing *w = user;
    mt_status status = MT_OK;
    if (frame->number == 0) {
        status = add_header(w->file, frame);
        if (status == MT_OK) status = add_control(w);
    }
    if (status == MT_OK) status = add_frame_control(w, frame);
    return status == MT_OK ? add_pixels(w, frame) : status;
}

static mt_status count_frames(const mt_motion *motion, int *count) {
    mt_arena arena = {0};
    mt_timed_frames frames;
    mt_status status = mt_timeline_frames(&motion->timeline, &motion->request.timing, &arena, &frames);
    if (status == MT_OK) *count = frames.count;
    mt_arena_release(&arena);
    return status;
}

mt_status mt_apng(const mt_motion *motion, mt_buffer *file) {
    mt_apng_writing w = {.file = file, .timing = &motion->request.timing};
    *file = (mt_buffer){0};
    mt_status status = count_frames(motion, &w.frames);
    if (status == MT_OK) status = mt_raster_play(motion, take, &w);
    if (status == MT_OK) status = add_end(file);
    if (status != MT_OK) mt_buffer_free(file);
    return status;
}
