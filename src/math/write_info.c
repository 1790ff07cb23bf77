/* MathGlyphInfo, written. */
#include "layout/lookup_builder.h"
#include "math/writer.h"

/* ---- values of glyphs ---------------------------------------------------------------------------------- */

/* The values, and behind them what varies in them and the Coverage table. */
/* Italics corrections and places of accents are across. */
static mt_status write_rows(const mt_math_writer *writer, const mt_math_rows *rows, mt_table *table) {
    enum { FIRST = 4, RECORD = 4 };
    uint16_t *glyphs = mt_arena_new(writer->scratch, (size_t)rows->count + 1, sizeof *glyphs);
    mt_table values = {0};
    mt_variation_pool pool = mt_variation_pool_make(writer->places.store);
    int count = 0;
    if (!glyphs) return MT_NO_MEMORY;
    for (int i = 0; i < rows->count; i++)
        if (rows->list[i].in_first || !writer->first_only) count++;
    size_t to_pool = FIRST + RECORD * (size_t)count;
    count = 0;
    for (int i = 0; i < rows->count; i++) {
        if (!rows->list[i].in_first && writer->first_only) continue;
        glyphs[count++] = rows->list[i].glyph;
        mt_math_of of = {rows->list[i].glyph, MT_ACROSS};
        mt_math_write_value(writer, of, rows->list[i].in_fonts, &pool, to_pool, &values);
    }
    size_t to_coverage = to_pool + mt_variation_pool_size(&pool);
    mt_variation_pool_write(&pool, &values);
    mt_table_16(table, (int)to_coverage);
    mt_table_16(table, count);
    mt_table_bytes(table, values.bytes, values.length);
    mt_table_coverage(table, glyphs, count);
    table->failed |= values.failed;
    mt_table_free(&values);
    mt_variation_pool_free(&pool);
    return pool.status == MT_OK && to_coverage > UINT16_MAX ? MT_TOO_LARGE : pool.status;
}

/* ---- kerns at corners ---------------------------------------------------------------------------------- */

static mt_status write_kern(const mt_math_writer *writer, int glyph, const mt_math_kern_rows *kern,
                            mt_table *table) {
    enum { RECORD = 4 };
    size_t fonts = (size_t)writer->places.font_count, heights = (size_t)kern->count;
    size_t to_pool = 2 + RECORD * (2 * heights + 1);
    mt_variation_pool pool = mt_variation_pool_make(writer->places.store);
    mt_table_16(table, kern->count);
    for (size_t i = 0; i < heights; i++)
        mt_math_write_value(writer, (mt_math_of){glyph, MT_UP}, kern->heights + i * fonts, &pool, to_pool,
                            table);
    for (size_t i = 0; i <= heights; i++)
        mt_math_write_value(writer, (mt_math_of){glyph, MT_ACROSS}, kern->kerns + i * fonts, &pool, to_pool,
                            table);
    bool too_far = to_pool + mt_variation_pool_size(&pool) > UINT16_MAX;
    mt_variation_pool_write(&pool, table);
    mt_variation_pool_free(&pool);
    return pool.status == MT_OK && too_far ? MT_TOO_LARGE : pool.status;
}

static mt_status write_kerns(const mt_math_writer *writer, mt_table *table) {
    const mt_math *math = writer->math;
    uint16_t *glyphs = mt_arena_new(writer->scratch, (size_t)math->kern_count + 1, sizeof *glyphs);
    mt_status status = glyphs ? MT_OK : MT_NO_MEMORY;
    mt_math_nest nest = mt_math_nest_begin(table, 4 + 2 * MT_MATH_CORNERS * (size_t)math->kern_count);
    for (int i = 0; i < math->kern_count && glyphs; i++) glyphs[i] = math->kerns[i].glyph;
    mt_math_nest_offset(&nest);
    mt_table_16(table, math->kern_count);
    if (glyphs) mt_table_coverage(&nest.inner, glyphs, math->kern_count);
    for (int i = 0; i < math->kern_count && status == MT_OK && !nest.too_far; i++)
        for (int c = 0; c < MT_MATH_CORNERS && status == MT_OK; c++) {
            const mt_math_kern_rows *kern = &math->kerns[i].corners[c];
            if (kern->present) {
                mt_math_nest_offset(&nest);
                status = write_kern(writer, math->kerns[i].glyph, kern, &nest.inner);
            } else {
                mt_table_16(table, 0);
            }
        }
    mt_status ended = mt_math_nest_end(&nest);
    return status == MT_OK ? ended : status;
}

/* ---- the table ----------------------------------------------------------------------------------------- */

static void skip(mt_math_nest *nest) {
    mt_table_16(nest->head, 0);
}

mt_status mt_math_write_info(const mt_math_writer *writer, mt_table *table) {
    const mt_math *math = writer->math;
    const mt_math_rows *rows[] = {&math->italics, &math->accents};
    mt_math_nest nest = mt_math_nest_begin(table, 8);
    mt_status status = MT_OK;
    for (int i = 0; i < 2; i++) {
        (rows[i]->count ? mt_math_nest_offset : skip)(&nest);
        if (rows[i]->count && status == MT_OK) status = write_rows(writer, rows[i], &nest.inner);
    }
    (math->extended_count ? mt_math_nest_offset : skip)(&nest);
    if (math->extended_count) mt_table_coverage(&nest.inner, math->extended, math->extended_count);
    (math->kern_count ? mt_math_nest_offset : skip)(&nest);
    if (math->kern_count && status == MT_OK) status = write_kerns(writer, &nest.inner);
    mt_status ended = mt_math_nest_end(&nest);
    return status == MT_OK ? ended : status;
}
