#include "sfnt/axis_names.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define WEIGHT MT_TAG('w', 'g', 'h', 't')
#define WIDTH MT_TAG('w', 'd', 't', 'h')
#define SLANT MT_TAG('s', 'l', 'n', 't')
#define ITALIC MT_TAG('i', 't', 'a', 'l')
#define SIZE MT_TAG('o', 'p', 's', 'z')

/* ---- axes ---------------------------------------------------------------------------------------------- */

/* The registered ones first: with the values that they may have, and the one that is not told in a style's name. */
static const struct mt_known_axis {
    uint32_t tag;
    const char *name;
    double least, most, plain;
} known_axes[] = {
    {WEIGHT, "Weight", 1, 1000, 400},
    {WIDTH, "Width", 1, 1000, 100},
    {SLANT, "Slant", -90, 90, 0},
    {ITALIC, "Italic", 0, 1, 0},
    {SIZE, "Optical Size", 1, 10000, NAN},
    {MT_TAG('M', 'O', 'R', 'F'), "Morph", -32768, 32767, NAN},
    {MT_TAG('C', 'A', 'S', 'L'), "Casual", -32768, 32767, NAN},
    {MT_TAG('G', 'R', 'A', 'D'), "Grade", -32768, 32767, NAN},
    {MT_TAG('M', 'O', 'N', 'O'), "Monospace", -32768, 32767, NAN},
    {MT_TAG('R', 'O', 'N', 'D'), "Roundness", -32768, 32767, NAN},
    {MT_TAG('S', 'O', 'F', 'T'), "Softness", -32768, 32767, NAN},
};

static const struct mt_known_axis *find_axis(uint32_t tag) {
    for (size_t i = 0; i < sizeof known_axes / sizeof *known_axes; i++)
        if (known_axes[i].tag == tag) return &known_axes[i];
    return NULL;
}

double mt_axis_plain(uint32_t tag) {
    const struct mt_known_axis *known = find_axis(tag);
    return known ? known->plain : NAN;
}

static bool is_own_tag(uint32_t tag) {
    for (int shift = 24; shift >= 0; shift -= 8) {
        uint32_t c = tag >> shift & 0xFF;
        bool capital = c >= 'A' && c <= 'Z', digit = c >= '0' && c <= '9';
        if (!capital && (!digit || shift == 24)) return false;
    }
    return true;
}

bool mt_axis_tag_read(const char *text, uint32_t *tag) {
    const uint8_t *c = (const uint8_t *)text;
    if (strlen(text) != 4) return false;
    *tag = MT_TAG(c[0], c[1], c[2], c[3]);
    return true;
}

bool mt_axis_is_valid(const mt_axis *axis) {
    const struct mt_known_axis *known = find_axis(axis->tag);
    double least = known ? known->least : -32768, most = known ? known->most : 32767;
    double low = fmin(axis->from, axis->to), high = fmax(axis->from, axis->to);
    return (known || is_own_tag(axis->tag)) && low >= least && high <= most && high - low >= 0.01;
}

/* ---- values -------------------------------------------------------------------------------------------- */

static const struct mt_value_name {
    uint32_t tag;
    double value;
    const char *name;
} value_names[] = {
    {WEIGHT, 100, "Thin"},          {WEIGHT, 200, "ExtraLight"},    {WEIGHT, 300, "Light"},
    {WEIGHT, 400, "Regular"},       {WEIGHT, 500, "Medium"},        {WEIGHT, 600, "SemiBold"},
    {WEIGHT, 700, "Bold"},          {WEIGHT, 800, "ExtraBold"},     {WEIGHT, 900, "Black"},
    {WEIGHT, 1000, "ExtraBlack"},   {WIDTH, 50, "UltraCondensed"},  {WIDTH, 62.5, "ExtraCondensed"},
    {WIDTH, 75, "Condensed"},       {WIDTH, 87.5, "SemiCondensed"}, {WIDTH, 100, "Regular"},
    {WIDTH, 112.5, "SemiExpanded"}, {WIDTH, 125, "Expanded"},       {WIDTH, 150, "ExtraExpanded"},
    {WIDTH, 200, "UltraExpanded"},  {SLANT, 0, "Regular"},          {ITALIC, 0, "Regular"},
    {ITALIC, 1, "Italic"},
};
enum { VALUE_NAMES = sizeof value_names / sizeof *value_names };

/* Within what 16.16 tells apart, as often as fonts in between are not quite where they would be. */
static bool is_at(double value, double other) {
    return fabs(value - other) < 0.005;
}

static const char *find_name(const mt_axis *axis, double value) {
    for (int i = 0; i < VALUE_NAMES; i++)
        if (value_names[i].tag == axis->tag && is_at(value_names[i].value, value)) return value_names[i].name;
    return NULL;
}

/* The end of a slant that leans more. */
static bool is_slanted_end(const mt_axis *axis, double value) {
    return axis->tag == SLANT && is_at(value, fabs(axis->from) > fabs(axis->to) ? axis->from : axis->to);
}

