/* Walls are tried by their area; the groups on both sides of one are divided further by the walls that are left within them. Each division
 * takes a link from a piece that has more than one and adds none, so it ends.
 *
 *        y1 │ y2                x ─── y1, y2           x1 ─── y1
 *     ──────┼──────             becomes
 *        wall                                          x2 ─── y2 */
#include "solid/share.h"

#include <stdlib.h>

#include "solid/cut.h"
#include "solid/decompose.h"
#include "solid/trial.h"
#include "space/vector.h"

/* A share is met when it is off by less than this share of the piece, or after so many steps. */
#define SHARE_NEAR 0.005
enum { STEPS = 24 };

/* Two counterparts of a piece that meet, and their wall. */
typedef struct mt_seam {
    int p, q;
    mt_vector3 normal; /* from p to q, as long as the wall's area is */
    mt_vector3 place;  /* on the wall */
} mt_seam;

/* One half is divided by the other's pieces. */
typedef struct mt_sharing {
    mt_half *own;
    const mt_half *other;
    mt_links *links;
    bool own_is_second; /* of the links */
} mt_sharing;

static int *own_end(const mt_sharing *s, mt_link *link) {
    return s->own_is_second ? &link->b : &link->a;
}

static int other_end(const mt_sharing *s, const mt_link *link) {
    return s->own_is_second ? link->a : link->b;
}

/* ---- seams --------------------------------------------------------------------------------------------- */

/* What a piece of the other half gives to each piece that it is linked with: as much of its volume to all. */
static double share_of(const mt_sharing *s, int counterpart) {
    int n = 0;
    for (int i = 0; i < s->links->count; i++) n += other_end(s, &s->links->links[i]) == counterpart;
    return s->other->volumes[counterpart] / n;
}

static bool is_counterpart(const mt_sharing *s, int piece, int of_other) {
    for (int i = 0; i < s->links->count; i++) {
        mt_link *link = &s->links->links[i];
        if (*own_end(s, link) == piece && other_end(s, link) == of_other) return true;
    }
    return false;
}

/* The wall between two pieces of the other half. */
static mt_seam seam_of(const mt_sharing *s, int p, int q) {
    const mt_cells *cells = &s->other->cells;
    mt_seam seam = {.p = p, .q = q};
    double area = 0;
    for (int w = 0; w < cells->n_walls; w++) {
        const mt_wall *wall = &cells->walls[w];
        bool along = wall->behind == p && wall->in_front == q,
             against = wall->behind == q && wall->in_front == p;
        if (!along && !against) continue;
        mt_vector3 a = mt_place_vector(cells->points[wall->at[0]]),
                   b = mt_place_vector(cells->points[wall->at[1]]),
                   c = mt_place_vector(cells->points[wall->at[2]]);
        mt_vector3 normal = mt_cross3(mt_minus3(b, a), mt_minus3(c, a));
        double own = mt_length3(normal);
        seam.normal = mt_plus3(seam.normal, mt_times3(along ? 1 : -1, normal));
        seam.place = mt_plus3(seam.place, mt_times3(own / 3, mt_plus3(a, mt_plus3(b, c))));
        area += own;
    }
    if (area > 0) seam.place = mt_times3(1 / area, seam.place);
    return seam;
}

static int larger(const void *p, const void *q) {
    const mt_seam *x = p, *y = q;
    double of_x = mt_length3(x->normal), of_y = mt_length3(y->normal);
    if (of_x != of_y) return (of_x < of_y) - (of_x > of_y);
    return x->p != y->p ? (x->p > y->p) - (x->p < y->p) : (x->q > y->q) - (x->q < y->q);
}

/* The seams between the counterparts of a piece, the largest first. */
static mt_status find_seams(mt_arena *arena, const mt_sharing *s, int piece, mt_seam **seams, int *n) {
    int count = s->other->n_pieces, room = 0;
    *seams = NULL;
    *n = 0;
    for (int p = 0; p < count; p++) {
        if (!is_counterpart(s, piece, p)) continue;
        for (int q = p + 1; q < count; q++) {
            if (!s->other->meets[(size_t)p * (size_t)count + (size_t)q] || !is_counterpart(s, piece, q))
                continue;
            *seams = mt_arena_grow_list(arena, *seams, *n, &room, sizeof **seams);
            if (!*seams) return MT_NO_MEMORY;
            (*seams)[(*n)++] = seam_of(s, p, q);
        }
    }
    if (*n > 0) qsort(*seams, (size_t)*n, sizeof **seams, larger);
    return MT_OK;
}

/* Whether a piece of the other half lies behind the seam. */
static bool is_behind(const mt_sharing *s, const mt_seam *seam, int of_other) {
    return mt_dot3(seam->normal, mt_minus3(s->other->centres[of_other], seam->place)) < 0;
}

/* ---- the plane ----------------------------------------------------------------------------------------- */

/* The share of the volume of a piece's counterparts that lies behind the seam. */
static double wanted_share(const mt_sharing *s, int piece, const mt_seam *seam) {
    double behind = 0, all = 0;
    for (int i = 0; i < s->links->count; i++) {
        mt_link *link = &s->links->links[i];
        if (*own_end(s, link) != piece) continue;
        double share = share_of(s, other_end(s, link));
        all += share;
        if (is_behind(s, seam, other_end(s, link))) behind += share;
    }
    return behind / all;
}

