/* The invariants of a morph's structs. O(n) for n points, segments and links. */
#include "morph/model/morph.h"

int mt_link_compare(const void *p, const void *q) {
    const mt_link *x = p, *y = q;
    return x->a != y->a ? (x->a > y->a) - (x->a < y->a) : (x->b > y->b) - (x->b < y->b);
}

bool mt_links_is_valid(const mt_links *links, int count_a, int count_b) {
    bool valid = links->count >= 0;
    for (int i = 0; valid && i < links->count; i++) {
        mt_link link = links->links[i];
        valid = link.a >= 0 && link.a < count_a && link.b >= 0 && link.b < count_b &&
                (i == 0 || mt_link_compare(&links->links[i - 1], &link) < 0);
    }
    return valid;
}

bool mt_side_is_valid(const mt_side *side) {
    bool valid = mt_shape_is_valid(&side->whole) && mt_shape_is_valid(&side->shape) &&
                 mt_pieces_is_valid(&side->pieces);
    for (int k = 0; valid && side->first && k < side->shape.count; k++) {
        int count = side->first[k + 1] - side->first[k];
        valid = side->aligned && side->aligned[k] ? count == 0 : count > 0;
    }
    return valid && (!side->first || side->first[side->shape.count] == side->pieces.count);
}

bool mt_contour_pair_is_valid(const mt_contour_pair *pair) {
    bool valid = pair->a.count == pair->b.count && mt_contour_is_valid(&pair->a);
    for (int i = 0; valid && i < pair->a.count; i++)
        valid = pair->a.segments[i].degree == pair->b.segments[i].degree && pair->a.segments[i].degree <= 2;
    return valid;
}

bool mt_variable_outline_is_valid(const mt_variable_outline *outline) {
    bool valid = outline->count >= 0;
    for (int i = 0; valid && i < outline->count; i++) valid = mt_contour_pair_is_valid(&outline->contours[i]);
    return valid;
}

bool mt_morph_is_valid(const mt_morph *morph) {
    const mt_variable_outline contours = {morph->contour_count, morph->contours};
    return mt_side_is_valid(&morph->a) && mt_side_is_valid(&morph->b) &&
           mt_links_is_valid(&morph->matches, morph->a.shape.count, morph->b.shape.count) &&
           mt_links_is_valid(&morph->links, morph->a.pieces.count, morph->b.pieces.count) &&
           mt_variable_outline_is_valid(&contours);
}
