/* From a place to the two fonts around it. */
#include "glyphset/places.h"

mt_places mt_places_of_fonts(mt_at at[MT_STOPS_MAX], mt_var_store *store) {
    const mt_stops *stops = &store->stops;
    for (int i = 0; i < stops->count; i++) at[i] = mt_at_both(mt_stops_font(stops, i));
    return (mt_places){stops->count, stops->count, at, NULL, store};
}

mt_places mt_places_of_one(const mt_font_at *at, int font_count) {
    return (mt_places){font_count, 1, &at->at, at->glyphs, NULL};
}

static mt_between between(const mt_places *places, mt_at place, mt_direction direction) {
    double at = direction == MT_UP ? place.y : place.x;
    int last = places->font_count - 2, first = at < 0 ? 0 : at < last ? (int)at : last;
    return (mt_between){first, at - first};
}

mt_between mt_between_at(const mt_places *places, int i, mt_direction direction) {
    return between(places, places->at[i], direction);
}

mt_between mt_between_at_glyph(const mt_places *places, int i, int glyph, mt_direction direction) {
    return between(places, places->glyphs ? places->glyphs[glyph] : places->at[i], direction);
}

mt_between mt_between_at_pair(const mt_places *places, mt_at left, mt_at right, mt_direction direction) {
    return between(places, mt_at_between(left, right, 0.5), direction);
}
