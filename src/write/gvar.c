/* How the outlines vary: 'gvar' (OpenType spec, "gvar - Glyph Variations Table").
 *
 * A glyph has a tuple for each place at which it is told where its points are. The tuple counts fully there, not at all at the
 * place before and at the one after, and in between by how near it is: so that between two places each point moves on a
 * straight line. A place that several glyphs have is a shared tuple; it is stored once. Places on
 * either side of 0, where the font stands without a setting, are told apart by it: no tuple counts on both. */
#include <string.h>

#include "sfnt/axis.h"
#include "write/gvar_pack.h"
#include "write/iup.h"
#include "write/tables.h"

enum {
    EMBEDDED_PEAK = 0x8000,
    INTERMEDIATE_REGION = 0x4000,
    PRIVATE_POINTS = 0x2000,
    SHARED_POINTS = 0x8000, /* of the glyph's count of tuples */
    SHARED_TUPLES_MAX = 0x1000,
    TUPLES_MAX = 0xFFF,
};

/* By how much of a font unit an inferred move may be beside the point's own. Contours that meet must not part by it: a hundredth of a
 * pixel at 100 pixels an em. */
#define INFERRED_WITHIN 0.1

typedef struct mt_gvar_writer {
    const mt_font_data *data;
    int shared_count;
    int shared[SHARED_TUPLES_MAX]; /* places, ascending */
    int index_of[2 * MT_PLACE_ONE +
                 1]; /* of each place, from -MT_PLACE_ONE on, among the shared ones; -1 where it is none */
    uint32_t *offsets;
    mt_table glyphs;
    mt_arena scratch;
} mt_gvar_writer;

/* ---- one tuple ----------------------------------------------------------------------------------------- */

/* A glyph's tuple in the making: its points are of `points`, its deltas of `deltas`. */
typedef struct mt_tuple {
    int before, place, after; /* `place` itself at an end of the axis */
    bool *told;
    mt_table points, deltas;
} mt_tuple;

static int point_count(const mt_glyf *glyph) {
    int own = glyph->reference_count ? glyph->reference_count : mt_glyf_point_count(glyph);
    return own + MT_PHANTOM_POINTS;
}

/* References and phantom points are told where they move: nothing is inferred for them. */
static mt_status choose_points(mt_gvar_writer *writer, const mt_glyf *glyph, const mt_move *moves,
                               bool *told) {
    int contour_points = mt_glyf_point_count(glyph), count = point_count(glyph);
    for (int i = contour_points; i < count; i++) told[i] = moves[i].x != 0 || moves[i].y != 0;
    return mt_iup_choose(glyph, moves, INFERRED_WITHIN, &writer->scratch, told);
}

static mt_status pack_tuple(mt_gvar_writer *writer, const mt_move *moves, int count, mt_tuple *tuple) {
    int16_t *deltas = mt_arena_new(&writer->scratch, 2 * (size_t)count, sizeof *deltas);
    if (!deltas) return MT_NO_MEMORY;
    int told = 0;
    for (int i = 0; i < count; i++)
        if (tuple->told[i]) deltas[told++] = moves[i].x;
    int of_x = told;
    for (int i = 0; i < count; i++)
        if (tuple->told[i]) deltas[told++] = moves[i].y;
    mt_pack_points(tuple->told, count, &tuple->points);
    mt_pack_deltas(deltas, of_x, &tuple->deltas);
    mt_pack_deltas(deltas + of_x, of_x, &tuple->deltas);
    return tuple->points.failed || tuple->deltas.failed ? MT_NO_MEMORY : MT_OK;
}

static size_t length_of(const mt_tuple *tuple) {
    return tuple->points.length + tuple->deltas.length;
}

static void free_tuple(mt_tuple *tuple) {
    mt_table_free(&tuple->points);
    mt_table_free(&tuple->deltas);
}

