/* Fields in the order of morph/model/morph.h: one that is added there is added here. A shape that is the same as one before is told by a
 * bit. O(n) for n points. */
#include "cache/prepared.h"

#include <limits.h>
#include <string.h>

#include "cache/packing.h"
#include "geometry/limits.h"

/* ---- fields ------------------------------------------------------------------------------------------------ */

/* The shape, or that it is `other`. */
static void pack_like(mt_packing *packing, const mt_shape *other, mt_shape *shape) {
    bool same = shape->count == other->count && shape->components == other->components;
    mt_pack_bool(packing, &same);
    if (same)
        *shape = *other;
    else
        mt_pack_shape(packing, shape);
}

static void pack_frame(mt_packing *packing, mt_frame *frame) {
    mt_pack_box(packing, &frame->box);
    for (int i = 0; i < 4; i++) mt_pack_double(packing, &frame->x[i]);
    for (int i = 0; i < 4; i++) mt_pack_double(packing, &frame->y[i]);
    for (int i = 0; i < 4; i++) mt_pack_double(packing, &frame->heading[i]);
}

/* A list with an item for each component, and `more`; or none. */
static void *pack_by_component(mt_packing *packing, const mt_side *side, int more, void *list, size_t size) {
    int count = side->shape.count + more;
    bool known = list != NULL;
    mt_pack_bool(packing, &known);
    if (packing->out || !known) return list;
    list = mt_arena_new(packing->arena, (size_t)count, size);
    if (!list && packing->status == MT_OK) packing->status = MT_NO_MEMORY;
    return list;
}

static void pack_side(mt_packing *packing, mt_side *side) {
    mt_pack_shape(packing, &side->whole);
    pack_like(packing, &side->whole, &side->shape);
    mt_pack_box(packing, &side->box);
    pack_frame(packing, &side->frame);
    side->aligned = pack_by_component(packing, side, 0, side->aligned, sizeof *side->aligned);
    for (int k = 0; side->aligned && k < side->shape.count; k++) mt_pack_bool(packing, &side->aligned[k]);
    mt_pack_rings(packing, &side->pieces);
    side->first = pack_by_component(packing, side, 1, side->first, sizeof *side->first);
    for (int k = 0; side->first && k <= side->shape.count; k++)
        mt_pack_int(packing, &side->first[k], 0, INT_MAX);
}

static void pack_links(mt_packing *packing, mt_links *links) {
    links->links = mt_pack_list(packing, &links->count, links->links, sizeof *links->links);
    for (int i = 0; i < links->count; i++) {
        mt_pack_int(packing, &links->links[i].a, 0, INT_MAX);
        mt_pack_int(packing, &links->links[i].b, 0, INT_MAX);
    }
}

static void pack_contours(mt_packing *packing, mt_morph *morph) {
    enum { QUADRATIC = 2 };
    morph->contours = mt_pack_list(packing, &morph->contour_count, morph->contours, sizeof *morph->contours);
    for (int i = 0; i < morph->contour_count; i++) {
        mt_pack_contour(packing, &morph->contours[i].a, QUADRATIC);
        mt_pack_contour(packing, &morph->contours[i].b, QUADRATIC);
        mt_pack_point(packing, &morph->contours[i].displacement);
    }
}

static void pack_morph(mt_packing *packing, mt_morph *morph) {
    pack_side(packing, &morph->a);
    pack_side(packing, &morph->b);
    pack_links(packing, &morph->matches);
    pack_contours(packing, morph);
    pack_links(packing, &morph->links);
    mt_pack_double(packing, &morph->degrees);
    mt_pack_bool(packing, &morph->proved);
    mt_pack_bool(packing, &morph->cut_short);
}

static void pack(mt_packing *packing, mt_prepared *prepared) {
    int status = (int)prepared->status;
    mt_pack_int(packing, &status, MT_OK, MT_STOPPED);
    prepared->status = (mt_status)status;
    mt_pack_int(packing, &prepared->at_fault, -1, 1);
    if (prepared->status == MT_OK) pack_morph(packing, &prepared->morph);
    pack_like(packing, &prepared->morph.a.whole, &prepared->a);
    pack_like(packing, &prepared->morph.b.whole, &prepared->b);
}

/* ---- what is valid ----------------------------------------------------------------------------------------- */

/* A frame is not asked for where boundaries are not compared. */
static bool frame_is_sound(const mt_frame *frame) {
    const mt_frame none = {0};
    return mt_frame_is_valid(frame) || memcmp(frame, &none, sizeof none) == 0;
}

static bool side_is_sound(const mt_side *side) {
    bool sound = side->whole.count <= MT_COMPONENTS_MAX && side->shape.count <= MT_COMPONENTS_MAX;
    for (int k = 0; sound && side->first && k < side->shape.count; k++)
        sound = (k > 0 || side->first[0] == 0) && side->first[k] <= side->first[k + 1] &&
                side->first[k + 1] <= side->pieces.count;
    return sound && frame_is_sound(&side->frame) && (side->first || side->shape.count == 0);
}

static bool is_sound(const mt_prepared *prepared) {
    const mt_morph *morph = &prepared->morph;
    bool sound = mt_prepared_is_lasting(prepared) && mt_shape_is_valid(&prepared->a) &&
                 mt_shape_is_valid(&prepared->b);
    if (!sound || prepared->status != MT_OK) return sound;
    return side_is_sound(&morph->a) && side_is_sound(&morph->b) && mt_morph_is_valid(morph);
}

bool mt_prepared_is_lasting(const mt_prepared *prepared) {
    switch (prepared->status) {
    case MT_OK:
    case MT_BAD_GLYPH:
    case MT_NO_COUNTERPART:
    case MT_TOO_LARGE:
    case MT_BAD_GEOMETRY:
    case MT_TOO_COSTLY: return true;
    default: return false;
    }
}

/* ---- both ways ----------------------------------------------------------------------------------------------- */

mt_status mt_prepared_pack(const mt_prepared *prepared, mt_buffer *out) {
    mt_packing packing = mt_packing_to(out);
    mt_prepared copy = *prepared; /* what it leads to is written as it was */
    pack(&packing, &copy);
    return mt_packing_end(&packing);
}

mt_status mt_prepared_unpack(const uint8_t *bytes, size_t length, mt_arena *arena, mt_prepared *prepared) {
    mt_packing packing = mt_packing_from(bytes, length, arena);
    mt_prepared made = {0};
    pack(&packing, &made);
    mt_status status = mt_packing_end(&packing);
    if (status == MT_OK && !is_sound(&made)) status = MT_BAD_GEOMETRY;
    if (status == MT_OK) *prepared = made;
    return status;
}
