/* The library's drawings from memory, and what moves between them. */
#include "morphotype.h"

#include <math.h>
#include <string.h>

#include "support/allocation.h"
#include "support/check.h"

/* What is drawn: a letter for each call, and twice the signed area of all contours' points. */
typedef struct drawn {
    char calls[1024];
    int count, contours;
    double area, x, y, start_x, start_y, left, right;
} drawn;

static void note(drawn *d, char call) {
    assert_true(d->count + 1 < (int)sizeof d->calls);
    d->calls[d->count++] = call;
}

static void go_to(drawn *d, double x, double y) {
    d->area += d->x * y - x * d->y;
    d->x = x;
    d->y = y;
    d->left = fmin(d->left, x);
    d->right = fmax(d->right, x);
}

static void move_to(double x, double y, void *user) {
    drawn *d = user;
    note(d, 'M');
    d->contours++;
    d->x = d->start_x = x;
    d->y = d->start_y = y;
}

static void line_to(double x, double y, void *user) {
    note(user, 'L');
    go_to(user, x, y);
}

static void quadratic_to(double cx, double cy, double x, double y, void *user) {
    (void)cx, (void)cy;
    note(user, 'Q');
    go_to(user, x, y);
}

static void close_contour(void *user) {
    drawn *d = user;
    note(d, 'Z');
    go_to(d, d->start_x, d->start_y);
}

static const mt_draw draw = {
    .move_to = move_to, .line_to = line_to, .quadratic_to = quadratic_to, .close = close_contour};

static drawn drawn_at(const mt_moving *moving, double t) {
    drawn d = {.left = INFINITY, .right = -INFINITY};
    mt_assert_ok(mt_moving_draw(moving, t, &draw, &d));
    return d;
}

/* A square from (0, 0) with a square hole in its middle. */
static mt_status add_ring(mt_path *path, double side) {
    const double corners[2][4][2] = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}},
                                     {{0.25, 0.25}, {0.25, 0.75}, {0.75, 0.75}, {0.75, 0.25}}};
    mt_status status = MT_OK;
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < 4 && status == MT_OK; i++) {
            double x = corners[k][i][0] * side, y = corners[k][i][1] * side;
            status = i == 0 ? mt_path_move_to(path, x, y) : mt_path_line_to(path, x, y);
        }
    return status;
}

static mt_path *ring_of(double em, double side) {
    mt_path *path;
    mt_assert_ok(mt_path_new(em, &path));
    mt_assert_ok(add_ring(path, side));
    return path;
}

/* Two squares with holes of different units: the first's units come back, and the hole stays. */
static void a_ring_stays_a_ring(void **state) {
    (void)state;
    mt_path *a = ring_of(24, 20), *b = ring_of(1000, 500);
    mt_params params = mt_params_default();
    mt_moving *moving;
    mt_assert_ok(mt_moving_new(a, b, &params, &moving));
    mt_path_free(a);
    mt_path_free(b);
    drawn first = drawn_at(moving, 0);
    for (int i = 0; i <= 4; i++) {
        drawn d = drawn_at(moving, i / 4.0);
        double side = 20 + (12 - 20) * i / 4.0;
        assert_string_equal(d.calls, first.calls);
        assert_int_equal(d.contours, 2);
        assert_true(fabs(fabs(d.area) / 2 - 0.75 * side * side) < 0.1);
        assert_true(fabs(d.right - d.left - side) < 0.05);
    }
    drawn none;
    assert_int_equal(mt_moving_draw(moving, 1.5, &draw, &none), MT_BAD_PARAMETER);
    mt_moving_free(moving);
}

/* ---- symmetry -------------------------------------------------------------------------------------------- */

typedef struct place {
    double x, y;
} place;

typedef struct places {
    int count;
    place list[256];
} places;

static void add_place(places *p, double x, double y) {
    assert_true(p->count < 256);
    p->list[p->count++] = (place){x, y};
}

static void note_place(double x, double y, void *user) {
    add_place(user, x, y);
}

static void note_curve(double cx, double cy, double x, double y, void *user) {
    add_place(user, cx, cy);
    add_place(user, x, y);
}

static void note_end(void *user) {
    (void)user;
}

static mt_path *star(void) {
    static const double corners[][2] = {{50, 95}, {39, 62}, {4, 62},  {32, 41}, {21, 7},
                                        {50, 28}, {79, 7},  {68, 41}, {96, 62}, {61, 62}};
    mt_path *path;
    mt_assert_ok(mt_path_new(100, &path));
    for (int i = 0; i < 10; i++)
        mt_assert_ok(i ? mt_path_line_to(path, corners[i][0], corners[i][1])
                       : mt_path_move_to(path, corners[i][0], corners[i][1]));
    return path;
}

