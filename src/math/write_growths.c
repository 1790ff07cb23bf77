/* MathVariants, written. */
#include "layout/lookup_builder.h"
#include "math/writer.h"

/* ---- one glyph ----------------------------------------------------------------------------------------- */

static mt_status write_assembly(const mt_math_writer *writer, const mt_math_growth *growth,
                                mt_direction direction, mt_table *table) {
    size_t to_pool = 6 + 10 * (size_t)growth->part_count;
    mt_variation_pool pool = mt_variation_pool_make(writer->places.store);
    mt_math_write_value(writer, (mt_math_of){growth->glyph, MT_ACROSS}, growth->italics, &pool, to_pool,
                        table);
    mt_table_16(table, growth->part_count);
    for (int i = 0; i < growth->part_count; i++) {
        const mt_math_part_row *part = &growth->parts[i];
        const mt_math_of of = {part->glyph, direction};
        mt_table_16(table, part->glyph);
        mt_table_u16_of(table, mt_math_at_first(writer, of, part->start));
        mt_table_u16_of(table, mt_math_at_first(writer, of, part->end));
        mt_table_u16_of(table, mt_math_at_first(writer, of, part->full));
        mt_table_16(table, (int)part->flags);
    }
    bool too_far = to_pool + mt_variation_pool_size(&pool) > UINT16_MAX;
    mt_variation_pool_write(&pool, table);
    mt_variation_pool_free(&pool);
    return pool.status == MT_OK && too_far ? MT_TOO_LARGE : pool.status;
}

static double measure_of(const mt_math_writer *writer, const mt_math_variant_row *variant,
                         mt_direction direction) {
    return mt_math_at_first(writer, (mt_math_of){variant->glyph, direction}, variant->measure);
}

/* By their measures: one of the first font alone may be less than one before it that is larger in another font. */
static mt_status sort_variants(const mt_math_writer *writer, const mt_math_growth *growth,
                               mt_direction direction, const mt_math_variant_row ***sorted) {
    const mt_math_variant_row **list =
        mt_arena_new(writer->scratch, (size_t)growth->variant_count + 1, sizeof *list);
    if (!list) return MT_NO_MEMORY;
    for (int i = 0; i < growth->variant_count; i++) {
        const mt_math_variant_row *variant = &growth->variants[i];
        double measure = measure_of(writer, variant, direction);
        int at = i;
        for (; at > 0 && measure_of(writer, list[at - 1], direction) > measure; at--) list[at] = list[at - 1];
        list[at] = variant;
    }
    *sorted = list;
    return MT_OK;
}

/* MathGlyphConstruction. */
static mt_status write_growth(const mt_math_writer *writer, const mt_math_growth *growth,
                              mt_direction direction, mt_table *table) {
    const mt_math_variant_row **variants;
    mt_status status = sort_variants(writer, growth, direction, &variants);
    if (status != MT_OK) return status;
    mt_math_nest nest = mt_math_nest_begin(table, 4 + 4 * (size_t)growth->variant_count);
    if (growth->part_count)
        mt_math_nest_offset(&nest);
    else
        mt_table_16(table, 0);
    mt_table_16(table, growth->variant_count);
    for (int i = 0; i < growth->variant_count; i++) {
        mt_table_16(table, variants[i]->glyph);
        mt_table_u16_of(table, measure_of(writer, variants[i], direction));
    }
    if (growth->part_count) status = write_assembly(writer, growth, direction, &nest.inner);
    mt_status ended = mt_math_nest_end(&nest);
    return status == MT_OK ? ended : status;
}

/* ---- the table ----------------------------------------------------------------------------------------- */

/* A Coverage table, also of no glyphs: readers want one. */
static mt_status write_coverage(const mt_math_writer *writer, const mt_math_growths *growths,
                                mt_table *table) {
    uint16_t *glyphs = mt_arena_new(writer->scratch, (size_t)growths->count + 1, sizeof *glyphs);
    if (!glyphs) return MT_NO_MEMORY;
    for (int i = 0; i < growths->count; i++) glyphs[i] = growths->list[i].glyph;
    mt_table_coverage(table, glyphs, growths->count);
    return MT_OK;
}

mt_status mt_math_write_growths(const mt_math_writer *writer, mt_table *table) {
    const mt_math_growths *all = writer->math->growths;
    size_t count = (size_t)(all[MT_MATH_VERTICAL].count + all[MT_MATH_HORIZONTAL].count);
    mt_math_nest nest = mt_math_nest_begin(table, 10 + 2 * count);
    mt_status status = MT_OK;
    const mt_math_of whole = {MT_MATH_FONT, MT_UP}; /* of parts in both directions */
    mt_table_u16_of(table, mt_math_at_first(writer, whole, writer->math->least_overlap));
    for (int k = 0; k < MT_MATH_DIRECTIONS && status == MT_OK; k++) {
        mt_math_nest_offset(&nest);
        status = write_coverage(writer, &all[k], &nest.inner);
    }
    for (int k = 0; k < MT_MATH_DIRECTIONS; k++) mt_table_16(table, all[k].count);
    for (int k = 0; k < MT_MATH_DIRECTIONS; k++)
        for (int i = 0; i < all[k].count && status == MT_OK && !nest.too_far; i++) {
            mt_math_nest_offset(&nest);
            mt_direction direction = k == MT_MATH_VERTICAL ? MT_UP : MT_ACROSS;
            status = write_growth(writer, &all[k].list[i], direction, &nest.inner);
        }
    mt_status ended = mt_math_nest_end(&nest);
    return status == MT_OK ? ended : status;
}
