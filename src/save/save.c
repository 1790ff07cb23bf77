#include "save/save.h"

#include <errno.h>
#include <string.h>
#include <strings.h>

#include "base/file.h"
#include "base/file_set.h"
#include "base/memory.h"
#include "blend/instances.h"
#include "blend/variable.h"
#include "save/designspace.h"
#include "save/ufo.h"
#include "sfnt/woff2.h"
#include "save/woff2_plain.h"
#include "write/write.h"

/* ---- formats ---------------------------------------------------------------------------------------------- */

bool mt_font_format_of(const char *path, mt_font_format *format) {
    static const char *const extensions[] = {".ttf", ".woff2", ".ufo", ".designspace"};
    const char *dot = strrchr(path, '.');
    for (int i = 0; dot && i < 4; i++) {
        if (strcasecmp(dot, extensions[i]) != 0) continue;
        *format = (mt_font_format)i;
        return true;
    }
    return false;
}

mt_status mt_save_check(const char *path) {
    mt_font_format format;
    if (!mt_font_format_of(path, &format)) return MT_UNKNOWN_FORMAT;
    if (format == MT_FONT_DESIGNSPACE) return mt_designspace_check(path);
    return format == MT_FONT_UFO ? mt_folder_check(path, MT_UFO_MARK) : mt_file_check(path);
}

/* ---- one font, made but not in its place yet -------------------------------------------------------------- */

typedef struct mt_product {
    const char *path;
    mt_font_format format;
    uint8_t *bytes; /* of a file */
    size_t length;
    mt_folder folder;
    mt_designspace designspace;
    const mt_variable *variable; /* of a designspace */
    int first;                   /* of what is to be placed, its first */
    int unsaid;                  /* as mt_ufo_write has it */
} mt_product;

static bool has_overlaps(const mt_font_data *data) {
    for (int i = 0; i < data->glyph_count; i++)
        if (data->glyphs[i].overlaps) return true;
    return false;
}

mt_status mt_font_pack(const mt_font_data *data, const uint8_t *font, size_t length, uint8_t **packed,
                       size_t *packed_length) {
    return has_overlaps(data) ? mt_woff2_pack_plain(font, length, packed, packed_length)
                              : mt_woff2_pack(font, length, packed, packed_length);
}

static mt_status pack(const mt_font_data *data, mt_product *product) {
    uint8_t *packed;
    size_t length;
    mt_status status = mt_font_pack(data, product->bytes, product->length, &packed, &length);
    if (status != MT_OK) return status;
    mt_bytes_free(product->bytes);
    product->bytes = packed;
    product->length = length;
    return MT_OK;
}

static mt_status make_product(const mt_font_data *data, mt_product *product) {
    mt_status status;
    if (product->format == MT_FONT_UFO) {
        status = mt_folder_begin(product->path, &product->folder);
        if (status == MT_OK) status = mt_ufo_write(data, &product->folder, &product->unsaid);
        product->length = product->folder.length;
        return status;
    }
    status = mt_font_write(data, &product->bytes, &product->length);
    return status == MT_OK && product->format == MT_FONT_WOFF2 ? pack(data, product) : status;
}

/* Adds a master to a designspace, which the first begins. */
static mt_status add_master(const mt_font_data *data, int place, mt_product *product) {
    mt_status status = MT_OK;
    if (!product->designspace.path)
        status = mt_designspace_begin(product->path, product->variable, &product->designspace);
    return status == MT_OK ? mt_designspace_add(&product->designspace, data, place) : status;
}

static mt_status end_designspace(mt_product *product, mt_file_set *set) {
    mt_status status = mt_designspace_end(&product->designspace, set);
    product->length = product->designspace.length;
    product->unsaid = product->designspace.unsaid;
    return status;
}

/* Adds what was made to what is to be placed. */
static mt_status end_product(mt_product *product, mt_file_set *set) {
    product->first = set->count;
    if (product->format == MT_FONT_DESIGNSPACE) return end_designspace(product, set);
    if (product->format == MT_FONT_UFO) return mt_file_set_add_folder(set, &product->folder, MT_UFO_MARK);
    return mt_file_set_add(set, product->path, product->bytes, product->length);
}

static void free_product(mt_product *product) {
    mt_bytes_free(product->bytes);
    mt_folder_free(&product->folder);
    mt_designspace_free(&product->designspace);
}

/* ---- all of them ------------------------------------------------------------------------------------------ */

typedef struct mt_products {
    const mt_saving *saving;
    mt_product *list;
    int at_hand; /* of variable fonts, the one that is made */
    int failed;
} mt_products;

/* Notes which font an error is about, where it is about one. */
static mt_status note(mt_products *products, int index, mt_status status) {
    bool of_font = status == MT_CANNOT_WRITE || status == MT_TOO_LARGE || status == MT_UNKNOWN_FORMAT;
    if (of_font) products->failed = index;
    return status;
}