/* The tuple with the points that have to be told or, where that is shorter, with all. */
static mt_status make_tuple(mt_gvar_writer *writer, const mt_glyf *glyph, const mt_move *moves,
                            mt_tuple *tuple) {
    int count = point_count(glyph);
    mt_tuple all = {.told = mt_arena_new(&writer->scratch, (size_t)count, sizeof(bool))};
    tuple->told = mt_arena_new(&writer->scratch, (size_t)count, sizeof(bool));
    if (!all.told || !tuple->told) return MT_NO_MEMORY;
    memset(all.told, true, (size_t)count * sizeof(bool));
    mt_status status = choose_points(writer, glyph, moves, tuple->told);
    if (status == MT_OK) status = pack_tuple(writer, moves, count, tuple);
    if (status == MT_OK) status = pack_tuple(writer, moves, count, &all);
    if (status == MT_OK && length_of(&all) < length_of(tuple)) {
        mt_tuple shorter = {tuple->before, tuple->place, tuple->after, all.told, all.points, all.deltas};
        all = *tuple;
        *tuple = shorter;
    }
    free_tuple(&all);
    return status;
}

/* A point's own place: where the font has it (mt_glyph_path). */
static void own_point(const mt_glyf *glyph, int i, int *x, int *y) {
    int contour_points = mt_glyf_point_count(glyph), phantom = i - point_count(glyph) + MT_PHANTOM_POINTS;
    *x = *y = 0;
    if (phantom == 1) *x = glyph->advance;
    if (phantom == 2) *y = glyph->origin;
    if (phantom == 3) *y = glyph->origin - glyph->height;
    if (phantom >= 0) return;
    *x = i < contour_points ? glyph->points[i].x : glyph->references[i].dx;
    *y = i < contour_points ? glyph->points[i].y : glyph->references[i].dy;
}

/* By how far the points are from their own places. */
static mt_status subtract_own(mt_gvar_writer *writer, const mt_glyf *glyph, const mt_font_point *at,
                              mt_move **moves) {
    int count = point_count(glyph);
    *moves = mt_arena_new(&writer->scratch, (size_t)count, sizeof **moves);
    if (!*moves) return MT_NO_MEMORY;
    for (int i = 0; i < count; i++) {
        int x, y;
        own_point(glyph, i, &x, &y);
        (*moves)[i] = (mt_move){(int16_t)(at[i].x - x), (int16_t)(at[i].y - y)};
        if ((*moves)[i].x != at[i].x - x || (*moves)[i].y != at[i].y - y) return MT_TOO_LARGE;
    }
    return MT_OK;
}

static bool moves_at_all(const mt_move *moves, int count) {
    for (int i = 0; i < count; i++)
        if (moves[i].x != 0 || moves[i].y != 0) return true;
    return false;
}

/* The place beside that number `i`, at its list's end its own; 0 where that lies between. */
static int neighbour(const mt_glyph_path *path, int i, int step) {
    int other = i + step, place = path->places[i];
    bool listed = other >= 0 && other < path->place_count;
    bool inward = (place > 0) == (step < 0);
    if (inward && (!listed || (path->places[other] > 0) != (place > 0))) return 0;
    return listed ? path->places[other] : place;
}

/* ---- one glyph ----------------------------------------------------------------------------------------- */

typedef struct mt_tuples {
    int count;
    mt_tuple *list;
} mt_tuples;

static mt_status make_tuples(mt_gvar_writer *writer, const mt_glyf *glyph, const mt_glyph_path *path,
                             mt_tuples *tuples) {
    if (path->place_count > TUPLES_MAX) return MT_TOO_LARGE;
    tuples->list = mt_arena_new(&writer->scratch, (size_t)path->place_count, sizeof *tuples->list);
    if (!tuples->list) return MT_NO_MEMORY;
    for (int i = 0; i < path->place_count; i++) {
        mt_move *moves;
        mt_status status = subtract_own(writer, glyph, path->at[i], &moves);
        if (status != MT_OK) return status;
        if (!moves_at_all(moves, point_count(glyph))) continue;
        mt_tuple *tuple = &tuples->list[tuples->count++];
        tuple->place = path->places[i];
        tuple->before = neighbour(path, i, -1);
        tuple->after = neighbour(path, i, 1);
        status = make_tuple(writer, glyph, moves, tuple);
        if (status != MT_OK) return status;
    }
    return MT_OK;
}