const char *mt_axis_place_name(const mt_axis *axis, double value, mt_arena *arena) {
    enum { NAME_ROOM = 48 };
    const char *found = find_name(axis, value);
    const struct mt_known_axis *known = find_axis(axis->tag);
    char *name = mt_arena_new(arena, NAME_ROOM, 1), tag[5];
    if (!name) return NULL;
    for (int i = 0; i < 4; i++) tag[i] = (char)(axis->tag >> (24 - 8 * i) & 0xFF);
    tag[4] = '\0';
    if (!found && is_slanted_end(axis, value)) found = "Oblique";
    if (found)
        snprintf(name, NAME_ROOM, "%s", found);
    else if (axis->tag == SIZE)
        snprintf(name, NAME_ROOM, "%.4gpt", value);
    else
        snprintf(name, NAME_ROOM, "%s %.4g", known ? known->name : tag, value);
    return name;
}

/* ---- places -------------------------------------------------------------------------------------------- */

typedef struct mt_axis_places {
    const mt_axis *axis;
    mt_arena *arena;
    mt_named_place *list;
    int count;
} mt_axis_places;

/* Adds a place on the axis, unless one has its name. */
static mt_status add_place(mt_axis_places *places, double value) {
    const mt_axis *axis = places->axis;
    const struct mt_known_axis *known = find_axis(axis->tag);
    if (value < fmin(axis->from, axis->to) || value > fmax(axis->from, axis->to)) return MT_OK;
    const char *name = mt_axis_place_name(axis, value, places->arena);
    if (!name) return MT_NO_MEMORY;
    for (int i = 0; i < places->count; i++)
        if (strcmp(places->list[i].name, name) == 0) return MT_OK;
    places->list[places->count++] =
        (mt_named_place){value, name, known && is_at(value, known->plain), value, name};
    return MT_OK;
}

static mt_status add_standard_places(mt_axis_places *places) {
    enum { QUARTERS = 4 };
    const mt_axis *axis = places->axis;
    int parts = axis->tag == SLANT || axis->tag == ITALIC ? 1 : QUARTERS;
    bool has_names = axis->tag == WEIGHT || axis->tag == WIDTH;
    mt_status status = MT_OK;
    for (int i = 0; i < VALUE_NAMES && status == MT_OK; i++)
        if (value_names[i].tag == axis->tag) status = add_place(places, value_names[i].value);
    for (int i = 0; i <= parts && status == MT_OK && !has_names; i++)
        status = add_place(places, mt_axis_user(axis, (double)MT_AXIS_END * i / parts));
    return status;
}

/* The regular weight's bold is its link, as bold buttons of applications have it. */
static void link_bold(mt_axis_places *places) {
    mt_named_place *regular = NULL;
    if (places->axis->tag != WEIGHT) return;
    for (int i = 0; i < places->count; i++) {
        if (is_at(places->list[i].value, 400)) regular = &places->list[i];
        if (is_at(places->list[i].value, 700) && regular) regular->linked = places->list[i].value;
    }
}

static int compare(const void *a, const void *b) {
    double x = ((const mt_named_place *)a)->value, y = ((const mt_named_place *)b)->value;
    return (x > y) - (x < y);
}

/* Hands over the places, which ascend, with the axis' own name. */
static mt_status take_places(mt_axis_places *places, mt_axis_data *data) {
    const struct mt_known_axis *known = find_axis(data->axis.tag);
    char *name = mt_arena_new(places->arena, 5, 1);
    if (!name) return MT_NO_MEMORY;
    for (int i = 0; i < 4; i++) name[i] = (char)(data->axis.tag >> (24 - 8 * i) & 0xFF);
    link_bold(places);
    data->name = known ? known->name : name;
    data->named = places->list;
    data->named_count = places->count;
    return MT_OK;
}

mt_status mt_axis_name_places(const double *values, int count, mt_arena *arena, mt_axis_data *data) {
    enum { STANDARD_MOST = 16 };
    mt_axis_places places = {&data->axis, arena, NULL, 0};
    places.list = mt_arena_new(arena, STANDARD_MOST + (size_t)count, sizeof *places.list);
    if (!places.list) return MT_NO_MEMORY;
    mt_status status = add_standard_places(&places);
    for (int i = 0; i < count && status == MT_OK; i++) status = add_place(&places, values[i]);
    if (status != MT_OK) return status;
    qsort(places.list, (size_t)places.count, sizeof *places.list, compare);
    return take_places(&places, data);
}

/* A name that the axis has for the value anyway is left out where it is the plain one. */
mt_status mt_axis_name_stops(const double *values, const mt_stop_name *names, int count, mt_arena *arena,
                             mt_axis_data *data) {
    const mt_axis *axis = &data->axis;
    mt_axis_places places = {axis, arena, mt_arena_new(arena, (size_t)count, sizeof *places.list), count};
    if (!places.list) return MT_NO_MEMORY;
    for (int i = 0; i < count; i++) {
        const char *known = find_name(axis, values[i]);
        bool plain = is_at(values[i], mt_axis_plain(axis->tag)) && known && strcmp(names[i].part, known) == 0;
        places.list[i] = (mt_named_place){values[i], names[i].whole, plain, values[i], names[i].part};
    }
    return take_places(&places, data);
}
