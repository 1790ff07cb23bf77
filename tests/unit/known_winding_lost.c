/* A known bug, expected to fail: where edges of rings that are drawn in opposite directions lie on one
 * another, Clipper 6.4.2 may count a winding wrong under the nonzero rule. Of the shape
 * "winding_lost_at_shared_edges", 1 × 3 squares of ink are missing. Sums of pieces all go the same way
 * round and are not affected; a font's own contours may be. */
#include "geometry/union.h"
#include "support/check.h"
#include "support/corpus.h"
#include "support/oracle.h"

enum { SIDE = 24 };

/* The winding of each unit square at its middle. */
static int64_t ink_of(const mt_rings *drawing) {
    int64_t ink = 0;
    for (int x = 0; x < SIDE; x++)
        for (int y = 0; y < SIDE; y++)
            ink += mt_oracle_winding(drawing, 2, (mt_spot){2 * x + 1, 2 * y + 1}) != 0;
    return ink;
}

static void winding_lost(void **state) {
    (void)state;
    mt_arena arena = {0};
    mt_corpus corpus = mt_corpus_read(&arena);
    const mt_rings *drawing = mt_corpus_find(&corpus, "winding_lost_at_shared_edges");
    mt_shape shape;
    mt_assert_ok(mt_union(drawing, MT_NONZERO, &arena, &shape));
    int64_t found = (int64_t)mt_oracle_shape_area2(&shape) / 2, expected = ink_of(drawing);
    mt_arena_release(&arena);
    assert_int_equal(found, expected);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(winding_lost)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