static bool equal_points(const mt_tuple *a, const mt_tuple *b) {
    return a->points.length == b->points.length &&
           memcmp(a->points.bytes, b->points.bytes, a->points.length) == 0;
}

/* The tuple whose points are worth most as the shared ones; NULL where sharing saves nothing. */
static const mt_tuple *find_shared(const mt_tuples *tuples) {
    const mt_tuple *best = NULL;
    size_t most = 0;
    for (int i = 0; i < tuples->count; i++) {
        size_t users = 0;
        for (int k = 0; k < tuples->count; k++) users += equal_points(&tuples->list[i], &tuples->list[k]);
        size_t saved = (users - 1) * tuples->list[i].points.length;
        if (saved > most) most = saved, best = &tuples->list[i];
    }
    return best;
}

/* A region that begins at 0 and ends where it is full is what a reader takes without being told. */
static bool is_intermediate(const mt_tuple *tuple) {
    int inner = tuple->place > 0 ? tuple->before : tuple->after, outer = tuple->before + tuple->after - inner;
    return inner != 0 || outer != tuple->place;
}

static void write_header(const mt_gvar_writer *writer, const mt_tuple *tuple, bool shared, mt_table *table) {
    int index = writer->index_of[tuple->place + MT_PLACE_ONE];
    size_t length = tuple->deltas.length + (shared ? 0 : tuple->points.length);
    mt_table_16(table, (int)length);
    mt_table_16(table, (index < 0 ? EMBEDDED_PEAK : index) | (shared ? 0 : PRIVATE_POINTS) |
                           (is_intermediate(tuple) ? INTERMEDIATE_REGION : 0));
    bool down = mt_axis_goes_down(&writer->data->variation->axis);
    if (index < 0) mt_table_16(table, down ? -tuple->place : tuple->place);
    if (!is_intermediate(tuple)) return;
    mt_table_16(table, down ? -tuple->after : tuple->before);
    mt_table_16(table, down ? -tuple->before : tuple->after);
}

/* Lengths and offsets within a glyph have 16 bits. */
static mt_status write_tuples(mt_gvar_writer *writer, const mt_tuples *tuples) {
    enum { HEAD = 4 };
    const mt_tuple *shared = find_shared(tuples);
    mt_table headers = {0}, *table = &writer->glyphs;
    bool fits = true;
    for (int i = 0; i < tuples->count; i++) {
        const mt_tuple *tuple = &tuples->list[i];
        fits = fits && length_of(tuple) <= UINT16_MAX;
        write_header(writer, tuple, shared && equal_points(shared, tuple), &headers);
    }
    mt_table_16(table, (shared ? SHARED_POINTS : 0) | tuples->count);
    mt_table_16(table, (int)(HEAD + headers.length));
    mt_table_bytes(table, headers.bytes, headers.length);
    fits = fits && HEAD + headers.length <= UINT16_MAX;
    if (shared) mt_table_bytes(table, shared->points.bytes, shared->points.length);
    for (int i = 0; i < tuples->count; i++) {
        const mt_tuple *tuple = &tuples->list[i];
        bool private = !shared || !equal_points(shared, tuple);
        if (private) mt_table_bytes(table, tuple->points.bytes, tuple->points.length);
        mt_table_bytes(table, tuple->deltas.bytes, tuple->deltas.length);
    }
    bool failed = headers.failed || table->failed;
    mt_table_free(&headers);
    return failed ? MT_NO_MEMORY : fits ? MT_OK : MT_TOO_LARGE;
}

