/* Contours of neighbouring steps need not be compatible: a glyph has those of all steps. The axis has whole places, so that a
 * segment's contours go at one place and the next segment's are there at the next, with nothing in between:
 *
 *     place             0 … 8192   8193 … 16384
 *     first segment     moves      collapsed
 *     second segment    collapsed  moves
 */
#include "blend/join.h"

#include "geometry/limits.h"
#include "sfnt/axis.h"

typedef struct mt_track_joiner {
    mt_making *making;
    const mt_outlines *outlines;
    int glyph;
    const mt_composite *composite;
    int segment_count;
    const mt_track_segment **segments; /* of all steps, in order */
    mt_glyf glyf;                      /* as the font stands */
    int place_count;                   /* with 0 among them, … */
    int *places;
    int home;           /* … which is this one: where the font stands without a setting */
    int own_points;     /* of contours, or references */
    mt_font_point **at; /* at each place, all points */
} mt_track_joiner;

/* ---- what there is ------------------------------------------------------------------------------------- */

static const mt_glyph_track *track_of(const mt_track_joiner *joiner, int step) {
    return &joiner->outlines->tracks[step][joiner->glyph];
}

static mt_status list_segments(mt_track_joiner *joiner) {
    int steps = joiner->making->step_count;
    size_t room = 0;
    for (int i = 0; i < steps; i++) room += (size_t)track_of(joiner, i)->segment_count;
    joiner->segments = mt_arena_new(&joiner->making->arena, room, sizeof *joiner->segments);
    if (!joiner->segments) return MT_NO_MEMORY;
    for (int i = 0; i < steps; i++)
        for (int k = 0; k < track_of(joiner, i)->segment_count; k++)
            joiner->segments[joiner->segment_count++] = &track_of(joiner, i)->segments[k];
    return MT_OK;
}

/* The places of the segments, which follow one another; of a composite, those of the fonts. */
static mt_status list_places(mt_track_joiner *joiner) {
    int fonts = joiner->making->row->font_count;
    size_t room = (size_t)fonts;
    for (int i = 0; i < joiner->segment_count; i++) room += (size_t)joiner->segments[i]->place_count;
    joiner->places = mt_arena_new(&joiner->making->arena, room, sizeof(int));
    if (!joiner->places) return MT_NO_MEMORY;
    for (int i = 0; i < joiner->segment_count; i++)
        for (int k = 0; k < joiner->segments[i]->place_count; k++)
            joiner->places[joiner->place_count++] = joiner->segments[i]->places[k];
    for (int i = 0; joiner->segment_count == 0 && i < fonts; i++)
        joiner->places[joiner->place_count++] = joiner->outlines->stops.at[i];
    while (joiner->places[joiner->home] < 0) joiner->home++;
    return MT_OK;
}

/* Room for all points at all places. */
static mt_status start_points(mt_track_joiner *joiner) {
    size_t points = (size_t)joiner->own_points + MT_PHANTOM_POINTS;
    mt_arena *arena = &joiner->making->arena;
    joiner->at = mt_arena_new(arena, (size_t)joiner->place_count, sizeof *joiner->at);
    if (!joiner->at) return MT_NO_MEMORY;
    for (int i = 0; i < joiner->place_count; i++) {
        joiner->at[i] = mt_arena_new(arena, points, sizeof(mt_font_point));
        if (!joiner->at[i]) return MT_NO_MEMORY;
    }
    return MT_OK;
}

/* ---- contours ------------------------------------------------------------------------------------------ */

static mt_status list_contours(mt_track_joiner *joiner) {
    size_t contours = 0, points = 0;
    mt_glyf *glyf = &joiner->glyf;
    for (int i = 0; i < joiner->segment_count; i++) {
        contours += (size_t)joiner->segments[i]->contour_count;
        points += (size_t)mt_track_segment_points(joiner->segments[i]);
        glyf->overlaps = glyf->overlaps || joiner->segments[i]->overlaps;
    }
    if (contours > MT_GLYF_CONTOURS_MAX || points > MT_GLYF_POINTS_MAX) return MT_TOO_LARGE;
    glyf->ends = mt_arena_new(&joiner->making->arena, contours, sizeof(int));
    glyf->points = mt_arena_new(&joiner->making->arena, points, sizeof(mt_glyf_point));
    if (!glyf->ends || !glyf->points) return MT_NO_MEMORY;
    for (int i = 0; i < joiner->segment_count; i++) {
        const mt_track_segment *segment = joiner->segments[i];
        for (int k = 0; k < segment->contour_count; k++)
            glyf->ends[glyf->contour_count++] = joiner->own_points + segment->ends[k];
        for (int k = 0; k < mt_track_segment_points(segment); k++)
            glyf->points[joiner->own_points++].on = segment->points[0][k].on;
    }
    return MT_OK;
}

/* Where the contours of all other segments are collapsed to: on the first point of the one at hand, so that the glyph reaches
 * no further than its ink. */
static mt_font_point collapsed_at(const mt_track_segment *segment, int row) {
    if (segment->contour_count == 0) return (mt_font_point){0, 0};
    return (mt_font_point){segment->points[row][0].x, segment->points[row][0].y};
}

static void place_contours(mt_track_joiner *joiner, int at_hand, int row, mt_font_point *at) {
    mt_font_point elsewhere = collapsed_at(joiner->segments[at_hand], row);
    int point = 0;
    for (int i = 0; i < joiner->segment_count; i++) {
        const mt_glyf_point *points = joiner->segments[i]->points[i == at_hand ? row : 0];
        for (int k = 0; k < mt_track_segment_points(joiner->segments[i]); k++)
            at[point++] = i == at_hand ? (mt_font_point){points[k].x, points[k].y} : elsewhere;
    }
}

