/* PLY 1.0 (Turk, "The PLY Polygon File Format", 1994): a header of elements and their properties, then each element's rows. */
#include <string.h>

#include "mesh/bytes.h"
#include "mesh/formats.h"
#include "mesh/limits.h"
#include "mesh/words.h"

/* What a header may have. */
enum { ELEMENTS_MAX = 32, PROPERTIES_MAX = 64 };

typedef enum mt_ply_type {
    PLY_NONE,
    PLY_INT8,
    PLY_UINT8,
    PLY_INT16,
    PLY_UINT16,
    PLY_INT32,
    PLY_UINT32,
    PLY_FLOAT,
    PLY_DOUBLE,
} mt_ply_type;

typedef enum mt_ply_role { PLY_OTHER, PLY_X, PLY_Y, PLY_Z, PLY_CORNERS } mt_ply_role;

typedef struct mt_ply_property {
    mt_ply_type type, count_type; /* PLY_NONE: no list */
    mt_ply_role role;
} mt_ply_property;

typedef struct mt_ply_element {
    bool is_vertex, is_face;
    long count;
    int n_properties;
    mt_ply_property properties[PROPERTIES_MAX];
} mt_ply_element;

typedef struct mt_ply {
    mt_draft *draft;
    mt_words text; /* what has not been read, also of binary files */
    bool binary, big;
    int n_elements;
    mt_ply_element elements[ELEMENTS_MAX];
} mt_ply;

static mt_status refuse(const mt_ply *ply, const char *what) {
    return mt_mesh_say(ply->draft->fault, MT_BAD_MESH, "%s", what);
}

/* ---- the header ---------------------------------------------------------------------------------------- */

static mt_ply_type type_of(mt_word word) {
    static const char *const names[][2] = {{"char", "int8"},     {"uchar", "uint8"},   {"short", "int16"},
                                           {"ushort", "uint16"}, {"int", "int32"},     {"uint", "uint32"},
                                           {"float", "float32"}, {"double", "float64"}};
    for (int i = 0; i < 8; i++)
        if (mt_word_is(word, names[i][0]) || mt_word_is(word, names[i][1])) return (mt_ply_type)(i + 1);
    return PLY_NONE;
}

static mt_ply_role role_of(mt_word word, const mt_ply_element *element, bool is_list) {
    static const char *const axes[] = {"x", "y", "z"};
    for (int i = 0; i < 3; i++)
        if (element->is_vertex && !is_list && mt_word_is(word, axes[i])) return (mt_ply_role)(PLY_X + i);
    bool corners = mt_word_is(word, "vertex_indices") || mt_word_is(word, "vertex_index");
    return element->is_face && is_list && corners ? PLY_CORNERS : PLY_OTHER;
}

static mt_status read_format(mt_ply *ply, mt_words *line) {
    mt_word word, version;
    if (!mt_words_next(line, &word) || !mt_words_next(line, &version) || !mt_word_is(version, "1.0"))
        return refuse(ply, "no PLY of version 1.0");
    ply->big = mt_word_is(word, "binary_big_endian");
    ply->binary = ply->big || mt_word_is(word, "binary_little_endian");
    return ply->binary || mt_word_is(word, "ascii") ? MT_OK : refuse(ply, "no format that PLY has");
}

static mt_status read_element(mt_ply *ply, mt_words *line) {
    mt_word name, count;
    if (ply->n_elements == ELEMENTS_MAX) return refuse(ply, "the header has too many elements");
    mt_ply_element *element = &ply->elements[ply->n_elements++];
    *element = (mt_ply_element){0};
    if (!mt_words_next(line, &name) || !mt_words_next(line, &count) ||
        !mt_word_whole(count, &element->count) || element->count < 0)
        return refuse(ply, "the header has an element without a count");
    element->is_vertex = mt_word_is(name, "vertex");
    element->is_face = mt_word_is(name, "face");
    return element->is_face ? mt_draft_expect(ply->draft, element->count) : MT_OK;
}

static mt_status read_property(mt_ply *ply, mt_words *line) {
    mt_word word;
    if (ply->n_elements == 0) return refuse(ply, "the header has a property without an element");
    mt_ply_element *element = &ply->elements[ply->n_elements - 1];
    if (element->n_properties == PROPERTIES_MAX) return refuse(ply, "the header has too many properties");
    mt_ply_property *property = &element->properties[element->n_properties++];
    *property = (mt_ply_property){0};
    bool good = mt_words_next(line, &word), is_list = good && mt_word_is(word, "list");
    if (is_list) {
        good = mt_words_next(line, &word);
        property->count_type = good ? type_of(word) : PLY_NONE;
        good = good && property->count_type != PLY_NONE && property->count_type < PLY_FLOAT &&
               mt_words_next(line, &word);
    }
    property->type = good ? type_of(word) : PLY_NONE;
    good = good && property->type != PLY_NONE && mt_words_next(line, &word);
    if (!good) return refuse(ply, "the header has a malformed property");
    property->role = role_of(word, element, is_list);
    return MT_OK;
}

