/* Figures of the whole font mixed of two fonts'; dates; embedding bits, the stricter of both. */
#include "blend/metadata.h"

#include "source/panose.h"
#include "write/style.h"

#include <math.h>
#include <stdlib.h>

#include "arithmetic/angles.h"

int mt_metadata_units(const mt_font *a, const mt_font *b) {
    int units =
        mt_font_units_per_em(a) > mt_font_units_per_em(b) ? mt_font_units_per_em(a) : mt_font_units_per_em(b);
    bool power_of_two = (units & (units - 1)) == 0;
    while (units < (power_of_two ? 2048 : 1000)) units *= 2;
    return units;
}

/* ---- metrics ------------------------------------------------------------------------------------------- */

/* (1 - t)·a + t·b, each given in its own font's units, in those of the new font. */
typedef struct mt_scale {
    double a, b;
} mt_scale;

static double mixed(mt_scale scale, double a, double b) {
    return scale.a * a + scale.b * b;
}

/* Past the ends a class may come to what it cannot be. */
static double within(double value, double least, double most) {
    return fmin(fmax(value, least), most);
}

/* Where only one font has its typographic lines used, the other's are hhea's, and the blend's are used: lines are then as
 * far apart as something between the two fonts' own. The ends do as their fonts do. */
static void settle_lines(mt_metrics *a, mt_metrics *b, double t) {
    if (a->use_typo_metrics == b->use_typo_metrics || t <= 0 || t >= 1) return;
    mt_metrics *other = a->use_typo_metrics ? b : a;
    other->typo_ascender = other->hhea_ascender;
    other->typo_descender = other->hhea_descender;
    other->typo_line_gap = other->hhea_line_gap;
    other->use_typo_metrics = true;
}

static mt_metrics mix_metrics(const mt_metrics *a, const mt_metrics *b, mt_scale s, mt_scale up, mt_at at) {
    double t = at.x;
    mt_scale plain = {1 - t, t}; /* for what is not measured in font units */
    mt_metrics mix = {
        .hhea_ascender = mixed(up, a->hhea_ascender, b->hhea_ascender),
        .hhea_descender = mixed(up, a->hhea_descender, b->hhea_descender),
        .hhea_line_gap = mixed(up, a->hhea_line_gap, b->hhea_line_gap),
        .typo_ascender = mixed(up, a->typo_ascender, b->typo_ascender),
        .typo_descender = mixed(up, a->typo_descender, b->typo_descender),
        .typo_line_gap = mixed(up, a->typo_line_gap, b->typo_line_gap),
        .win_ascent = mixed(up, a->win_ascent, b->win_ascent),
        .win_descent = mixed(up, a->win_descent, b->win_descent),
        .x_height = mixed(up, a->x_height, b->x_height),
        .cap_height = mixed(up, a->cap_height, b->cap_height),
        .underline_position = mixed(up, a->underline_position, b->underline_position),
        .underline_thickness = mixed(up, a->underline_thickness, b->underline_thickness),
        .strikeout_position = mixed(up, a->strikeout_position, b->strikeout_position),
        .strikeout_size = mixed(up, a->strikeout_size, b->strikeout_size),
        .subscript_size = {mixed(s, a->subscript_size[0], b->subscript_size[0]),
                           mixed(up, a->subscript_size[1], b->subscript_size[1])},
        .subscript_offset = {mixed(s, a->subscript_offset[0], b->subscript_offset[0]),
                             mixed(up, a->subscript_offset[1], b->subscript_offset[1])},
        .superscript_size = {mixed(s, a->superscript_size[0], b->superscript_size[0]),
                             mixed(up, a->superscript_size[1], b->superscript_size[1])},
        .superscript_offset = {mixed(s, a->superscript_offset[0], b->superscript_offset[0]),
                               mixed(up, a->superscript_offset[1], b->superscript_offset[1])},
        .italic_angle = mixed(plain, a->italic_angle, b->italic_angle),
        .weight_class = within(mixed(plain, a->weight_class, b->weight_class), 1, 1000),
        .width_class = within(mixed(plain, a->width_class, b->width_class), 1, 9),
        .caret_offset = mixed(s, a->caret_offset, b->caret_offset),
        .vhea_ascender = mixed(s, a->vhea_ascender, b->vhea_ascender),
        .vhea_descender = mixed(s, a->vhea_descender, b->vhea_descender),
        .vhea_line_gap = mixed(s, a->vhea_line_gap, b->vhea_line_gap),
        .family_class = a->family_class == b->family_class ? a->family_class : 0,
        .monospaced = (a->monospaced || t >= 1) && (b->monospaced || t <= 0),
        .use_typo_metrics = at.y < 1 ? a->use_typo_metrics : b->use_typo_metrics,
        .vertical = a->vertical || b->vertical,
    };
    mt_panose_mix(a->panose, b->panose, t, mix.panose);
    return mix;
}

