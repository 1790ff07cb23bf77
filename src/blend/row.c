/* Rows of fonts and their settings, as blends and variable fonts have them. */
#include "blend/row.h"

#include "base/memory.h"
#include "blend/metadata.h"
#include "blend/named_hints.h"
#include "blend/private_names.h"
#include "blend/review.h"
#include "morph/model/params.h"
#include "sfnt/axis_names.h"

#include <string.h>

/* ---- rows ---------------------------------------------------------------------------------------------- */

mt_status mt_row_open(mt_font *const *fonts, int count, const mt_params *params, mt_row *row) {
    mt_status status = mt_params_check(params);
    if (status != MT_OK) return status;
    mt_row made = {.font_count = count,
                   .fonts = mt_new((size_t)count, sizeof *made.fonts),
                   .hints = mt_new((size_t)count, sizeof *made.hints),
                   .leans = mt_new((size_t)count, sizeof *made.leans),
                   .params = *params};
    if (!made.fonts || !made.hints || !made.leans) {
        mt_free(made.leans);
        mt_free(made.fonts);
        mt_free(made.hints);
        return MT_NO_MEMORY;
    }
    for (int i = 0; i < count; i++) made.fonts[i] = fonts[i];
    pthread_mutex_init(&made.lock, NULL);
    *row = made;
    return MT_OK;
}

static void free_hints(mt_hint_index **hints, int font_count) {
    for (int i = 0; i + 1 < font_count; i++) mt_hint_index_free(hints[i]);
    mt_free(hints);
}

static void free_styles(char **styles, int count) {
    for (int i = 0; i < count; i++) mt_free(styles[i]);
    mt_free(styles);
}

void mt_row_close(mt_row *row) {
    if (!row->fonts) return;
    free_hints(row->hints, row->font_count);
    mt_free(row->fonts);
    mt_free(row->leans);
    mt_free(row->family);
    free_styles(row->styles, row->style_count);
    mt_free(row->wanted);
    mt_free(row->wanted_glyphs);
    mt_given_pairs_free(&row->pairs);
    mt_given_places_free(&row->places);
    mt_free(row->heights);
    pthread_mutex_destroy(&row->lock);
}

mt_status mt_row_set_hints(mt_row *row, const mt_hint_table *table, mt_hint_error *error) {
    mt_arena arena = {0};
    mt_hint_glyphs *named[MT_VARIABLE_FONTS_MAX] = {0};
    mt_hint_index **hints = mt_new((size_t)row->font_count, sizeof *hints);
    mt_status status = hints ? MT_OK : MT_NO_MEMORY;
    if (table && status == MT_OK)
        status = mt_named_hints_find(row->fonts, row->font_count, &row->pairs, table, &arena, named, error);
    for (int i = 0; table && i + 1 < row->font_count && status == MT_OK; i++)
        status = mt_hint_index_new(table, named[i], row->fonts, i, &row->pairs, &hints[i], error);
    mt_arena_release(&arena);
    mt_hint_index **unused = status == MT_OK ? row->hints : hints;
    if (status == MT_OK) row->hints = hints;
    if (unused) free_hints(unused, row->font_count);
    return status;
}

/* Puts a copy of the list in place of another one. */
static mt_status replace_list(uint32_t **list, int *list_count, const uint32_t *values, int count) {
    uint32_t *copy = count > 0 ? mt_new((size_t)count, sizeof *copy) : NULL;
    if (count > 0 && !copy) return MT_NO_MEMORY;
    for (int i = 0; i < count; i++) copy[i] = values[i];
    mt_free(*list);
    *list = copy;
    *list_count = count > 0 ? count : 0;
    return MT_OK;
}

mt_status mt_row_set_chars(mt_row *row, const uint32_t *code_points, int count) {
    return replace_list(&row->wanted, &row->wanted_count, code_points, count);
}

mt_status mt_row_set_glyph_numbers(mt_row *row, const uint32_t *glyphs, int count) {
    for (int i = 0; i < count; i++)
        if (glyphs[i] >= (uint32_t)mt_font_glyph_count(row->fonts[0])) return MT_BAD_PARAMETER;
    return replace_list(&row->wanted_glyphs, &row->wanted_glyph_count, glyphs, count);
}

mt_status mt_row_set_pairs(mt_row *row, const uint32_t *glyphs, int count) {
    mt_given_pairs pairs;
    mt_status status = mt_given_pairs_make(glyphs, count, row->fonts, row->font_count, &pairs);
    if (status != MT_OK) return status;
    mt_given_pairs_free(&row->pairs);
    row->pairs = pairs;
    return MT_OK;
}