static mt_status write_glyph(mt_gvar_writer *writer, int glyph) {
    mt_tuples tuples = {0};
    mt_status status =
        make_tuples(writer, &writer->data->glyphs[glyph], &writer->data->variation->paths[glyph], &tuples);
    if (status == MT_OK && tuples.count > 0) status = write_tuples(writer, &tuples);
    for (int i = 0; i < tuples.count; i++) free_tuple(&tuples.list[i]);
    mt_table_zeros(&writer->glyphs, (int)(writer->glyphs.length % 2));
    mt_arena_reset(&writer->scratch);
    return status;
}

/* ---- all glyphs ---------------------------------------------------------------------------------------- */

/* The places that more than one glyph has, as long as they can be numbered. */
static void share_places(mt_gvar_writer *writer) {
    int *uses = writer->index_of; /* counted here first */
    for (int i = 0; i < writer->data->glyph_count; i++) {
        const mt_glyph_path *path = &writer->data->variation->paths[i];
        for (int k = 0; k < path->place_count; k++) uses[path->places[k] + MT_PLACE_ONE]++;
    }
    for (int i = 0; i <= 2 * MT_PLACE_ONE; i++) {
        bool shared = uses[i] > 1 && writer->shared_count < SHARED_TUPLES_MAX;
        writer->index_of[i] = shared ? writer->shared_count : -1;
        if (shared) writer->shared[writer->shared_count++] = i - MT_PLACE_ONE;
    }
}

static bool offsets_are_long(const mt_gvar_writer *writer) {
    return writer->glyphs.length > 2 * (size_t)UINT16_MAX;
}

static void write_whole(const mt_gvar_writer *writer, mt_table *table) {
    enum { HEADER = 20, LONG_OFFSETS = 1 };
    int glyphs = writer->data->glyph_count;
    bool is_long = offsets_are_long(writer);
    uint32_t tuples = HEADER + (uint32_t)(glyphs + 1) * (is_long ? 4 : 2);
    mt_table_32(table, 0x00010000);
    mt_table_16(table, 1); /* axisCount */
    mt_table_16(table, writer->shared_count);
    mt_table_32(table, tuples);
    mt_table_16(table, glyphs);
    mt_table_16(table, is_long ? LONG_OFFSETS : 0);
    mt_table_32(table, tuples + 2 * (uint32_t)writer->shared_count);
    for (int i = 0; i <= glyphs; i++) {
        if (is_long)
            mt_table_32(table, writer->offsets[i]);
        else
            mt_table_16(table, (int)(writer->offsets[i] / 2));
    }
    int sign = mt_axis_goes_down(&writer->data->variation->axis) ? -1 : 1;
    for (int i = 0; i < writer->shared_count; i++) mt_table_16(table, sign * writer->shared[i]);
    mt_table_bytes(table, writer->glyphs.bytes, writer->glyphs.length);
}

static mt_status write_all(mt_gvar_writer *writer, mt_table *table) {
    int count = writer->data->glyph_count;
    mt_status status = MT_OK;
    writer->offsets = mt_new((size_t)count + 1, sizeof *writer->offsets);
    if (!writer->offsets) return MT_NO_MEMORY;
    share_places(writer);
    for (int i = 0; i < count && status == MT_OK; i++) {
        status = write_glyph(writer, i);
        if (writer->glyphs.length > INT32_MAX) status = MT_TOO_LARGE;
        writer->offsets[i + 1] = (uint32_t)writer->glyphs.length;
    }
    if (status != MT_OK) return status;
    write_whole(writer, table);
    return table->failed ? MT_NO_MEMORY : MT_OK;
}

mt_status mt_write_gvar(const mt_font_data *data, mt_table *table) {
    if (!data->variation) return MT_OK;
    mt_gvar_writer *writer = mt_new(1, sizeof *writer);
    if (!writer) return MT_NO_MEMORY;
    writer->data = data;
    mt_status status = write_all(writer, table);
    mt_free(writer->offsets);
    mt_table_free(&writer->glyphs);
    mt_arena_release(&writer->scratch);
    mt_free(writer);
    return status;
}
