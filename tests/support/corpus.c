#include "support/corpus.h"

#include "support/check.h"

#include <string.h>

enum { SHAPES_MAX = 200, RINGS_MAX = 32, LINE_MAX_LENGTH = 8192 };

static int count_points(const char *line) {
    int count = 0;
    for (; *line; line++) count += *line == ',';
    return count;
}

static mt_rings room_for_rings(mt_arena *arena) {
    mt_rings rings = {0, mt_arena_new(arena, RINGS_MAX, sizeof(mt_ring))};
    assert_non_null(rings.rings);
    return rings;
}

static void read_ring(const char *line, mt_arena *arena, mt_rings *rings, int number) {
    assert_true(rings->count < RINGS_MAX);
    mt_ring *ring = &rings->rings[rings->count++];
    int count = count_points(line);
    mt_assert_ok(mt_ring_new(arena, count, ring));
    for (int i = 0; i < count; i++) {
        int used = 0;
        if (sscanf(line, "%d,%d%n", &ring->points[i].x, &ring->points[i].y, &used) != 2 || used == 0)
            fail_msg("shapes, line %d: no point at '%s'", number, line);
        ring->marks[i] = MT_CORNER | MT_LINE;
        line += used;
    }
}

static void read_line(const char *line, mt_arena *arena, mt_corpus *corpus, int number) {
    mt_named *last = corpus->count ? &corpus->shapes[corpus->count - 1] : NULL;
    char kind[16], name[64];
    if (line[0] == '#' || line[strspn(line, " \n")] == 0) return;
    if (sscanf(line, "%15[a-z] %63s", kind, name) == 2) {
        bool is_component = strcmp(kind, "component") == 0;
        assert_true(corpus->count < SHAPES_MAX && (is_component || strcmp(kind, "drawing") == 0));
        last = &corpus->shapes[corpus->count++];
        *last = (mt_named){.is_component = is_component, .rings = room_for_rings(arena)};
        memcpy(last->name, name, sizeof name);
    } else if (last) {
        read_ring(line, arena, &last->rings, number);
    } else {
        fail_msg("shapes, line %d: a ring before the first name", number);
    }
}

mt_corpus mt_corpus_read(mt_arena *arena) {
    const char *path = getenv("MT_SHAPES");
    FILE *file = fopen(path ? path : "tests/data/shapes.txt", "r");
    if (!file) fail_msg("cannot read the shapes: set MT_SHAPES to tests/data/shapes.txt");
    mt_corpus corpus = {0, mt_arena_new(arena, SHAPES_MAX, sizeof(mt_named))};
    assert_non_null(corpus.shapes);
    char line[LINE_MAX_LENGTH];
    for (int number = 1; fgets(line, sizeof line, file); number++) read_line(line, arena, &corpus, number);
    fclose(file);
    return corpus;
}

const mt_rings *mt_corpus_find(const mt_corpus *corpus, const char *name) {
    for (int i = 0; i < corpus->count; i++)
        if (strcmp(corpus->shapes[i].name, name) == 0) return &corpus->shapes[i].rings;
    fail_msg("no shape named %s", name);
    return NULL;
}

void mt_corpus_print(FILE *file, const char *name, const mt_rings *rings) {
    fprintf(file, "component %s\n", name);
    for (int r = 0; r < rings->count; r++) {
        const mt_ring *ring = &rings->rings[r];
        for (int i = 0; i < ring->count; i++)
            fprintf(file, "%s%d,%d", i ? " " : "", ring->points[i].x, ring->points[i].y);
        fprintf(file, "\n");
    }
}
