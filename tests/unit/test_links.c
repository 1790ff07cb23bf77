#include "geometry/decompose.h"
#include "morph/paper/links.h"
#include "support/check.h"
#include "support/polygons.h"

#include <math.h>

static mt_arena arena;

static int tear_down(void **state) {
    (void)state;
    mt_arena_release(&arena);
    return 0;
}

/* A side of squares, 10 wide, each a component and a piece of its own, at the given places. */
static mt_side squares(const mt_point *places, int count) {
    mt_side side = {.shape = {count, mt_arena_new(&arena, (size_t)count, sizeof(mt_component))}};
    side.pieces = mt_test_rings(&arena, count);
    side.first = mt_arena_new(&arena, (size_t)count + 1, sizeof(int));
    for (int i = 0; i < count; i++) {
        mt_point p = places[i], corners[] = {p, {p.x + 10, p.y}, {p.x + 10, p.y + 10}, {p.x, p.y + 10}};
        mt_ring *ring = &side.pieces.rings[i];
        *ring = mt_test_ring(&arena, 4);
        for (int k = 0; k < 4; k++) ring->points[k] = corners[k];
        side.shape.components[i] = (mt_component){1, ring};
        side.first[i + 1] = i + 1;
    }
    side.box = mt_shape_box(&side.shape);
    return side;
}

/* All pieces in one component. */
static mt_side joined(mt_side side) {
    side.first[1] = side.pieces.count;
    side.shape.count = 1;
    return side;
}

static mt_links linked(const mt_side *a, const mt_side *b, const mt_link *matches, int count,
                       bool one_scale) {
    mt_link copy[16];
    for (int i = 0; i < count; i++) copy[i] = matches[i];
    mt_links all = {count, copy}, links;
    mt_assert_ok(mt_link_pieces(a, b, &all, one_scale, &arena, &links));
    return links;
}

static bool has(const mt_links *links, int a, int b) {
    for (int i = 0; i < links->count; i++)
        if (links->links[i].a == a && links->links[i].b == b) return true;
    return false;
}

static void nearest_first(void **state) {
    (void)state;
    const mt_point left_to_right[] = {{0, 0}, {50, 0}, {90, 0}},
                   right_to_left[] = {{190, 0}, {90, 0}, {0, 0}};
    mt_side a = joined(squares(left_to_right, 3)), b = joined(squares(right_to_left, 3));
    mt_links links = linked(&a, &b, &(mt_link){0, 0}, 1, false);
    assert_int_equal(links.count, 3);
    assert_true(has(&links, 0, 2) && has(&links, 1, 1) && has(&links, 2, 0));
}

/* Step 3: pieces of B that nobody in A chose find one themselves. */
static void nobody_is_left(void **state) {
    (void)state;
    const mt_point one[] = {{0, 0}}, many[] = {{0, 0}, {50, 0}, {90, 0}};
    mt_side a = joined(squares(one, 1)), b = joined(squares(many, 3));
    mt_links links = linked(&a, &b, &(mt_link){0, 0}, 1, false);
    assert_int_equal(links.count, 3);
    links = linked(&b, &a, &(mt_link){0, 0}, 1, false);
    assert_int_equal(links.count, 3);
}

/* A piece next door in a component that is not matched is not linked. */
static void only_in_matched_components(void **state) {
    (void)state;
    const mt_point places[] = {{0, 0}, {90, 0}};
    mt_side a = squares(places, 2), b = squares(places, 2);
    const mt_link crosswise[] = {{0, 1}, {1, 0}};
    mt_links links = linked(&a, &b, crosswise, 2, false);
    assert_int_equal(links.count, 2);
    assert_true(has(&links, 0, 1) && has(&links, 1, 0));
}

/* A is 100 × 10, B 100 × 100: by each axis' own side the piece at A's top right is B's top right; by the
 * longer side for both, all of A lies low, and it is nearer to B's lower right. */
static void scales(void **state) {
    (void)state;
    const mt_point flat[] = {{0, 0}, {90, 0}, {90, 10}, {0, 10}},
                   tall[] = {{0, 0}, {90, 0}, {90, 90}, {0, 90}};
    mt_side a = joined(squares(flat, 4)), b = joined(squares(tall, 4));
    mt_links links = linked(&a, &b, &(mt_link){0, 0}, 1, false);
    assert_true(has(&links, 2, 2) && !has(&links, 2, 1));
    links = linked(&a, &b, &(mt_link){0, 0}, 1, true);
    assert_true(has(&links, 2, 1));
}

static void distance_to(const mt_side *side, int i, double place[2]) {
    mt_ring_centre(&side->pieces.rings[i], &place[0], &place[1]);
    place[0] = (place[0] - side->box.min.x) / ((double)side->box.max.x - side->box.min.x);
    place[1] = (place[1] - side->box.min.y) / ((double)side->box.max.y - side->box.min.y);
}

static double apart(const mt_side *a, int i, const mt_side *b, int j) {
    double p[2], q[2];
    distance_to(a, i, p);
    distance_to(b, j, q);
    return hypot(p[0] - q[0], p[1] - q[1]);
}

static mt_side random_side(mt_random *random) {
    mt_point places[8];
    int count = mt_random_between(random, 2, 8);
    for (int i = 0; i < count; i++) places[i] = mt_random_point(random, -500, 500);
    return joined(squares(places, count));
}

/* Formula (3) by brute force: each link is the nearest for its piece of A, or for a piece of B that no
 * piece of A wants. */
static void formula_three(void **state) {
    (void)state;
    for (int n = 0; n < mt_test_cases(200); n++) {
        mt_random random = mt_random_case(n);
        mt_side a = random_side(&random), b = random_side(&random);
        mt_links links = linked(&a, &b, &(mt_link){0, 0}, 1, false);
        double to_b[8], to_a[8];
        bool wanted[8] = {false};
        for (int j = 0; j < b.pieces.count; j++) to_a[j] = INFINITY;
        for (int i = 0; i < a.pieces.count; i++) {
            to_b[i] = INFINITY;
            for (int j = 0; j < b.pieces.count; j++) {
                to_b[i] = fmin(to_b[i], apart(&a, i, &b, j));
                to_a[j] = fmin(to_a[j], apart(&a, i, &b, j));
            }
        }
        for (int k = 0; k < links.count; k++) {
            mt_link link = links.links[k];
            double distance = apart(&a, link.a, &b, link.b);
            assert_true(fabs(distance - to_b[link.a]) < 1e-9 || fabs(distance - to_a[link.b]) < 1e-9);
            wanted[link.b] = true;
        }
        for (int j = 0; j < b.pieces.count; j++) assert_true(wanted[j]);
        assert_true(links.count >= a.pieces.count && links.count <= a.pieces.count + b.pieces.count);
        mt_arena_reset(&arena);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nearest_first),
        cmocka_unit_test(nobody_is_left),
        cmocka_unit_test(only_in_matched_components),
        cmocka_unit_test(scales),
        cmocka_unit_test(formula_three),
    };
    return cmocka_run_group_tests(tests, NULL, tear_down);
}
