/* From a place to the two fonts around it. */
#include "glyphset/places.h"

mt_places mt_places_of_fonts(double at[MT_STOPS_MAX], mt_var_store *store) {
    const mt_stops *stops = &store->stops;
    for (int i = 0; i < stops->count; i++) at[i] = mt_stops_font(stops, i);
    return (mt_places){stops->count, stops->count, at, store};
}

mt_between mt_between_at(const mt_places *places, int i) {
    double at = places->at[i];
    int last = places->font_count - 2, first = at < 0 ? 0 : at < last ? (int)at : last;
    return (mt_between){first, at - first};
}