mt_charset_request mt_row_request(const mt_row *row) {
    return (mt_charset_request){.wanted = row->wanted,
                                .count = row->wanted_count,
                                .set = row->set,
                                .alternates = row->alternates,
                                .glyphs = row->wanted_glyphs,
                                .glyph_count = row->wanted_glyph_count,
                                .pairs = &row->pairs};
}

static mt_status set_family(mt_row *row, const char *name) {
    char *copy = name ? mt_copy_text(name) : NULL;
    if (name && !copy) return MT_NO_MEMORY;
    mt_free(row->family);
    row->family = copy;
    return MT_OK;
}

static mt_status set_styles(mt_row *row, const char *const *names, int count) {
    char **copies = mt_new((size_t)count + 1, sizeof *copies);
    mt_status status = copies ? MT_OK : MT_NO_MEMORY;
    for (int i = 0; i < count && status == MT_OK; i++) {
        copies[i] = mt_copy_text(names[i]);
        if (!copies[i]) status = MT_NO_MEMORY;
    }
    if (status != MT_OK) {
        if (copies) free_styles(copies, count);
        return status;
    }
    free_styles(row->styles, row->style_count);
    row->styles = copies;
    row->style_count = count;
    return MT_OK;
}

int mt_row_units(const mt_row *row) {
    int units = 0;
    for (int i = 0; i + 1 < row->font_count; i++) {
        int needed = mt_metadata_units(row->fonts[i], row->fonts[i + 1]);
        if (needed > units) units = needed;
    }
    return units;
}

mt_at mt_row_place(const mt_row *row, double t, int i) {
    return (mt_at){t, row->height_count ? row->heights[i] : t};
}

bool mt_row_takes_heights(const mt_row *row, int count) {
    if (row->height_count == 0) return true;
    return row->height_count == count && row->params.rotation == MT_ROTATION_NONE;
}

mt_status mt_row_verdict(const mt_row *row, mt_status status) {
    return atomic_load(&row->stop.set) ? MT_STOPPED : status;
}

void mt_row_pass_progress(int done, int all, void *user) {
    const mt_row_progress *part = user;
    mt_row *row = part->row;
    (void)all;
    if (!row->progress) return;
    pthread_mutex_lock(&row->lock);
    row->progress(part->before + done, part->all, row->progress_user);
    pthread_mutex_unlock(&row->lock);
}

void mt_row_report(mt_row *row, const mt_glyph_note *note) {
    if (mt_row_verdict(row, MT_OK) != MT_OK) return;
    pthread_mutex_lock(&row->lock);
    if (row->failed) row->failed(note->code_point, note->why, row->failed_user);
    if (row->failure) row->failure(note, row->failure_user);
    pthread_mutex_unlock(&row->lock);
}

void mt_row_report_cut_short(mt_row *row, const mt_glyph_note *note) {
    if (mt_row_verdict(row, MT_OK) != MT_OK) return;
    pthread_mutex_lock(&row->lock);
    if (row->cut_short) row->cut_short(note, row->cut_short_user);
    pthread_mutex_unlock(&row->lock);
}

void mt_row_report_held(mt_row *row, const mt_glyph_note *note) {
    pthread_mutex_lock(&row->lock);
    if (row->held) row->held(note, row->held_user);
    pthread_mutex_unlock(&row->lock);
}

static void on_failure(mt_row *row, mt_glyph_noted call, void *user) {
    row->failure = call;
    row->failure_user = user;
}

static void on_unblended(mt_row *row, mt_glyph_noted call, void *user) {
    row->kept = call;
    row->kept_user = user;
}

static void on_cut_short(mt_row *row, mt_glyph_noted call, void *user) {
    row->cut_short = call;
    row->cut_short_user = user;
}

static mt_status review(const mt_row *row, mt_warning call, void *user) {
    mt_status status = mt_review(row->fonts, row->font_count, row->family, call, user);
    mt_charset_request request = mt_row_request(row);
    if (status != MT_OK) return status;
    return mt_private_names_review(row->fonts, row->font_count, &request, call, user);
}

static void on_left_out(mt_row *row, mt_left_out_noted call, void *user) {
    row->left_out = call;
    row->left_out_user = user;
}

/* ---- blends -------------------------------------------------------------------------------------------- */

