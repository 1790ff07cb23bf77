/* What the harnesses share. Each gives one entry of the library to libFuzzer, or to replay.c: bytes that may be anything. A finding is a
 * crash, a report of a sanitizer, a run without end, or a promise of a header that does not hold. */
#pragma once

#include "geometry/ring.h"
#include "morphotype.h"

/* The entry; always 0. */
int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t length);

/* Ends the program where a promise does not hold. */
#define fuzz_require(condition) ((condition) ? (void)0 : fuzz_fail(#condition, __FILE__, __LINE__))
_Noreturn void fuzz_fail(const char *condition, const char *file, int line);

/* A path to a file with these bytes, until the next call; the file has no name and goes with the process. */
const char *fuzz_file(const uint8_t *bytes, size_t length);

/* The bytes as a font; NULL where they are none. */
mt_font *fuzz_font(const uint8_t *bytes, size_t length);
/* A font of the repository's own, by its name in fonts/: opened once, never closed. */
mt_font *fuzz_own_font(const char *name);

/* Bounds an arena to a share of what a glyph may do and take. */
void fuzz_bound(mt_arena *arena, double effort);

/* Places in bytes: one that chooses a factor, then records of a byte of flags and two coordinates of 16 bits. Those with the flag
 * FUZZ_STARTS begin a ring. */
enum { FUZZ_RECORD = 5, FUZZ_STARTS = 1, FUZZ_DEGREE = 6, FUZZ_SECOND = 8 };
typedef struct fuzz_places {
    int count;
    const uint8_t *records;
    int factor;
} fuzz_places;
fuzz_places fuzz_places_of(const uint8_t *bytes, size_t length);
mt_point fuzz_place(const fuzz_places *places, int i);
uint8_t fuzz_flags(const fuzz_places *places, int i);

/* The rings of all places whose flags within `mask` are `flags`, in the arena. */
mt_rings fuzz_rings(const fuzz_places *places, uint8_t mask, uint8_t flags, mt_arena *arena);
