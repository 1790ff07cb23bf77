/* A small font for the tests of reading and writing: as data, as bytes and as a file. */
#pragma once

#include "base/memory.h"
#include "write/font_data.h"

/* 1000 units; .notdef, A (a triangle), o (a circle of four off-curve points only), é (two squares) and
 * U+1F600 (a glyph without contours). Everything that may be changed is in the arena. */
mt_font_data mt_sample_font(mt_arena *arena);

/* A glyph of one contour, its points all on the curve or all off it. */
mt_glyf mt_sample_glyph(mt_arena *arena, const int16_t (*points)[2], int count, bool on, uint16_t advance);

/* A new directory for files, and what is in it under `name`; both belong to the arena. */
char *mt_sample_directory(mt_arena *arena);
char *mt_sample_path(mt_arena *arena, const char *directory, const char *name);
/* How many files and directories are in it, hidden ones too. */
int mt_sample_count(const char *directory);
/* Removes the directory and all that is in it. */
void mt_sample_remove(const char *directory);

/* Writes bytes to a file, the C library's way. */
void mt_sample_save(const char *path, const void *bytes, size_t length);
/* The whole file; belongs to the arena. */
uint8_t *mt_sample_load(mt_arena *arena, const char *path, size_t *length);

/* Where a table lies in a font's bytes; NULL when it has none of that name. */
const uint8_t *mt_sample_table(const uint8_t *bytes, const char *tag, size_t *length);
