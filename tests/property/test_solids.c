/* The paper's theorems in space, on random solids: octahedra divided once, each point drawn in or out.
 *
 * Error bound. A cut's corners are rounded to a grid of 2^24 units along the longest side, and pieces overlap by MT_OVERLAP of them where
 * they were cut: both far less than NEAR, in shares of a solid that is some two wide. Points that are so near to a surface are left out. */
#include "solid/half.h"
#include "solid/solid_morph.h"
#include "space/nearest.h"
#include "space/vector.h"
#include "support/check.h"
#include "support/solids.h"

#define NEAR 1e-5

enum { SAMPLES = 60 };

static mt_arena arena;

static int tear_down(void **state) {
    (void)state;
    mt_arena_release(&arena);
    return 0;
}

/* ---- cases --------------------------------------------------------------------------------------------- */

typedef struct trial {
    mt_random random;
    mt_mesh a, b;
    mt_solid_params params;
    double r;
} trial;

static trial begin(int number) {
    trial t = {.random = mt_random_case(number), .params = {.method = MT_METHOD_PAPER, .depth = 0.03}};
    t.a = mt_random_star(&t.random, &arena, 0.25);
    t.b = mt_random_star(&t.random, &arena, 0.25);
    t.r = mt_random_unit(&t.random);
    return t;
}

static mt_solid_morph morph_of(const mt_mesh *a, const mt_mesh *b, const mt_solid_params *params) {
    mt_solid_morph morph = {0};
    mt_assert_ok(mt_solid_prepare(&arena, a, b, params, &morph));
    return morph;
}

static mt_vector3 random_place(mt_random *random, double far) {
    double x = mt_random_unit(random), y = mt_random_unit(random), z = mt_random_unit(random);
    return (mt_vector3){far * (2 * x - 1), far * (2 * y - 1), far * (2 * z - 1)};
}

/* ---- where places are ---------------------------------------------------------------------------------- */

/* Whether p is in one of the links at r. */
static bool in_solid(const mt_solid_morph *morph, const mt_mesh *at, mt_vector3 p) {
    const mt_triangle *triangles = at->triangles;
    for (int i = 0; i < morph->n_links; triangles += morph->links[i++].n_triangles)
        if (mt_test_turns(at->points, triangles, morph->links[i].n_triangles, p) > 0.5) return true;
    return false;
}

static bool is_near(const mt_mesh *mesh, mt_vector3 p) {
    for (int t = 0; t < mesh->n_triangles; t++) {
        const int *at = mesh->triangles[t].at;
        if (mt_triangle_distance(p, mesh->points[at[0]], mesh->points[at[1]], mesh->points[at[2]]) < NEAR)
            return true;
    }
    return false;
}

/* The solid at r is `mesh`: for random places, most of them where surfaces are. */
static void check_same(const mt_solid_morph *morph, double r, const mt_mesh *mesh, mt_random *random) {
    mt_mesh at;
    mt_assert_ok(mt_solid_at(&arena, morph, r, &at));
    for (int i = 0; i < SAMPLES; i++) {
        mt_vector3 p = random_place(random, 1);
        if (is_near(mesh, p)) continue;
        bool inside = mt_test_turns(mesh->points, mesh->triangles, mesh->n_triangles, p) > 0.5;
        assert_true(in_solid(morph, &at, p) == inside);
    }
}

/* ---- links are closed ---------------------------------------------------------------------------------- */

static int by_ends(const void *p, const void *q) {
    const int *x = p, *y = q;
    return x[0] != y[0] ? (x[0] > y[0]) - (x[0] < y[0]) : (x[1] > y[1]) - (x[1] < y[1]);
}