mt_status mt_blend_new(mt_font *a, mt_font *b, const mt_params *params, mt_blend **blend) {
    mt_blend *made = mt_new(1, sizeof *made);
    if (!made) return MT_NO_MEMORY;
    mt_status status = mt_row_open((mt_font *[]){a, b}, 2, params, &made->row);
    if (status == MT_OK)
        *blend = made;
    else
        mt_free(made);
    return status;
}

void mt_blend_free(mt_blend *blend) {
    if (!blend) return;
    mt_row_close(&blend->row);
    mt_free(blend);
}

void mt_blend_on_failure(mt_blend *blend, mt_glyph_failed call, void *user) {
    blend->row.failed = call;
    blend->row.failed_user = user;
}

void mt_blend_on_glyph_failure(mt_blend *blend, mt_glyph_noted call, void *user) {
    on_failure(&blend->row, call, user);
}

void mt_blend_on_unblended(mt_blend *blend, mt_glyph_noted call, void *user) {
    on_unblended(&blend->row, call, user);
}

void mt_blend_on_cut_short(mt_blend *blend, mt_glyph_noted call, void *user) {
    on_cut_short(&blend->row, call, user);
}

void mt_blend_on_held(mt_blend *blend, mt_glyph_noted call, void *user) {
    blend->row.held = call;
    blend->row.held_user = user;
}

void mt_blend_on_left_out(mt_blend *blend, mt_left_out_noted call, void *user) {
    on_left_out(&blend->row, call, user);
}

void mt_blend_on_progress(mt_blend *blend, mt_progress call, void *user) {
    blend->row.progress = call;
    blend->row.progress_user = user;
}

void mt_blend_stop(mt_blend *blend, bool stop) {
    atomic_store(&blend->row.stop.set, stop);
}

mt_status mt_blend_set_family(mt_blend *blend, const char *name) {
    return set_family(&blend->row, name);
}

mt_status mt_blend_set_styles(mt_blend *blend, const char *const *names, int count) {
    return set_styles(&blend->row, names, count);
}

mt_status mt_blend_set_heights(mt_blend *blend, const double *t, int count) {
    double *copy = count > 0 ? mt_new((size_t)count, sizeof *copy) : NULL;
    if (count > 0 && !copy) return MT_NO_MEMORY;
    for (int i = 0; i < count; i++) copy[i] = t[i];
    mt_free(blend->row.heights);
    blend->row.heights = copy;
    blend->row.height_count = count > 0 ? count : 0;
    return MT_OK;
}

mt_status mt_blend_set_places(mt_blend *blend, const uint32_t *glyphs, const double *t, const double *heights,
                              int count) {
    mt_given_places places;
    mt_status status = mt_given_places_make(glyphs, t, heights, count, blend->row.fonts[0], &places);
    if (status != MT_OK) return status;
    mt_given_places_free(&blend->row.places);
    blend->row.places = places;
    return MT_OK;
}

mt_status mt_blend_warnings(const mt_blend *blend, mt_warning call, void *user) {
    return review(&blend->row, call, user);
}

mt_status mt_blend_set_chars(mt_blend *blend, const uint32_t *code_points, int count) {
    return mt_row_set_chars(&blend->row, code_points, count);
}

mt_status mt_blend_set_pairs(mt_blend *blend, const uint32_t *glyphs, int count) {
    return mt_row_set_pairs(&blend->row, glyphs, count);
}

void mt_blend_set_alternates(mt_blend *blend, bool alternates) {
    blend->row.alternates = alternates;
}

mt_status mt_blend_set_glyph_numbers(mt_blend *blend, const uint32_t *glyphs, int count) {
    return mt_row_set_glyph_numbers(&blend->row, glyphs, count);
}

void mt_blend_set_glyphs(mt_blend *blend, mt_glyph_set set) {
    blend->row.set = set;
}

void mt_blend_set_cache(mt_blend *blend, mt_cache *cache) {
    blend->row.cache = cache;
}

void mt_blend_set_curves(mt_blend *blend, mt_curves curves) {
    blend->row.curves = curves;
}

int mt_blend_unblended(const mt_blend *blend) {
    return blend->row.unblended;
}

mt_status mt_blend_set_hints(mt_blend *blend, const mt_hint_table *table, mt_hint_error *error) {
    return mt_row_set_hints(&blend->row, table, error);
}

int mt_blend_units_per_em(const mt_blend *blend) {
    return mt_row_units(&blend->row);
}