/* The plane along the seam that has that share of a part behind it; false when it would make more than two balls of it. */
static mt_status find_plane(const mt_part *part, const mt_seam *seam, double wanted, mt_plane *plane,
                            bool *found) {
    double volume = mt_part_volume(part), low = INFINITY, high = -INFINITY;
    mt_vector3 normal = mt_times3(1 / mt_length3(seam->normal), seam->normal);
    mt_trial trial = {0};
    mt_status status = MT_OK;
    for (int p = 0; p < part->n_points; p++) {
        double far = mt_dot3(normal, part->places[p]);
        low = fmin(low, far);
        high = fmax(high, far);
    }
    for (int step = 0; status == MT_OK && step < STEPS; step++) {
        mt_vector3 at = mt_times3((low + high) / 2, normal);
        *plane = mt_plane_along(
            normal, (mt_place){(int32_t)lround(at.x), (int32_t)lround(at.y), (int32_t)lround(at.z)});
        status = mt_trial_of(part, plane, &trial);
        double off = trial.behind / volume - wanted;
        if (fabs(off) < SHARE_NEAR) break;
        if (off < 0)
            low = (low + high) / 2;
        else
            high = (low + high) / 2;
    }
    *found = status == MT_OK && trial.n_parts == 2 && trial.n_handles == 0;
    return status;
}

/* ---- a division ---------------------------------------------------------------------------------------- */

/* Whether both parts of a cell that has been cut are as pieces have to be. */
static mt_status are_done(mt_arena *arena, const mt_half *half, int behind, int in_front, bool *done) {
    mt_status status = MT_OK;
    *done = true;
    for (int i = 0; i < 2 && status == MT_OK && *done; i++) {
        mt_part part;
        mt_depth found;
        status = mt_part_of(arena, &half->cells, i ? in_front : behind, -1, &part);
        if (status == MT_OK) status = mt_part_is_done(arena, &half->cells, &part, half->depth, done, &found);
    }
    return status;
}

/* Cuts a piece; or leaves it as it was, but for points that have come on its edges. */
static mt_status divide(mt_arena *arena, mt_half *half, int piece, mt_plane plane, bool *done) {
    mt_cells *cells = &half->cells;
    int before = cells->n_cells;
    mt_status status = mt_cells_cut(cells, piece, plane);
    *done = false;
    if (status != MT_OK) return status == MT_BAD_GEOMETRY ? MT_OK : status;
    if (cells->n_cells == before + 1) status = are_done(arena, half, piece, before, done);
    if (status == MT_BAD_GEOMETRY) status = MT_OK;
    if (*done) return status;
    for (int cell = before; cell < cells->n_cells; cell++) mt_cells_merge(cells, piece, cell);
    cells->n_cells = before;
    return status;
}

/* Divides a piece by a seam; the part in front gets the last number. */
static mt_status divide_by(mt_arena *arena, mt_sharing *s, int piece, const mt_seam *seam, bool *done) {
    mt_part part;
    mt_plane plane;
    bool found = false;
    *done = false;
    if (!is_behind(s, seam, seam->p) || is_behind(s, seam, seam->q)) return MT_OK;
    mt_status status = mt_part_of(arena, &s->own->cells, piece, -1, &part);
    if (status == MT_OK) status = find_plane(&part, seam, wanted_share(s, piece, seam), &plane, &found);
    if (status == MT_OK && found) status = divide(arena, s->own, piece, plane, done);
    for (int i = 0; *done && i < s->links->count; i++) {
        mt_link *link = &s->links->links[i];
        if (*own_end(s, link) == piece && !is_behind(s, seam, other_end(s, link)))
            *own_end(s, link) = s->own->cells.n_cells - 1;
    }
    return status;
}

/* Divides a piece by the first seam that it can be divided by. */
static mt_status divide_once(mt_sharing *s, int piece, bool *done) {
    mt_arena scratch = {0};
    mt_seam *seams;
    int n;
    mt_status status = find_seams(&scratch, s, piece, &seams, &n);
    *done = false;
    for (int i = 0; status == MT_OK && !*done && i < n; i++)
        status = divide_by(&scratch, s, piece, &seams[i], done);
    mt_arena_release(&scratch);
    return status;
}

/* ---- all of it ----------------------------------------------------------------------------------------- */

/* Divides the pieces of one half; those that are made come last, and their turn comes. */
static mt_status share_half(mt_arena *arena, mt_sharing *s) {
    int before = s->own->cells.n_cells;
    mt_status status = MT_OK;
    for (int piece = 0; status == MT_OK && piece < s->own->cells.n_cells; piece++)
        for (bool done = true; status == MT_OK && done;) status = divide_once(s, piece, &done);
    return status == MT_OK && s->own->cells.n_cells > before ? mt_half_measure(arena, s->own) : status;
}

mt_status mt_links_share(mt_arena *arena, mt_half *first, mt_half *second, mt_links *links) {
    mt_status status = share_half(arena, &(mt_sharing){first, second, links, false});
    if (status == MT_OK) status = share_half(arena, &(mt_sharing){second, first, links, true});
    if (status == MT_OK) qsort(links->links, (size_t)links->count, sizeof *links->links, mt_link_compare);
    return status;
}