static mt_status read_header(mt_ply *ply) {
    mt_words line;
    mt_word word;
    mt_status status = MT_OK;
    if (!mt_words_line(&ply->text, &line) || !mt_words_next(&line, &word) || !mt_word_is(word, "ply"))
        return refuse(ply, "no PLY");
    while (status == MT_OK && mt_words_line(&ply->text, &line)) {
        if (!mt_words_next(&line, &word)) continue;
        if (mt_word_is(word, "end_header")) return MT_OK;
        if (mt_word_is(word, "format")) status = read_format(ply, &line);
        if (mt_word_is(word, "element")) status = read_element(ply, &line);
        if (mt_word_is(word, "property")) status = read_property(ply, &line);
    }
    return status == MT_OK ? refuse(ply, "cut short: the header does not end") : status;
}

/* ---- the rows ------------------------------------------------------------------------------------------ */

static double number_in(const uint8_t *bytes, mt_ply_type type, bool big) {
    switch (type) {
    case PLY_INT8: return (int8_t)bytes[0];
    case PLY_UINT8: return bytes[0];
    case PLY_INT16: return (int16_t)mt_get_unsigned(bytes, 2, big);
    case PLY_UINT16: return (uint16_t)mt_get_unsigned(bytes, 2, big);
    case PLY_INT32: return (int32_t)mt_get_unsigned(bytes, 4, big);
    case PLY_UINT32: return (uint32_t)mt_get_unsigned(bytes, 4, big);
    case PLY_FLOAT: return (double)mt_get_float(bytes, big);
    default: return mt_get_double(bytes, big);
    }
}

static bool next_number(mt_ply *ply, mt_ply_type type, double *number) {
    static const int sizes[] = {0, 1, 1, 2, 2, 4, 4, 4, 8};
    mt_word word;
    if (!ply->binary) return mt_words_next(&ply->text, &word) && mt_word_number(word, number);
    if (ply->text.end - ply->text.at < sizes[type]) return false;
    *number = number_in((const uint8_t *)ply->text.at, type, ply->big);
    ply->text.at += sizes[type];
    return true;
}

static mt_status broken(const mt_ply *ply) {
    return refuse(ply, ply->binary ? "cut short" : "cut short, or a word that is no number");
}

/* A list: the corners of a polygon, or passed over. */
static mt_status read_list(mt_ply *ply, const mt_ply_property *property) {
    int corners[MT_MESH_CORNERS_MAX];
    double count, number;
    bool wanted = property->role == PLY_CORNERS;
    if (!next_number(ply, property->count_type, &count)) return broken(ply);
    if (!(count >= 0) || (wanted && count > MT_MESH_CORNERS_MAX))
        return refuse(ply, "a list has a count that does not go");
    for (double i = 0; i < count; i++) {
        if (!next_number(ply, property->type, &number)) return broken(ply);
        if (!wanted) continue;
        if (!(number >= 0 && number < MT_MESH_POINTS_MAX))
            return refuse(ply, "a polygon has a corner at no point");
        corners[(int)i] = (int)number;
    }
    return wanted ? mt_draft_polygon(ply->draft, corners, (int)count) : MT_OK;
}

static mt_status read_row(mt_ply *ply, const mt_ply_element *element) {
    double at[PLY_Z + 1] = {0};
    for (int i = 0; i < element->n_properties; i++) {
        const mt_ply_property *property = &element->properties[i];
        double number;
        mt_status status = MT_OK;
        if (property->count_type != PLY_NONE)
            status = read_list(ply, property);
        else if (!next_number(ply, property->type, &number))
            status = broken(ply);
        else if (property->role != PLY_OTHER)
            at[property->role] = number;
        if (status != MT_OK) return status;
    }
    return element->is_vertex ? mt_draft_point(ply->draft, at[PLY_X], at[PLY_Y], at[PLY_Z]) : MT_OK;
}

static bool has(const mt_ply_element *element, mt_ply_role role) {
    for (int i = 0; i < element->n_properties; i++)
        if (element->properties[i].role == role) return true;
    return false;
}

static mt_status read_rows(mt_ply *ply, const mt_ply_element *element) {
    mt_status status = MT_OK;
    if (element->is_vertex && !(has(element, PLY_X) && has(element, PLY_Y) && has(element, PLY_Z)))
        return refuse(ply, "its points have no x, y and z");
    for (long i = 0; i < element->count && element->n_properties > 0 && status == MT_OK; i++)
        status = read_row(ply, element);
    return status;
}

mt_status mt_read_ply(const uint8_t *bytes, size_t length, mt_draft *draft) {
    mt_ply ply = {.draft = draft, .text = mt_words_of(bytes, length)};
    mt_status status = read_header(&ply);
    for (int i = 0; i < ply.n_elements && status == MT_OK; i++) status = read_rows(&ply, &ply.elements[i]);
    return status;
}