/* ---- variable fonts ------------------------------------------------------------------------------------ */

mt_status mt_variable_new(mt_font *const *fonts, int count, const mt_params *params, mt_variable **variable) {
    if (count < 2 || count > MT_VARIABLE_FONTS_MAX) return MT_BAD_PARAMETER;
    mt_variable *made = mt_new(1, sizeof *made);
    if (!made) return MT_NO_MEMORY;
    made->axis = MT_AXIS_DEFAULT;
    mt_status status = mt_row_open(fonts, count, params, &made->row);
    if (status == MT_OK)
        *variable = made;
    else
        mt_free(made);
    return status;
}

void mt_variable_free(mt_variable *variable) {
    if (!variable) return;
    mt_row_close(&variable->row);
    mt_axis_map_free(&variable->map);
    mt_free(variable->values);
    mt_free(variable);
}

void mt_variable_on_failure(mt_variable *variable, mt_glyph_failed call, void *user) {
    variable->row.failed = call;
    variable->row.failed_user = user;
}

void mt_variable_on_glyph_failure(mt_variable *variable, mt_glyph_noted call, void *user) {
    on_failure(&variable->row, call, user);
}

void mt_variable_on_unblended(mt_variable *variable, mt_glyph_noted call, void *user) {
    on_unblended(&variable->row, call, user);
}

void mt_variable_on_cut_short(mt_variable *variable, mt_glyph_noted call, void *user) {
    on_cut_short(&variable->row, call, user);
}

void mt_variable_on_left_out(mt_variable *variable, mt_left_out_noted call, void *user) {
    on_left_out(&variable->row, call, user);
}

void mt_variable_on_progress(mt_variable *variable, mt_progress call, void *user) {
    variable->row.progress = call;
    variable->row.progress_user = user;
}

void mt_variable_stop(mt_variable *variable, bool stop) {
    atomic_store(&variable->row.stop.set, stop);
}

mt_status mt_variable_set_family(mt_variable *variable, const char *name) {
    return set_family(&variable->row, name);
}

mt_status mt_variable_set_style(mt_variable *variable, const char *name) {
    return set_styles(&variable->row, &name, name ? 1 : 0);
}

mt_status mt_variable_set_axis(mt_variable *variable, const char *tag, double from, double to) {
    mt_axis axis = {.from = from, .to = to, .home = from};
    if (!mt_axis_tag_read(tag, &axis.tag) || !mt_axis_is_valid(&axis)) return MT_BAD_PARAMETER;
    variable->axis = axis;
    mt_free(variable->values);
    variable->values = NULL;
    return MT_OK;
}

mt_status mt_variable_warnings(const mt_variable *variable, mt_warning call, void *user) {
    return review(&variable->row, call, user);
}

mt_status mt_variable_set_chars(mt_variable *variable, const uint32_t *code_points, int count) {
    return mt_row_set_chars(&variable->row, code_points, count);
}

mt_status mt_variable_set_pairs(mt_variable *variable, const uint32_t *glyphs, int count) {
    return mt_row_set_pairs(&variable->row, glyphs, count);
}

void mt_variable_set_alternates(mt_variable *variable, bool alternates) {
    variable->row.alternates = alternates;
}

mt_status mt_variable_set_glyph_numbers(mt_variable *variable, const uint32_t *glyphs, int count) {
    return mt_row_set_glyph_numbers(&variable->row, glyphs, count);
}

void mt_variable_set_glyphs(mt_variable *variable, mt_glyph_set set) {
    variable->row.set = set;
}

void mt_variable_set_cache(mt_variable *variable, mt_cache *cache) {
    variable->row.cache = cache;
}

void mt_variable_set_curves(mt_variable *variable, mt_curves curves) {
    variable->row.curves = curves;
}

int mt_variable_unblended(const mt_variable *variable) {
    return variable->row.unblended;
}

mt_status mt_variable_set_map(mt_variable *variable, const double *values, const double *places, int count) {
    mt_axis_map map = {0};
    if (count > 0 && variable->values) return MT_BAD_PARAMETER;
    mt_status status = count == 0 ? MT_OK : mt_axis_map_make(values, places, count, &map);
    if (status != MT_OK) return status;
    mt_axis_map_free(&variable->map);
    variable->map = map;
    return MT_OK;
}

mt_status mt_variable_set_hints(mt_variable *variable, const mt_hint_table *table, mt_hint_error *error) {
    return mt_row_set_hints(&variable->row, table, error);
}
