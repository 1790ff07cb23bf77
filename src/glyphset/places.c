/* From a place to the two fonts around it. */
#include "glyphset/places.h"

mt_places mt_places_of_fonts(int font_count, double at[MT_STOPS_MAX], mt_var_store *store) {
    for (int i = 0; i < font_count; i++) at[i] = i;
    return (mt_places){font_count, font_count, at, store};
}

mt_between mt_between_at(const mt_places *places, int i) {
    double at = places->at[i];
    int last = places->font_count - 2, first = at < last ? (int)at : last;
    return (mt_between){first, at - first};
}