static mt_path *heart(void) {
    mt_path *path;
    mt_assert_ok(mt_path_new(100, &path));
    mt_assert_ok(mt_path_move_to(path, 50, 8));
    mt_assert_ok(mt_path_cubic_to(path, 80, 34, 94, 48, 94, 68));
    mt_assert_ok(mt_path_cubic_to(path, 94, 90, 60, 100, 50, 79));
    mt_assert_ok(mt_path_cubic_to(path, 40, 100, 6, 90, 6, 68));
    mt_assert_ok(mt_path_cubic_to(path, 6, 48, 20, 34, 50, 8));
    return path;
}

/* Every point has its image on the other side of x = 50. */
static void assert_symmetric(const places *p) {
    for (int i = 0; i < p->count; i++) {
        bool found = false;
        for (int k = 0; k < p->count; k++)
            found = found || (fabs(p->list[i].x + p->list[k].x - 100) < 0.01 &&
                              fabs(p->list[i].y - p->list[k].y) < 0.01);
        assert_true(found);
    }
}

static void star_and_heart_stay_symmetric(void **state) {
    (void)state;
    static const mt_draw noting = {
        .move_to = note_place, .line_to = note_place, .quadratic_to = note_curve, .close = note_end};
    mt_params params = mt_params_default();
    for (int swapped = 0; swapped < 2; swapped++) {
        mt_path *a = swapped ? heart() : star(), *b = swapped ? star() : heart();
        mt_moving *moving;
        mt_assert_ok(mt_moving_new(a, b, &params, &moving));
        for (int i = 0; i <= 8; i++) {
            places p = {0};
            mt_assert_ok(mt_moving_draw(moving, i / 8.0, &noting, &p));
            assert_true(p.count > 10);
            assert_symmetric(&p);
        }
        mt_moving_free(moving);
        mt_path_free(a);
        mt_path_free(b);
    }
}

static void bad_input_is_refused(void **state) {
    (void)state;
    mt_path *path, *blank;
    mt_moving *moving;
    mt_params params = mt_params_default();
    assert_int_equal(mt_path_new(0, &path), MT_BAD_PARAMETER);
    assert_int_equal(mt_path_new(NAN, &path), MT_BAD_PARAMETER);
    mt_assert_ok(mt_path_new(1, &path));
    assert_int_equal(mt_path_line_to(path, 1, 1), MT_BAD_PARAMETER);
    mt_assert_ok(mt_path_move_to(path, 0, 0));
    assert_int_equal(mt_path_line_to(path, NAN, 1), MT_BAD_PARAMETER);
    assert_int_equal(mt_path_cubic_to(path, 0, 0, 0, 1e30, 1, 1), MT_TOO_LARGE);
    assert_int_equal(mt_path_quadratic_to(path, 0, INFINITY, 1, 1), MT_TOO_LARGE);
    mt_assert_ok(mt_path_line_to(path, 1, 0));
    mt_assert_ok(mt_path_line_to(path, 1, 1));
    mt_assert_ok(mt_path_new(1, &blank));
    assert_int_equal(mt_moving_new(path, blank, &params, &moving), MT_BLANK);
    mt_assert_ok(mt_moving_new(path, path, &params, &moving));
    mt_moving_free(moving);
    params.tolerance = 0;
    assert_int_equal(mt_moving_new(path, path, &params, &moving), MT_BAD_PARAMETER);
    mt_path_free(path);
    mt_path_free(blank);
}

static mt_status make(void) {
    mt_path *a = NULL, *b = NULL;
    mt_moving *moving;
    mt_params params = mt_params_default();
    mt_status status = mt_path_new(24, &a);
    if (status == MT_OK) status = mt_path_new(24, &b);
    if (status == MT_OK) status = add_ring(a, 20);
    if (status == MT_OK) status = add_ring(b, 10);
    if (status == MT_OK) status = mt_moving_new(a, b, &params, &moving);
    if (status == MT_OK) {
        drawn d = {0};
        status = mt_moving_draw(moving, 0.5, &draw, &d);
        mt_moving_free(moving);
    }
    mt_path_free(a);
    mt_path_free(b);
    return status;
}

static void survives_want_of_memory(void **state) {
    (void)state;
    mt_test_want_of_memory(make);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_ring_stays_a_ring),
        cmocka_unit_test(star_and_heart_stay_symmetric),
        cmocka_unit_test(bad_input_is_refused),
        cmocka_unit_test(survives_want_of_memory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
