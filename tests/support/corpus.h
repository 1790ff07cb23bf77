/* The named shapes of tests/data/shapes.txt.
 *
 *     # a comment
 *     component NAME      rings of a component: the outer one anticlockwise, then holes, clockwise; none cross
 *     drawing NAME        rings as drawn: crossing, backwards, without area
 *     0,0 100,0 100,100   one ring a line, "x,y" a point; the shape ends at the next one
 */
#pragma once

#include "geometry/ring.h"

#include <stdio.h>

typedef struct mt_named {
    char name[64];
    bool is_component;
    mt_rings rings;
} mt_named;

typedef struct mt_corpus {
    int count;
    mt_named *shapes;
} mt_corpus;

/* Reads the file that the environment variable MT_SHAPES names, every point a corner between lines. Fails
 * the test, with the line, on anything that is not in the format above. */
mt_corpus mt_corpus_read(mt_arena *arena);

/* The shape of that name; fails the test when there is none. */
const mt_rings *mt_corpus_find(const mt_corpus *corpus, const char *name);

void mt_corpus_print(FILE *file, const char *name, const mt_rings *rings);