static void check_closed(const mt_solid_link *link) {
    int n = 3 * link->n_triangles, (*forth)[2] = mt_test_new((size_t)n, sizeof *forth);
    int(*back)[2] = mt_test_new((size_t)n, sizeof *back);
    for (int e = 0; e < n; e++) {
        forth[e][0] = back[e][1] = link->triangles[e / 3].at[e % 3];
        forth[e][1] = back[e][0] = link->triangles[e / 3].at[(e % 3 + 1) % 3];
    }
    qsort(forth, (size_t)n, sizeof *forth, by_ends);
    qsort(back, (size_t)n, sizeof *back, by_ends);
    for (int e = 0; e < n; e++) assert_int_equal(by_ends(forth[e], back[e]), 0);
    free(forth);
    free(back);
}

static void links_are_closed(void **state) {
    (void)state;
    for (int i = 0; i < mt_test_cases(20); i++) {
        trial t = begin(i);
        if (i % 2) t.params.method = MT_METHOD_JOINT;
        mt_solid_morph morph = morph_of(&t.a, &t.b, &t.params);
        for (int k = 0; k < morph.n_links; k++) check_closed(&morph.links[k]);
        mt_arena_reset(&arena);
    }
}

/* ---- Theorem 1 ----------------------------------------------------------------------------------------- */

static void the_ends_are_a_and_b(void **state) {
    (void)state;
    for (int i = 0; i < mt_test_cases(20); i++) {
        trial t = begin(i);
        if (i % 2) t.params.method = MT_METHOD_JOINT;
        mt_solid_morph morph = morph_of(&t.a, &t.b, &t.params);
        check_same(&morph, 1, &t.a, &t.random);
        check_same(&morph, 0, &t.b, &t.random);
        mt_arena_reset(&arena);
    }
}

static void a_with_itself_is_a(void **state) {
    (void)state;
    for (int i = 0; i < mt_test_cases(12); i++) {
        trial t = begin(i);
        mt_solid_morph morph = morph_of(&t.a, &t.a, &t.params);
        check_same(&morph, t.r, &t.a, &t.random);
        mt_arena_reset(&arena);
    }
}

/* ---- Theorem 2 ----------------------------------------------------------------------------------------- */

/* How far a mesh reaches in a direction. */
static double reach(const mt_mesh *mesh, mt_vector3 direction) {
    double most = -INFINITY;
    for (int i = 0; i < mesh->n_points; i++) most = fmax(most, mt_dot3(mesh->points[i], direction));
    return most;
}

/* Whether p can be in r x ⊕ (1 - r) y for convex x and y, by a hundred directions. */
static bool may_be_in_sum(const mt_mesh *x, const mt_mesh *y, double r, mt_vector3 p, mt_random *random) {
    for (int i = 0; i < 100; i++) {
        mt_vector3 d = random_place(random, 1);
        if (mt_dot3(p, d) > r * reach(x, d) + (1 - r) * reach(y, d) + NEAR) return false;
    }
    return true;
}

static void the_solid_lies_in_the_sum(void **state) {
    (void)state;
    for (int i = 0; i < mt_test_cases(12); i++) {
        trial t = begin(i);
        mt_mesh at;
        mt_solid_morph morph = morph_of(&t.a, &t.b, &t.params);
        mt_assert_ok(mt_solid_at(&arena, &morph, t.r, &at));
        for (int k = 0; k < SAMPLES; k++) {
            mt_vector3 p = random_place(&t.random, 1.2);
            bool found = !in_solid(&morph, &at, p);
            for (int x = 0; x < morph.a.n_pieces && !found; x++)
                for (int y = 0; y < morph.b.n_pieces && !found; y++)
                    found = may_be_in_sum(&morph.a.pieces[x], &morph.b.pieces[y], t.r, p, &t.random);
            assert_true(found);
        }
        mt_arena_reset(&arena);
    }
}

/* ---- Theorem 3 ----------------------------------------------------------------------------------------- */

static mt_vector3 place_within(const mt_mesh *mesh, mt_random *random) {
    for (;;) {
        mt_vector3 p = random_place(random, 1.3);
        if (mt_test_turns(mesh->points, mesh->triangles, mesh->n_triangles, p) > 0.5 && !is_near(mesh, p))
            return p;
    }
}

