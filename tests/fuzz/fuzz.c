#include "fuzz.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "geometry/limits.h"

void fuzz_fail(const char *condition, const char *file, int line) {
    fprintf(stderr, "%s:%d: %s does not hold\n", file, line, condition);
    abort();
}

/* ---- files ------------------------------------------------------------------------------------------------- */

const char *fuzz_file(const uint8_t *bytes, size_t length) {
    static char path[32]; /* of the one file of the process */
    static int file = -1;
    if (file < 0) {
        char name[] = "/tmp/morphotype-fuzz-XXXXXX";
        file = mkstemp(name);
        fuzz_require(file >= 0 && unlink(name) == 0);
        snprintf(path, sizeof path, "/proc/self/fd/%d", file);
    }
    fuzz_require(ftruncate(file, 0) == 0 && pwrite(file, bytes, length, 0) == (ssize_t)length);
    return path;
}

mt_font *fuzz_font(const uint8_t *bytes, size_t length) {
    mt_font *font = NULL;
    return mt_font_open(fuzz_file(bytes, length), &font) == MT_OK ? font : NULL;
}

mt_font *fuzz_own_font(const char *name) {
    char path[1024];
    mt_font *font = NULL;
    snprintf(path, sizeof path, "%s/%s", FUZZ_FONTS, name);
    fuzz_require(mt_font_open(path, &font) == MT_OK);
    return font;
}

void fuzz_bound(mt_arena *arena, double effort) {
    mt_arena_bound(arena, &(mt_allowance){(int64_t)(effort * (double)MT_GLYPH_STEPS),
                                          (size_t)(effort * (double)MT_GLYPH_BYTES) + (1 << 22), NULL});
}

/* ---- places ------------------------------------------------------------------------------------------------ */

fuzz_places fuzz_places_of(const uint8_t *bytes, size_t length) {
    static const int factors[] = {1, 8, 64, 256};
    enum { MOST = 400 };
    if (length < 1 + FUZZ_RECORD) return (fuzz_places){0};
    size_t count = (length - 1) / FUZZ_RECORD;
    return (fuzz_places){count < MOST ? (int)count : MOST, bytes + 1, factors[bytes[0] % 4]};
}

static int coordinate(const uint8_t *at, int factor) {
    int value = (int16_t)(at[0] << 8 | at[1]);
    return (value < -INT16_MAX ? -INT16_MAX : value) * factor;
}

mt_point fuzz_place(const fuzz_places *places, int i) {
    const uint8_t *at = places->records + (size_t)i * FUZZ_RECORD;
    return (mt_point){coordinate(at + 1, places->factor), coordinate(at + 3, places->factor)};
}

uint8_t fuzz_flags(const fuzz_places *places, int i) {
    return places->records[(size_t)i * FUZZ_RECORD];
}

mt_rings fuzz_rings(const fuzz_places *places, uint8_t mask, uint8_t flags, mt_arena *arena) {
    mt_rings rings = {0, mt_arena_new(arena, (size_t)places->count + 1, sizeof *rings.rings)};
    mt_ring *ring = NULL;
    fuzz_require(rings.rings);
    for (int i = 0; i < places->count; i++) {
        if ((fuzz_flags(places, i) & mask) != flags) continue;
        if (!ring || fuzz_flags(places, i) & FUZZ_STARTS) {
            ring = &rings.rings[rings.count++];
            fuzz_require(mt_ring_new(arena, places->count - i, ring) == MT_OK);
            ring->count = 0;
        }
        ring->marks[ring->count] = MT_CORNER | MT_LINE;
        ring->points[ring->count++] = fuzz_place(places, i);
    }
    return rings;
}
