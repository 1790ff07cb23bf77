/* A number is written in groups of seven bits, the lowest first, of which all but the last have the eighth bit; its sign is the lowest bit.
 * A double is its 64 bits, the lowest byte first. O(1) for a number. */
#include "cache/packing.h"

#include <limits.h>
#include <math.h>
#include <string.h>

#include "geometry/limits.h"

/* ---- beginning and end ------------------------------------------------------------------------------------ */

mt_packing mt_packing_to(mt_buffer *out) {
    return (mt_packing){.out = out, .status = MT_OK};
}

mt_packing mt_packing_from(const uint8_t *bytes, size_t length, mt_arena *arena) {
    return (mt_packing){.at = bytes, .end = bytes + length, .arena = arena, .status = MT_OK};
}

static void fail(mt_packing *packing, mt_status why) {
    if (packing->status == MT_OK) packing->status = why;
}

void mt_packing_refuse(mt_packing *packing) {
    fail(packing, MT_BAD_GEOMETRY);
}

mt_status mt_packing_end(mt_packing *packing) {
    if (!packing->out && packing->at != packing->end) mt_packing_refuse(packing);
    return packing->status;
}

/* ---- numbers ----------------------------------------------------------------------------------------------- */

static void write_bytes(mt_packing *packing, const uint8_t *bytes, size_t length) {
    if (packing->status == MT_OK) packing->status = mt_buffer_add(packing->out, bytes, length);
}

static uint8_t read_byte(mt_packing *packing) {
    if (packing->status == MT_OK && packing->at == packing->end) mt_packing_refuse(packing);
    return packing->status == MT_OK ? *packing->at++ : 0;
}

static void write_number(mt_packing *packing, int64_t value) {
    uint64_t bits = value < 0 ? ~((uint64_t)value << 1) : (uint64_t)value << 1;
    uint8_t groups[10];
    size_t count = 0;
    for (; bits > 0x7F; bits >>= 7) groups[count++] = (uint8_t)(bits | 0x80);
    groups[count++] = (uint8_t)bits;
    write_bytes(packing, groups, count);
}

/* Of up to 35 bits. */
static int64_t read_number(mt_packing *packing) {
    enum { GROUPS_MOST = 5 };
    uint64_t bits = 0;
    uint8_t group = 0x80;
    for (int i = 0; i < GROUPS_MOST && group & 0x80; i++) {
        group = read_byte(packing);
        bits |= (uint64_t)(group & 0x7F) << (7 * i);
    }
    if (group & 0x80) mt_packing_refuse(packing);
    return bits & 1 ? -(int64_t)(bits >> 1) - 1 : (int64_t)(bits >> 1);
}

static int64_t read_within(mt_packing *packing, int64_t least, int64_t most) {
    int64_t value = read_number(packing);
    if (value < least || value > most) mt_packing_refuse(packing);
    return packing->status == MT_OK ? value : least > 0 ? least : 0;
}

void mt_pack_int(mt_packing *packing, int *value, int least, int most) {
    if (packing->out)
        write_number(packing, *value);
    else
        *value = (int)read_within(packing, least, most);
}

void mt_pack_bool(mt_packing *packing, bool *value) {
    int number = *value;
    mt_pack_int(packing, &number, 0, 1);
    *value = number != 0;
}

void mt_pack_double(mt_packing *packing, double *value) {
    uint64_t bits = 0;
    uint8_t bytes[sizeof bits];
    memcpy(&bits, value, sizeof bits);
    for (size_t i = 0; i < sizeof bits; i++)
        bytes[i] = (uint8_t)(packing->out ? bits >> (8 * i) : read_byte(packing));
    if (packing->out) {
        write_bytes(packing, bytes, sizeof bytes);
        return;
    }
    bits = 0;
    for (size_t i = 0; i < sizeof bits; i++) bits |= (uint64_t)bytes[i] << (8 * i);
    memcpy(value, &bits, sizeof bits);
    if (!isfinite(*value)) mt_packing_refuse(packing);
    if (packing->status != MT_OK) *value = 0;
}

/* ---- places ------------------------------------------------------------------------------------------------ */

static void pack_coordinate(mt_packing *packing, int32_t *value, int32_t *last) {
    if (packing->out)
        write_number(packing, (int64_t)*value - *last);
    else
        *value = (int32_t)(*last + read_within(packing, -4 * MT_COORD_MAX - (int64_t)*last,
                                               4 * MT_COORD_MAX - (int64_t)*last));
    *last = *value;
}

void mt_pack_point(mt_packing *packing, mt_point *point) {
    pack_coordinate(packing, &point->x, &packing->last.x);
    pack_coordinate(packing, &point->y, &packing->last.y);
}

void mt_pack_box(mt_packing *packing, mt_box *box) {
    mt_pack_point(packing, &box->min);
    mt_pack_point(packing, &box->max);
}

/* ---- lists --------------------------------------------------------------------------------------------------- */

void *mt_pack_list(mt_packing *packing, int *count, void *list, size_t size) {
    int64_t left = packing->out ? INT_MAX : packing->end - packing->at;
    mt_pack_int(packing, count, 0, left < MT_POINTS_MAX ? (int)left : MT_POINTS_MAX);
    if (packing->out) return list;
    void *made = *count ? mt_arena_new(packing->arena, (size_t)*count, size) : NULL;
    if (*count && !made) fail(packing, MT_NO_MEMORY);
    if (!made) *count = 0;
    return made;
}

/* Two marks in a byte. */
static void pack_marks(mt_packing *packing, mt_ring *ring) {
    for (int i = 0; i < ring->count; i += 2) {
        bool two = i + 1 < ring->count;
        uint8_t both = 0;
        if (!packing->out) both = read_byte(packing);
        if (packing->out) both = (uint8_t)(ring->marks[i] | (two ? ring->marks[i + 1] << 4 : 0));
        if (packing->out) write_bytes(packing, &both, 1);
        ring->marks[i] = both & 0xF;
        if (two) ring->marks[i + 1] = both >> 4;
    }
}

static void pack_ring(mt_packing *packing, mt_ring *ring) {
    ring->points = mt_pack_list(packing, &ring->count, ring->points, sizeof *ring->points);
    if (!packing->out && ring->count) ring->marks = mt_arena_new(packing->arena, (size_t)ring->count, 1);
    if (ring->count && !ring->marks) {
        fail(packing, MT_NO_MEMORY);
        ring->count = 0;
    }
    for (int i = 0; i < ring->count; i++) mt_pack_point(packing, &ring->points[i]);
    pack_marks(packing, ring);
}

void mt_pack_rings(mt_packing *packing, mt_rings *rings) {
    rings->rings = mt_pack_list(packing, &rings->count, rings->rings, sizeof *rings->rings);
    for (int i = 0; i < rings->count; i++) pack_ring(packing, &rings->rings[i]);
}

void mt_pack_shape(mt_packing *packing, mt_shape *shape) {
    shape->components = mt_pack_list(packing, &shape->count, shape->components, sizeof *shape->components);
    for (int k = 0; k < shape->count; k++) mt_pack_rings(packing, &shape->components[k]);
}

void mt_pack_contour(mt_packing *packing, mt_contour *contour, int most) {
    contour->segments = mt_pack_list(packing, &contour->count, contour->segments, sizeof *contour->segments);
    for (int i = 0; i < contour->count; i++) {
        mt_segment *segment = &contour->segments[i];
        mt_pack_int(packing, &segment->degree, 1, most);
        for (int k = 0; k + 1 < segment->degree; k++) mt_pack_point(packing, &segment->control[k]);
        mt_pack_point(packing, &segment->end);
    }
}