static void a_convex_b_gives_the_sum(void **state) {
    (void)state;
    for (int i = 0; i < mt_test_cases(12); i++) {
        trial t = begin(i);
        mt_mesh convex = mt_test_box(&arena, (mt_vector3){-1, -0.5, -0.75}, (mt_vector3){0.25, 1, 0.5}), at;
        mt_solid_morph morph = morph_of(&t.a, &convex, &t.params);
        assert_int_equal(morph.b.n_pieces, 1);
        mt_assert_ok(mt_solid_at(&arena, &morph, t.r, &at));
        for (int k = 0; k < SAMPLES; k++) {
            mt_vector3 p = place_within(&t.a, &t.random), q = place_within(&convex, &t.random);
            assert_true(in_solid(&morph, &at, mt_between3(q, p, t.r)));
        }
        mt_arena_reset(&arena);
    }
}

/* ---- moving, scaling, swapping ------------------------------------------------------------------------- */

static mt_mesh moved(const mt_mesh *mesh, double scale, mt_vector3 by) {
    mt_mesh made = *mesh;
    made.points = mt_arena_new(&arena, (size_t)mesh->n_points, sizeof *made.points);
    assert_non_null(made.points);
    for (int i = 0; i < mesh->n_points; i++) made.points[i] = mt_plus3(mt_times3(scale, mesh->points[i]), by);
    return made;
}

/* By powers of two and whole numbers, so that the grid is the same. */
static void moving_and_scaling_commute(void **state) {
    (void)state;
    for (int i = 0; i < mt_test_cases(12); i++) {
        trial t = begin(i);
        if (i % 2) t.params.method = MT_METHOD_JOINT;
        mt_vector3 by = {4, -2, 8};
        mt_mesh a = moved(&t.a, 4, by), b = moved(&t.b, 4, by), whole, at;
        mt_solid_morph morph = morph_of(&t.a, &t.b, &t.params), other = morph_of(&a, &b, &t.params);
        mt_assert_ok(mt_solid_at(&arena, &other, t.r, &at));
        mt_assert_ok(mt_solid_at(&arena, &morph, t.r, &whole));
        mt_mesh expected = moved(&whole, 4, by);
        for (int k = 0; k < SAMPLES; k++) {
            mt_vector3 p = mt_plus3(by, random_place(&t.random, 5));
            if (is_near(&expected, p)) continue;
            assert_true(in_solid(&other, &at, p) == in_solid(&morph, &expected, p));
        }
        mt_arena_reset(&arena);
    }
}

static void swapped_solids_give_the_same(void **state) {
    (void)state;
    for (int i = 0; i < mt_test_cases(12); i++) {
        trial t = begin(i);
        if (i % 2) t.params.method = MT_METHOD_JOINT;
        mt_solid_morph morph = morph_of(&t.a, &t.b, &t.params), back = morph_of(&t.b, &t.a, &t.params);
        assert_int_equal(morph.n_links, back.n_links);
        for (int k = 0; k < morph.n_links; k++) {
            const mt_solid_link *link = &morph.links[k], *other = &back.links[k];
            assert_int_equal(link->piece_a, other->piece_b);
            assert_int_equal(link->piece_b, other->piece_a);
            assert_int_equal(link->n_points, other->n_points);
            assert_memory_equal(link->at_a, other->at_b, (size_t)link->n_points * sizeof *link->at_a);
            assert_memory_equal(link->at_b, other->at_a, (size_t)link->n_points * sizeof *link->at_b);
        }
        mt_arena_reset(&arena);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(links_are_closed),
        cmocka_unit_test(the_ends_are_a_and_b),
        cmocka_unit_test(a_with_itself_is_a),
        cmocka_unit_test(the_solid_lies_in_the_sum),
        cmocka_unit_test(a_convex_b_gives_the_sum),
        cmocka_unit_test(moving_and_scaling_commute),
        cmocka_unit_test(swapped_solids_give_the_same),
    };
    return cmocka_run_group_tests(tests, NULL, tear_down);
}