/* The caret leans with the letters: rise to the em, run by the angle. */
static void lean_caret(int units, mt_metrics *metrics) {
    double run = mt_tan(-metrics->italic_angle * M_PI / 180) * units;
    bool upright = !(fabs(run) >= 0.5 && fabs(run) <= INT16_MAX);
    metrics->caret_rise = upright ? 1 : units;
    metrics->caret_run = upright ? 0 : run;
}

/* ---- styles and axes ----------------------------------------------------------------------------------- */

void mt_metadata_style(const char *name, mt_font_data *data) {
    const mt_style style = mt_style_read(name);
    data->style = name;
    if (style.weight) data->metrics.weight_class = style.weight;
    if (style.width) data->metrics.width_class = style.width;
}

void mt_metadata_axis(const mt_axis *axis, double value, int units, mt_metrics *metrics) {
    if (axis->tag == MT_TAG('w', 'g', 'h', 't')) metrics->weight_class = value;
    if (axis->tag == MT_TAG('w', 'd', 't', 'h')) metrics->width_class = mt_width_class(value);
    if (axis->tag != MT_TAG('s', 'l', 'n', 't')) return;
    metrics->italic_angle = value;
    lean_caret(units, metrics);
}

/* ---- dates and rights ---------------------------------------------------------------------------------- */

/* Seconds since 1904: SOURCE_DATE_EPOCH (seconds since 1970) when it is set, else the newer of the sources'
 * own dates. */
static int64_t date_of(const mt_font *a, const mt_font *b) {
    const char *epoch = getenv("SOURCE_DATE_EPOCH");
    char *end;
    long long seconds = epoch ? strtoll(epoch, &end, 10) : 0;
    if (epoch && end != epoch && *end == '\0' && seconds >= 0 && seconds < INT32_MAX)
        return seconds + 2082844800;
    int64_t in_a = mt_font_modified(a), in_b = mt_font_modified(b);
    return in_a > in_b ? in_a : in_b;
}

/* OS/2 fsType, bits 0 to 3: 2 restricted, 4 preview and print, 8 editable, 0 installable. The stricter of the
 * two holds, and so do both fonts' bits 8 (no subsetting) and 9 (bitmap embedding only). */
static uint16_t stricter(uint16_t a, uint16_t b) {
    static const uint16_t by_strictness[] = {2, 4, 8};
    uint16_t further = (a | b) & 0x300;
    for (int i = 0; i < 3; i++)
        if ((a | b) & by_strictness[i]) return by_strictness[i] | further;
    return further;
}

static mt_scale scale_of(const mt_font *a, const mt_font *b, double t, int units) {
    return (mt_scale){(1 - t) * units / mt_font_units_per_em(a), t * units / mt_font_units_per_em(b)};
}

void mt_metadata_fill(const mt_font *a, const mt_font *b, mt_at at, mt_font_data *data) {
    mt_metrics in_a, in_b;
    mt_font_metrics(a, &in_a);
    mt_font_metrics(b, &in_b);
    settle_lines(&in_a, &in_b, at.y);
    data->metrics =
        mix_metrics(&in_a, &in_b, scale_of(a, b, at.x, data->units), scale_of(a, b, at.y, data->units), at);
    lean_caret(data->units, &data->metrics);
    data->created = data->modified = date_of(a, b);
    data->is_symbol = mt_font_is_symbol(a);
    data->embedding = stricter(mt_font_embedding(a), mt_font_embedding(b));
}
