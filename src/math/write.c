#include "layout/lookup_builder.h"
#include "layout/value.h"
#include "math/writer.h"

/* ---- parts of all of its tables ------------------------------------------------------------------------ */

static double mix_at(const mt_math_writer *writer, mt_math_of of, const double *row, int place) {
    mt_between between = of.glyph == MT_MATH_FONT
                             ? mt_between_at(&writer->places, place, of.direction)
                             : mt_between_at_glyph(&writer->places, place, of.glyph, of.direction);
    return mt_between_mix(between, row[between.first], row[between.first + 1]);
}

double mt_math_at_first(const mt_math_writer *writer, mt_math_of of, const double *row) {
    return mix_at(writer, of, row, 0);
}

void mt_math_write_value(const mt_math_writer *writer, mt_math_of of, const double *row,
                         mt_variation_pool *pool, size_t to_pool, mt_table *table) {
    int32_t values[MT_STOPS_MAX];
    for (int i = 0; i < writer->places.count; i++) values[i] = mt_value_rounded(mix_at(writer, of, row, i));
    int device = mt_variation_pool_add(pool, values);
    mt_table_16(table, values[0]);
    mt_table_16(table, device < 0 ? 0 : (int)to_pool + device);
}

mt_math_nest mt_math_nest_begin(mt_table *table, size_t head_length) {
    return (mt_math_nest){.head = table, .head_length = head_length};
}

void mt_math_nest_offset(mt_math_nest *nest) {
    size_t offset = nest->head_length + nest->inner.length;
    nest->too_far |= offset > UINT16_MAX;
    mt_table_16(nest->head, (int)offset);
}

mt_status mt_math_nest_end(mt_math_nest *nest) {
    mt_table_bytes(nest->head, nest->inner.bytes, nest->inner.length);
    nest->head->failed |= nest->inner.failed;
    mt_table_free(&nest->inner);
    return nest->too_far ? MT_TOO_LARGE : MT_OK;
}

/* ---- constants ----------------------------------------------------------------------------------------- */

/* Most constants are heights. */
static mt_math_of what(int constant) {
    static const int across[] = {MT_MATH_SPACE_AFTER_SCRIPT, MT_MATH_SKEWED_FRACTION_GAP,
                                 MT_MATH_KERN_BEFORE_DEGREE, MT_MATH_KERN_AFTER_DEGREE};
    for (size_t i = 0; i < sizeof across / sizeof *across; i++)
        if (constant == across[i]) return (mt_math_of){MT_MATH_FONT, MT_ACROSS};
    return (mt_math_of){MT_MATH_FONT, MT_UP};
}

/* Nothing where the first font has none. */
static mt_status write_constants(const mt_math_writer *writer, mt_table *table) {
    enum { LENGTH = 214 };
    const double *const *constants = writer->math->constants;
    mt_variation_pool pool = mt_variation_pool_make(writer->places.store);
    if (!writer->math->has_constants) return MT_OK;
    for (int i = 0; i < MT_MATH_PERCENTS; i++)
        mt_table_i16_of(table, mt_math_at_first(writer, what(i), constants[i]));
    for (int i = MT_MATH_PERCENTS; i < MT_MATH_FIRST_VALUE; i++)
        mt_table_u16_of(table, mt_math_at_first(writer, what(i), constants[i]));
    for (int i = MT_MATH_FIRST_VALUE; i < MT_MATH_LAST_PERCENT; i++)
        mt_math_write_value(writer, what(i), constants[i], &pool, LENGTH, table);
    const int last = MT_MATH_LAST_PERCENT;
    mt_table_i16_of(table, mt_math_at_first(writer, what(last), constants[last]));
    mt_variation_pool_write(&pool, table);
    mt_variation_pool_free(&pool);
    return pool.status;
}

/* ---- the table ----------------------------------------------------------------------------------------- */

/* MathGlyphInfo, whose length no offset counts, comes last. */
static mt_status put_together(const mt_table *constants, const mt_table *info, const mt_table *growths,
                              mt_table *table) {
    enum { HEADER = 10 };
    size_t to_growths = HEADER + constants->length, to_info = to_growths + growths->length;
    if (to_info > UINT16_MAX) return MT_TOO_LARGE;
    mt_table_32(table, 0x00010000);
    mt_table_16(table, constants->length ? HEADER : 0);
    mt_table_16(table, (int)to_info);
    mt_table_16(table, (int)to_growths);
    mt_table_bytes(table, constants->bytes, constants->length);
    mt_table_bytes(table, growths->bytes, growths->length);
    mt_table_bytes(table, info->bytes, info->length);
    table->failed |= constants->failed || info->failed || growths->failed;
    return MT_OK;
}

static mt_status write_table(const mt_math_writer *writer, mt_table *table) {
    mt_table constants = {0}, info = {0}, growths = {0};
    mt_status status = write_constants(writer, &constants);
    if (status == MT_OK) status = mt_math_write_growths(writer, &growths);
    if (status == MT_OK) status = mt_math_write_info(writer, &info);
    if (status == MT_OK) status = put_together(&constants, &info, &growths, table);
    mt_table_free(&constants);
    mt_table_free(&info);
    mt_table_free(&growths);
    return status;
}

static mt_status write_kept(const mt_math_writer *writer, mt_arena *arena, mt_bytes *bytes) {
    mt_table table = {0};
    mt_status status = write_table(writer, &table);
    if (status == MT_OK) status = mt_table_keep(&table, arena, bytes);
    mt_table_free(&table);
    return status;
}

mt_status mt_math_write(const mt_math *math, const mt_places *places, mt_arena *arena, mt_bytes *bytes) {
    mt_arena scratch = {0};
    mt_math_writer writer = {.math = math, .places = *places, .scratch = &scratch};
    *bytes = (mt_bytes){0};
    if (!math) return MT_OK;
    mt_status status = write_kept(&writer, arena, bytes);
    writer.first_only = true;
    writer.places.count = 1;
    writer.places.store = NULL;
    if (status == MT_TOO_LARGE) status = write_kept(&writer, arena, bytes);
    mt_arena_release(&scratch);
    return status == MT_TOO_LARGE ? MT_OK : status;
}
