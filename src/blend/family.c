/* Families: their stops, their names, and what their fonts have in common. */
#include "blend/family.h"

#include <string.h>

#include "base/memory.h"
#include "sfnt/axis_names.h"
#include "write/style.h"

/* ---- places -------------------------------------------------------------------------------------------- */

mt_stops mt_variable_stops(const mt_variable *variable) {
    mt_stops stops;
    int count = variable->row.font_count;
    if (!variable->values) return mt_stops_even(count);
    mt_stops_make(&variable->axis, variable->values, count, &stops);
    return stops;
}

double mt_variable_value(const mt_variable *variable, int font) {
    if (variable->values) return variable->values[font];
    return mt_axis_user(&variable->axis, (double)MT_AXIS_END * font / (variable->row.font_count - 1));
}

/* ---- names --------------------------------------------------------------------------------------------- */

mt_slope mt_variable_slope(const mt_variable *variable) {
    bool italic = variable->values != NULL;
    uint32_t tag = variable->axis.tag;
    if (tag == MT_TAG('s', 'l', 'n', 't') || tag == MT_TAG('i', 't', 'a', 'l')) return MT_SLOPE_UNTOLD;
    for (int i = 0; i < variable->row.font_count && italic; i++)
        italic = mt_font_is_italic(variable->row.fonts[i]);
    if (italic) return MT_SLOPE_ITALIC;
    return variable->has_italic ? MT_SLOPE_UPRIGHT : MT_SLOPE_UNTOLD;
}

/* A font's style, and the same without its slope or, where that is all, the axis' own name for the place. */
static mt_status name_stop(const mt_variable *variable, int font, mt_arena *arena, mt_stop_name *name) {
    const char *style = mt_font_style(variable->row.fonts[font]);
    char *part = mt_arena_new(arena, strlen(style) + 1, 1);
    if (!part) return MT_NO_MEMORY;
    mt_style_drop_slope(style, part);
    const char *plain = *part ? part : mt_axis_place_name(&variable->axis, variable->values[font], arena);
    *name = (mt_stop_name){style, mt_variable_slope(variable) == MT_SLOPE_ITALIC ? plain : style};
    return plain ? MT_OK : MT_NO_MEMORY;
}

/* Whether each font has a name, and none that of another. */
static bool are_different(const mt_stop_name *names, int count) {
    for (int i = 0; i < count; i++) {
        if (!*names[i].whole) return false;
        for (int k = 0; k < i; k++)
            if (strcmp(names[i].whole, names[k].whole) == 0 || strcmp(names[i].part, names[k].part) == 0)
                return false;
    }
    return true;
}

/* By the axis, where the fonts' own names do not tell them apart. */
static mt_status name_by_axis(const mt_variable *variable, mt_arena *arena, mt_stop_name *names) {
    for (int i = 0; i < variable->row.font_count; i++) {
        const char *name = mt_axis_place_name(&variable->axis, variable->values[i], arena);
        if (!name) return MT_NO_MEMORY;
        names[i] = (mt_stop_name){name, name};
    }
    return MT_OK;
}

mt_status mt_variable_name_places(const mt_variable *variable, const double *values, int count,
                                  mt_arena *arena, mt_axis_data *data) {
    int fonts = variable->row.font_count;
    mt_status status = MT_OK;
    if (!variable->values) return mt_axis_name_places(values, count, arena, data);
    mt_stop_name *names = mt_arena_new(arena, (size_t)fonts, sizeof *names);
    if (!names) return MT_NO_MEMORY;
    for (int i = 0; i < fonts && status == MT_OK; i++) status = name_stop(variable, i, arena, &names[i]);
    if (status == MT_OK && !are_different(names, fonts)) status = name_by_axis(variable, arena, names);
    if (status != MT_OK) return status;
    return mt_axis_name_stops(variable->values, names, fonts, arena, data);
}

/* ---- the family ---------------------------------------------------------------------------------------- */

/* How many bytes of both names are the same whole words. */
static size_t common_words(const char *name, const char *other, size_t length) {
    size_t same = 0, words = 0;
    while (same < length && name[same] == other[same] && name[same]) {
        if (name[same] == ' ') words = same;
        same++;
    }
    bool ends = (same == length || name[same] == ' ') && (!other[same] || other[same] == ' ');
    return ends ? same : words;
}

/* The words that the names of all families begin with; the name is made as without a family where there are none. */
static mt_status share_family(mt_variable *variable) {
    const mt_row *row = &variable->row;
    const char *first = mt_font_family(row->fonts[0]);
    size_t length = strlen(first);
    for (int i = 1; i < row->font_count; i++)
        length = common_words(first, mt_font_family(row->fonts[i]), length);
    if (length == 0 || row->family) return MT_OK;
    char *family = mt_new(length + 1, 1);
    if (!family) return MT_NO_MEMORY;
    memcpy(family, first, length);
    mt_status status = mt_variable_set_family(variable, family);
    mt_free(family);
    return status;
}

/* The plain value where a font has it, such as Regular's; otherwise the first one's. */
static double home_of(uint32_t tag, const double *values, int count) {
    for (int i = 0; i < count; i++)
        if (values[i] == mt_axis_plain(tag)) return values[i];
    return values[0];
}

mt_status mt_variable_set_stops(mt_variable *variable, const char *tag, const double *values) {
    int count = variable->row.font_count;
    mt_axis axis = {.from = values[0], .to = values[count - 1]};
    mt_stops stops;
    if (variable->map.count > 0 || !mt_axis_tag_read(tag, &axis.tag) || mt_axis_goes_down(&axis) ||
        !mt_axis_is_valid(&axis))
        return MT_BAD_PARAMETER;
    axis.home = home_of(axis.tag, values, count);
    for (int i = 1; i < count; i++)
        if (!(values[i] > values[i - 1])) return MT_BAD_PARAMETER;
    if (!mt_stops_make(&axis, values, count, &stops)) return MT_BAD_PARAMETER;
    double *copy = mt_new((size_t)count, sizeof *copy);
    mt_status status = copy ? share_family(variable) : MT_NO_MEMORY;
    if (status != MT_OK) {
        mt_free(copy);
        return status;
    }
    memcpy(copy, values, (size_t)count * sizeof *copy);
    mt_free(variable->values);
    variable->values = copy;
    variable->axis = axis;
    return MT_OK;
}

void mt_variable_set_italic(mt_variable *variable, bool has_italic) {
    variable->has_italic = has_italic;
}
