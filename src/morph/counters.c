#include "morph/counters.h"

#include "geometry/limits.h"
#include "geometry/outline.h"
#include "morph/homes.h"
#include "morph/masters.h"

/* A glyph that strays. */
typedef struct mt_glyph {
    const mt_morph *morph;
    const mt_params *params;
    int least; /* the least holes that an end has */
} mt_glyph;

/* ---- a place ------------------------------------------------------------------------------------------------- */

static mt_status holes_at(const mt_glyph *glyph, double t, mt_arena *arena, mt_shape *shape, int *holes) {
    mt_status status = mt_census_shape(glyph->morph, t, glyph->params, arena, shape);
    if (status == MT_OK) *holes = mt_census_of(shape).holes;
    return status;
}

static bool has_hole_of_area(const mt_shape *shape, int64_t area2) {
    for (int k = 0; k < shape->count; k++)
        for (int i = 1; i < shape->components[k].count; i++)
            if (mt_ring_area2(&shape->components[k].rings[i]) == area2) return true;
    return false;
}

/* Whether a contour runs around a hole, and not all of what it runs around is one at this place. */
static mt_status is_open(const mt_glyph *glyph, int contour, double t, const mt_shape *shape, mt_arena *arena,
                         bool *open) {
    const mt_masters *masters = &glyph->morph->contours[contour];
    mt_contour mixed;
    mt_rings rings;
    *open = false;
    if (mt_masters_area(masters) >= 0) return MT_OK;
    mt_status status = mt_masters_mix(masters, mt_weights_at(t), arena, &mixed);
    if (status == MT_OK)
        status = mt_flatten(&(mt_outline){1, &mixed}, mt_grid_units(glyph->params->tolerance), arena, &rings);
    if (status == MT_OK) *open = !has_hole_of_area(shape, mt_ring_area2(&rings.rings[0]));
    return status;
}

/* ---- keeping clear ------------------------------------------------------------------------------------------- */

/* How the glyph strays as it is, if there are more than `holes` at the place; else as `by` says. */
static mt_status look(const mt_glyph *glyph, double t, int holes, mt_arena *arena, mt_straying *by) {
    mt_arena_place before = mt_arena_mark(arena);
    mt_shape shape;
    int now = 0;
    mt_status status = holes_at(glyph, t, arena, &shape, &now);
    mt_arena_rewind(arena, before);
    if (status == MT_OK && now > holes)
        status = mt_morph_strays(glyph->morph, by->parts, glyph->params, arena, by);
    return status;
}

/* Lets a hole's contour go the way, of those that are tried, on which the glyph strays least. */
static mt_status keep_clear(const mt_glyph *glyph, int hole, double t, int holes, mt_arena *arena,
                            mt_straying *by) {
    mt_masters *contour = &glyph->morph->contours[hole];
    mt_point best = {0, 0};
    for (int i = 0; i < MT_ASIDE_WAYS && by->parts > 0; i++) {
        mt_straying tried = *by;
        mt_point way = mt_aside_way(i);
        mt_shift_contour(contour, way);
        mt_status status = look(glyph, t, holes, arena, &tried);
        if (status != MT_OK) return status;
        mt_shift_contour(contour, (mt_point){-way.x, -way.y});
        if (tried.parts >= by->parts) continue;
        best = way;
        *by = tried;
    }
    mt_shift_contour(contour, best);
    return MT_OK;
}

/* Keeps the holes that are open at a place. *closed: none are missing there, or fewer now. */
static mt_status keep_at(const mt_glyph *glyph, double t, mt_arena *arena, mt_straying *by, bool *closed) {
    mt_shape shape;
    int holes, before = by->parts;
    mt_status status = holes_at(glyph, t, arena, &shape, &holes);
    for (int i = 0; status == MT_OK && holes < glyph->least && i < glyph->morph->contour_count; i++) {
        bool open;
        status = is_open(glyph, i, t, &shape, arena, &open);
        if (status == MT_OK && open) status = keep_clear(glyph, i, t, holes, arena, by);
    }
    *closed = status == MT_OK && (holes >= glyph->least || by->parts < before);
    return status;
}

/* ---- all of it ----------------------------------------------------------------------------------------------- */

/* From half-way, where contours stand aside the most, outwards; as long as that goes. */
mt_status mt_keep_counters(mt_morph *morph, const mt_params *params, mt_arena *arena, mt_straying *by) {
    int in_a = mt_census_of(&morph->a.whole).holes, in_b = mt_census_of(&morph->b.whole).holes;
    mt_glyph glyph = {morph, params, in_a < in_b ? in_a : in_b};
    mt_status status = MT_OK;
    bool closed = true;
    for (int i = 0; status == MT_OK && closed && by->parts > 0 && i < MT_CENSUS_STEPS; i++)
        status = keep_at(&glyph, mt_census_place(morph, i), arena, by, &closed);
    return status;
}