static mt_status join_contours(mt_track_joiner *joiner) {
    int place = 0;
    mt_status status = list_contours(joiner);
    if (status == MT_OK) status = start_points(joiner);
    if (status != MT_OK) return status;
    for (int i = 0; i < joiner->segment_count; i++)
        for (int row = 0; row < joiner->segments[i]->place_count; row++)
            place_contours(joiner, i, row, joiner->at[place++]);
    for (int k = 0; k < joiner->own_points; k++) {
        joiner->glyf.points[k].x = joiner->at[joiner->home][k].x;
        joiner->glyf.points[k].y = joiner->at[joiner->home][k].y;
    }
    return MT_OK;
}

/* ---- references ---------------------------------------------------------------------------------------- */

static mt_status join_references(mt_track_joiner *joiner) {
    const mt_making *making = joiner->making;
    int count = joiner->own_points = joiner->glyf.reference_count = joiner->composite->count;
    mt_glyf_reference *references =
        mt_arena_new(&joiner->making->arena, (size_t)count, sizeof(mt_glyf_reference));
    mt_status status = references ? start_points(joiner) : MT_NO_MEMORY;
    if (status != MT_OK) return status;
    for (int i = 0; i < count; i++) {
        const mt_row_reference *r = &joiner->composite->references[i];
        for (int place = 0; place < joiner->place_count; place++) {
            mt_font_point *at = &joiner->at[place][i];
            mt_between between = mt_outlines_between(joiner->outlines, joiner->places[place]);
            if (!mt_reference_at(making->row, r, between.first, mt_at_both(between.t), making->units, &at->x,
                                 &at->y))
                return MT_TOO_LARGE;
        }
        mt_font_point own = joiner->at[joiner->home][i];
        references[i] = (mt_glyf_reference){r->glyph, own.x, own.y, false};
    }
    joiner->glyf.references = references;
    return MT_OK;
}

/* ---- room in the line ---------------------------------------------------------------------------------- */

/* The phantom points at a place; the glyph's own metrics where the font stands. */
static mt_status place_phantoms(mt_track_joiner *joiner, int place, mt_font_point *phantoms) {
    const mt_making *making = joiner->making;
    bool alone = making->set.fonts.of[1][joiner->glyph] == MT_NO_PARTNER;
    int at_place = alone ? joiner->outlines->stops.at[0] : joiner->places[place];
    mt_between between = mt_outlines_between(joiner->outlines, at_place);
    const mt_glyph_track *track = track_of(joiner, between.first);
    mt_glyf at = {0}, *own = &joiner->glyf;
    mt_status status = mt_glyf_take_room(
        mt_room_between(&track->room_a, &track->room_b, mt_at_both(between.t)), making->units, &at);
    if (status != MT_OK) return status;
    if (at.advance > INT16_MAX || at.origin - at.height < INT16_MIN) return MT_TOO_LARGE;
    phantoms[1].x = (int16_t)at.advance;
    phantoms[2].y = at.origin;
    phantoms[3].y = (int16_t)(at.origin - at.height);
    if (place != joiner->home) return MT_OK;
    own->advance = at.advance;
    own->height = at.height;
    own->origin = at.origin;
    return MT_OK;
}

/* ---- all of it ----------------------------------------------------------------------------------------- */

static bool is_near(int from, int to) {
    return to - from >= INT16_MIN && to - from <= INT16_MAX;
}

/* Whether 'gvar' can say by how far each point is at every place from where the font has it. */
static bool moves_fit(const mt_track_joiner *joiner) {
    for (int i = 0; i < joiner->place_count; i++)
        for (int k = 0; k < joiner->own_points + MT_PHANTOM_POINTS; k++) {
            mt_font_point own = joiner->at[joiner->home][k], at = joiner->at[i][k];
            if (!is_near(own.x, at.x) || !is_near(own.y, at.y)) return false;
        }
    return true;
}

/* All places but the one that the font has by itself. */
static mt_glyph_path leave_home_out(mt_track_joiner *joiner) {
    for (int i = joiner->home; i > 0; i--) {
        joiner->places[i] = joiner->places[i - 1];
        joiner->at[i] = joiner->at[i - 1];
    }
    return (mt_glyph_path){joiner->place_count - 1, joiner->places + 1, joiner->at + 1};
}

mt_status mt_tracks_join(mt_making *making, const mt_outlines *outlines, int glyph, mt_glyf *glyf,
                         mt_glyph_path *path) {
    mt_track_joiner joiner = {
        .making = making, .outlines = outlines, .glyph = glyph, .composite = &making->composites[glyph]};
    mt_status status = list_segments(&joiner);
    if (status == MT_OK) status = list_places(&joiner);
    if (status == MT_OK)
        status = joiner.composite->count > 0 ? join_references(&joiner) : join_contours(&joiner);
    for (int i = 0; i < joiner.place_count && status == MT_OK; i++)
        status = place_phantoms(&joiner, i, joiner.at[i] + joiner.own_points);
    if (status != MT_OK) return status;
    if (!moves_fit(&joiner)) return MT_TOO_LARGE;
    *glyf = joiner.glyf;
    *path = leave_home_out(&joiner);
    return MT_OK;
}
