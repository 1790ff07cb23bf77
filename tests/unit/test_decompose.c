#include "geometry/decompose.h"
#include "support/corpus.h"
#include "support/oracle.h"
#include "support/polygons.h"
#include "support/promises.h"

static mt_arena arena;
static mt_corpus corpus;

static int set_up(void **state) {
    (void)state;
    corpus = mt_corpus_read(&arena);
    return 0;
}

static int tear_down(void **state) {
    (void)state;
    mt_arena_release(&arena);
    return 0;
}

static mt_pieces pieces_of(const char *name) {
    mt_pieces pieces = {0};
    mt_assert_ok(mt_decompose(mt_corpus_find(&corpus, name), &arena, &pieces));
    return pieces;
}

static void convex_stays_whole(void **state) {
    (void)state;
    static const char *const names[] = {"triangle",
                                        "smallest",
                                        "square",
                                        "square_with_runs",
                                        "square_with_repeats",
                                        "sliver",
                                        "bump_of_one_unit",
                                        "octagon_on_a_circle",
                                        "grid_points_on_a_circle"};
    for (int i = 0; i < 9; i++) {
        mt_pieces pieces = pieces_of(names[i]);
        mt_subject subject = {names[i], -1, {&pieces}};
        mt_require(pieces.count == 1, &subject);
    }
}

static void known_counts(void **state) {
    (void)state;
    assert_int_equal(pieces_of("arrow").count, 3);
    assert_int_equal(pieces_of("l_shape").count, 2);
    assert_int_equal(pieces_of("plus").count, 3);
    assert_int_equal(pieces_of("star_of_five").count, 4);
    assert_int_equal(pieces_of("touches_itself_at_a_vertex").count, 2);
}

static void reflex_counts(void **state) {
    (void)state;
    assert_int_equal(mt_reflex_count(mt_corpus_find(&corpus, "square_with_runs")), 0);
    assert_int_equal(mt_reflex_count(mt_corpus_find(&corpus, "arrow")), 1);
    assert_int_equal(mt_reflex_count(mt_corpus_find(&corpus, "frame")), 4);
    assert_int_equal(mt_reflex_count(mt_corpus_find(&corpus, "repeat_across_the_start")), 0);
    assert_int_equal(mt_reflex_count(mt_corpus_find(&corpus, "dent_of_one_unit")), 2);
}

static void corpus_promises(void **state) {
    (void)state;
    for (int i = 0; i < corpus.count; i++) {
        const mt_named *shape = &corpus.shapes[i];
        if (!shape->is_component) continue;
        mt_subject subject = {shape->name, -1, {&shape->rings}};
        mt_pieces pieces;
        mt_require(mt_decompose(&shape->rings, &arena, &pieces) == MT_OK, &subject);
        mt_check_pieces(&shape->rings, &pieces, &subject);
    }
}

/* The longest diagonals go first: a bar with a nick in the middle of one side keeps a cut there, not along
 * its length. */
static void short_cuts_stay(void **state) {
    (void)state;
    mt_ring bar = mt_test_ring(&arena, 6);
    mt_point corners[] = {{0, 0}, {500, 20}, {1000, 0}, {1000, 100}, {500, 80}, {0, 100}};
    for (int i = 0; i < 6; i++) bar.points[i] = corners[i];
    mt_component component = {1, &bar};
    mt_pieces pieces;
    mt_assert_ok(mt_decompose(&component, &arena, &pieces));
    assert_int_equal(pieces.count, 2);
    for (int i = 0; i < 2; i++) assert_int_equal(pieces.rings[i].count, 4);
}

/* An edge of the component keeps the marks of its start; a diagonal is a line, from a corner if that
 * vertex is one. */
static void marks_go_with_edges(void **state) {
    (void)state;
    mt_component component = mt_test_moved(&arena, mt_corpus_find(&corpus, "plus"), 1, (mt_point){0, 0});
    mt_ring *ring = &component.rings[0];
    for (int i = 0; i < 12; i++) ring->marks[i] = i % 2 ? MT_CHORD : MT_CORNER | MT_LINE;
    mt_pieces pieces;
    mt_assert_ok(mt_decompose(&component, &arena, &pieces));
    for (int i = 0; i < pieces.count; i++)
        for (int k = 0; k < pieces.rings[i].count; k++) {
            int at = 0;
            while (!mt_point_equal(ring->points[at], pieces.rings[i].points[k])) at++;
            mt_point after = pieces.rings[i].points[(k + 1) % pieces.rings[i].count];
            bool boundary = mt_point_equal(ring->points[(at + 1) % 12], after);
            uint8_t own = ring->marks[at];
            assert_int_equal(pieces.rings[i].marks[k], boundary ? own : (own & MT_CORNER) | MT_LINE);
        }
}

static void crossing_rings_are_refused(void **state) {
    (void)state;
    mt_pieces pieces;
    static const char *const names[] = {"bow_tie", "crossed_bars", "pentagram", "backwards_square",
                                        "same_ring_twice"};
    for (int i = 0; i < 5; i++)
        assert_int_equal(mt_decompose(mt_corpus_find(&corpus, names[i]), &arena, &pieces), MT_BAD_GEOMETRY);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(convex_stays_whole),
        cmocka_unit_test(known_counts),
        cmocka_unit_test(reflex_counts),
        cmocka_unit_test(corpus_promises),
        cmocka_unit_test(short_cuts_stay),
        cmocka_unit_test(marks_go_with_edges),
        cmocka_unit_test(crossing_rings_are_refused),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
