/* The vector between two moving points moves evenly too: from u₀ to u₁. So the cross product of two, and the dot product, is a quadratic
 * in the place, whose Bernstein coefficients need no more than the vectors at both ends of some steps:
 *
 *     u₀ × v₀,   u₀ × v₁ + u₁ × v₀,   u₁ × v₁          none negative, not all 0: positive everywhere in between
 *
 * Where the signs differ the steps are halved, down to single ones. All numbers are integers, so that no sign is in doubt. Invariant: a
 * place that is not in what is found is proved to be free. O(log MT_WAY_STEPS) for each stretch found. */
#include "morph/check/way.h"

/* A vector at the first of some steps and at the last, times MT_WAY_STEPS. */
typedef struct mt_change {
    int64_t x[2], y[2];
} mt_change;

/* ---- signs ------------------------------------------------------------------------------------------------------ */

/* Of a quadratic within its steps: what it is everywhere, or 0. */
static int steady_sign(const mt_wide b[3], const mt_steps *steps) {
    bool none_negative = b[0] >= 0 && b[1] >= 0 && b[2] >= 0,
         none_positive = b[0] <= 0 && b[1] <= 0 && b[2] <= 0;
    if (none_negative == none_positive) return 0; /* mixed, or all 0 */
    if ((b[0] == 0 && !steps->open_from) || (b[2] == 0 && !steps->open_to)) return 0;
    return none_negative ? 1 : -1;
}

static bool is_zero(const mt_wide b[3]) {
    return b[0] == 0 && b[1] == 0 && b[2] == 0;
}

static void cross(const mt_change *u, const mt_change *v, mt_wide b[3]) {
    b[0] = (mt_wide)u->x[0] * v->y[0] - (mt_wide)u->y[0] * v->x[0];
    b[1] = (mt_wide)u->x[0] * v->y[1] - (mt_wide)u->y[0] * v->x[1] + (mt_wide)u->x[1] * v->y[0] -
           (mt_wide)u->y[1] * v->x[0];
    b[2] = (mt_wide)u->x[1] * v->y[1] - (mt_wide)u->y[1] * v->x[1];
}

static void dot(const mt_change *u, const mt_change *v, mt_wide b[3]) {
    b[0] = (mt_wide)u->x[0] * v->x[0] + (mt_wide)u->y[0] * v->y[0];
    b[1] = (mt_wide)u->x[0] * v->x[1] + (mt_wide)u->y[0] * v->y[1] + (mt_wide)u->x[1] * v->x[0] +
           (mt_wide)u->y[1] * v->y[0];
    b[2] = (mt_wide)u->x[1] * v->x[1] + (mt_wide)u->y[1] * v->y[1];
}

/* ---- vectors ---------------------------------------------------------------------------------------------------- */

static int64_t mixed(int32_t at_start, int32_t at_end, int step) {
    return (int64_t)at_start * (MT_WAY_STEPS - step) + (int64_t)at_end * step;
}

static mt_change change_between(const mt_way *p, const mt_way *q, const mt_steps *steps) {
    mt_point from = {q->at[0].x - p->at[0].x, q->at[0].y - p->at[0].y},
             to = {q->at[1].x - p->at[1].x, q->at[1].y - p->at[1].y};
    return (mt_change){{mixed(from.x, to.x, steps->from), mixed(from.x, to.x, steps->to)},
                       {mixed(from.y, to.y, steps->from), mixed(from.y, to.y, steps->to)}};
}

int mt_steady_side(const mt_way *a, const mt_way *b, const mt_way *c, mt_steps steps) {
    mt_change ab = change_between(a, b, &steps), ac = change_between(a, c, &steps);
    mt_wide side[3];
    cross(&ab, &ac, side);
    return steady_sign(side, &steps);
}

bool mt_stays_between(const mt_way *a, const mt_way *b, const mt_way *c, mt_steps steps) {
    mt_change ab = change_between(a, b, &steps), ac = change_between(a, c, &steps),
              bc = change_between(b, c, &steps);
    mt_wide after_a[3], after_b[3];
    dot(&ab, &ac, after_a);
    dot(&ab, &bc, after_b);
    return steady_sign(after_a, &steps) > 0 && steady_sign(after_b, &steps) < 0;
}

/* ---- search ------------------------------------------------------------------------------------------------------ */

/* Three points: c on the segment ab, or ab and ac folded onto one another. */
typedef struct mt_search {
    const mt_way *a, *b, *c;
    bool folds;
    int count;
    mt_steps *found;
} mt_search;

/* Whether c is beside the segment, or the fold open, all along. *stays: c is on the line all along. */
static bool is_free(const mt_search *s, const mt_steps *steps, bool *stays) {
    mt_change ab = change_between(s->a, s->b, steps), ac = change_between(s->a, s->c, steps);
    mt_wide b[3];
    cross(&ab, &ac, b);
    *stays = is_zero(b);
    if (steady_sign(b, steps) != 0) return true;
    dot(&ab, &ac, b);
    if (steady_sign(b, steps) < 0) return true;
    if (s->folds) return false;
    mt_change bc = change_between(s->b, s->c, steps);
    dot(&ab, &bc, b);
    return steady_sign(b, steps) > 0;
}

static void add(mt_search *s, mt_steps steps) {
    if (s->count > 0 && s->found[s->count - 1].to == steps.from) {
        s->found[s->count - 1].to = steps.to;
        s->found[s->count - 1].open_to = steps.open_to;
    } else if (s->count < MT_PASSES_MOST) {
        s->found[s->count++] = steps;
    } else {
        s->found[s->count - 1].to = steps.to; /* all from there on: more than there is, never less */
        s->found[s->count - 1].open_to = steps.open_to;
    }
}

static void halve(mt_search *s, mt_steps steps) {
    bool stays;
    if (is_free(s, &steps, &stays)) return;
    if (steps.to - steps.from == 1) {
        add(s, steps);
        return;
    }
    int middle = steps.from + (steps.to - steps.from) / 2;
    halve(s, (mt_steps){steps.from, middle, steps.open_from, false});
    halve(s, (mt_steps){middle, steps.to, false, steps.open_to});
}

static int search(mt_search *s, mt_steps steps) {
    bool stays;
    if (is_free(s, &steps, &stays)) return 0;
    if (stays) return -1;
    halve(s, steps);
    return s->count;
}

int mt_passes(const mt_way *a, const mt_way *b, const mt_way *c, mt_steps steps,
              mt_steps found[MT_PASSES_MOST]) {
    mt_search s = {a, b, c, false, 0, found};
    return search(&s, steps);
}

int mt_folds(const mt_way *v, const mt_way *a, const mt_way *b, mt_steps steps,
             mt_steps found[MT_PASSES_MOST]) {
    mt_search s = {v, a, b, true, 0, found};
    return search(&s, steps);
}
