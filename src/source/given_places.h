/* Glyphs of the first font that lie at places of their own, wherever the others do. */
#pragma once

#include "geometry/point.h"
#include "source/font.h"

typedef struct mt_given_place {
    uint32_t glyph;
    mt_at at;
} mt_given_place;

typedef struct mt_given_places {
    int count;
    mt_given_place *list; /* ascending by glyph, each once */
} mt_given_places;        /* all zero is empty */

/* Of `count` glyphs in any order and T of each, upwards as across where `up` is NULL. MT_BAD_PARAMETER for a glyph that the font has
 * not, and for one that is there twice; MT_NO_MEMORY. */
mt_status mt_given_places_make(const uint32_t *glyphs, const double *t, const double *up, int count,
                               const mt_font *font, mt_given_places *places);
void mt_given_places_free(mt_given_places *places);

/* The glyph's own place; `otherwise` where none is given. */
mt_at mt_given_place_of(const mt_given_places *places, uint32_t glyph, mt_at otherwise);
