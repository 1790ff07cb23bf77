#include "blend/assemble.h"

#include <math.h>

static bool offset(double value, int16_t *rounded) {
    double whole = floor(value + 0.5);
    if (!(whole >= INT16_MIN && whole <= INT16_MAX)) return false;
    *rounded = (int16_t)whole;
    return true;
}

/* Whether the composite takes the same room in the line as a part that is where it is by itself. */
static bool has_metrics_of(const mt_glyf *glyph, const mt_glyf_reference *reference, const mt_glyf *part) {
    return reference->dx == 0 && reference->dy == 0 && glyph->advance == part->advance &&
           glyph->height == part->height && glyph->origin == part->origin;
}

/* False for an offset that is too large. Of several parts that give the metrics the first is marked. */
static bool place(const mt_composite *composite, const mt_assembly *font, const mt_glyf *glyph,
                  mt_glyf_reference *references) {
    bool given = false;
    for (int i = 0; i < composite->count; i++) {
        const mt_moving_reference *moving = &composite->references[i];
        mt_glyf_reference *made = &references[i];
        made->glyph = moving->glyph;
        if (!offset(font->unit_a * moving->a[0] + font->unit_b * moving->b[0], &made->dx)) return false;
        if (!offset(font->unit_a * moving->a[1] + font->unit_b * moving->b[1], &made->dy)) return false;
        made->same_metrics = !given && has_metrics_of(glyph, made, &font->glyphs[made->glyph]);
        given = given || made->same_metrics;
    }
    return true;
}

mt_status mt_composite_assemble(const mt_composite *composite, const mt_assembly *font, mt_arena *kept,
                                mt_arena *scratch, mt_glyf *glyph, mt_extent *extent) {
    mt_glyf made = *glyph;
    mt_extent reach = {0};
    bool overlap = false;
    made.reference_count = composite->count;
    made.references = mt_arena_new(kept, (size_t)composite->count, sizeof *made.references);
    if (!made.references) return MT_NO_MEMORY;
    if (!place(composite, font, glyph, made.references)) return MT_OK;
    mt_status status = mt_glyf_extent(&made, font->extents, &reach);
    if (status == MT_OK) status = mt_parts_touch(&made, font, scratch, &overlap);
    if (status == MT_NO_MEMORY) return status;
    if (status != MT_OK || overlap || reach.points == 0) return MT_OK;
    *glyph = made;
    *extent = reach;
    return MT_OK;
}