static mt_status prepare(mt_products *products) {
    const mt_saving *saving = products->saving;
    for (int i = 0; i < saving->count; i++) {
        mt_product *product = &products->list[i];
        product->path = saving->paths[i];
        bool known = mt_font_format_of(product->path, &product->format);
        /* A UFO does not vary; what does not vary has no designspace. */
        bool fits = known && product->format != (saving->t ? MT_FONT_DESIGNSPACE : MT_FONT_UFO);
        mt_status status = fits ? mt_save_check(product->path) : MT_UNKNOWN_FORMAT;
        if (status != MT_OK) return note(products, i, status);
    }
    return MT_OK;
}

static mt_status keep(const mt_font_data *data, int index, void *user) {
    mt_products *products = user;
    return note(products, index, make_product(data, &products->list[index]));
}

/* All that is to be placed, all at once. */
static mt_status place_set(mt_products *products, mt_file_set *set) {
    int count = products->saving->count, failed = 0, product = count - 1;
    for (int i = 0; i < count; i++) {
        mt_status status = end_product(&products->list[i], set);
        if (status != MT_OK) return note(products, i, status);
    }
    mt_status status = mt_file_set_place(set, &failed);
    while (status != MT_OK && product > 0 && products->list[product].first > failed) product--;
    return status == MT_OK ? status : note(products, product, status);
}

static mt_status place(mt_products *products) {
    const mt_saving *saving = products->saving;
    mt_file_set set;
    if (saving->count == 0) return MT_OK;
    mt_status status = mt_file_set_begin(saving->paths[0], &set);
    if (status != MT_OK) return note(products, 0, status);
    status = place_set(products, &set);
    mt_file_set_free(&set);
    if (status != MT_OK) return status;
    for (int i = 0; i < saving->count; i++) {
        const mt_product *product = &products->list[i];
        if (saving->lengths) saving->lengths[i] = product->length;
        if (saving->unsaid && product->unsaid > *saving->unsaid) *saving->unsaid = product->unsaid;
    }
    return MT_OK;
}

/* Makes the fonts that are saved, from `source`, and hands them to `keep`. */
typedef mt_status (*mt_make_fonts)(void *source, mt_products *products);

static mt_status save_when(void *source, mt_make_fonts make, const mt_saving *saving, int *failed) {
    mt_products products = {.saving = saving, .failed = -1};
    products.list = mt_new((size_t)saving->count, sizeof *products.list);
    if (!products.list) return MT_NO_MEMORY;
    mt_status status = prepare(&products);
    if (status == MT_OK) status = make(source, &products);
    if (status == MT_OK && saving->made) status = saving->made(saving->user);
    if (status == MT_OK) status = place(&products);
    int why = errno;
    for (int i = 0; i < saving->count; i++) free_product(&products.list[i]);
    mt_free(products.list);
    if (failed) *failed = products.failed;
    errno = why;
    return status;
}

static mt_status make_blends(void *blend, mt_products *products) {
    const mt_saving *saving = products->saving;
    return mt_blend_make(blend, saving->t, saving->count, keep, products);
}

mt_status mt_blend_save_when(mt_blend *blend, const mt_saving *saving, int *failed) {
    return save_when(blend, make_blends, saving, failed);
}

/* ---- variable fonts --------------------------------------------------------------------------------------- */

typedef struct mt_variables {
    mt_variable *const *list;
    const mt_sink *const *also;
} mt_variables;

static mt_status keep_variable(const mt_font_data *data, int index, void *user) {
    mt_products *products = user;
    (void)index;
    return keep(data, products->at_hand, products);
}

static mt_status keep_master(const mt_font_data *data, int place, void *user) {
    mt_products *products = user;
    return note(products, products->at_hand, add_master(data, place, &products->list[products->at_hand]));
}

static mt_status make_variables(void *source, mt_products *products) {
    const mt_variables *variables = source;
    mt_status status = MT_OK;
    for (int i = 0; i < products->saving->count && status == MT_OK; i++) {
        mt_product *product = &products->list[i];
        const mt_sink *also = variables->also ? variables->also[i] : NULL;
        products->at_hand = i;
        product->variable = variables->list[i];
        if (product->format == MT_FONT_DESIGNSPACE)
            status = mt_variable_masters(variables->list[i], also, keep_master, products);
        else
            status = mt_variable_make(variables->list[i], also, keep_variable, products);
    }
    return status;
}

mt_status mt_variables_save_when(mt_variable *const *variables, const mt_sink *const *also,
                                 const mt_saving *saving, int *failed) {
    mt_variables all = {variables, also};
    return save_when(&all, make_variables, saving, failed);
}

mt_status mt_variable_save(mt_variable *variable, const char *path) {
    const mt_saving saving = {.count = 1, .paths = &path};
    return mt_variables_save_when(&variable, NULL, &saving, NULL);
}

mt_status mt_blend_save_fonts(mt_blend *blend, const double *t, int count, const char *const *paths) {
    const mt_saving saving = {.t = t, .count = count, .paths = paths};
    return mt_blend_save_when(blend, &saving, NULL);
}

mt_status mt_blend_save(mt_blend *blend, double t, const char *path) {
    return mt_blend_save_fonts(blend, &t, 1, &path);
}
