/* From a place to the two fonts around it. */
#include "glyphset/places.h"

mt_between mt_between_at(const mt_places *places, int i) {
    double at = places->at[i];
    int last = places->font_count - 2, first = at < last ? (int)at : last;
    return (mt_between){first, at - first};
}
