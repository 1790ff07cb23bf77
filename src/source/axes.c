/* Places of variable fonts (OpenType 'fvar', and Type 1 multiple masters, which FreeType shows the same way). */
#include "source/handle.h"

#include FT_MULTIPLE_MASTERS_H

static int find_axis(const FT_MM_Var *axes, uint32_t tag) {
    for (unsigned i = 0; i < axes->num_axis; i++)
        if (axes->axis[i].tag == tag) return (int)i;
    return -1;
}

/* Fills `place` with the default of each axis, then with the spec's settings. */
static mt_status find_place(const mt_spec *spec, const FT_MM_Var *axes, FT_Fixed *place) {
    for (unsigned i = 0; i < axes->num_axis; i++) place[i] = axes->axis[i].def;
    for (int i = 0; i < spec->axis_count; i++) {
        int axis = find_axis(axes, spec->axes[i].tag);
        FT_Fixed value = spec->axes[i].value;
        if (axis < 0) return MT_NO_AXIS;
        if (value < axes->axis[axis].minimum || value > axes->axis[axis].maximum) return MT_BAD_AXIS;
        place[axis] = value;
    }
    return MT_OK;
}

static bool same_place(const FT_Fixed *a, const FT_Fixed *b, unsigned count) {
    for (unsigned i = 0; i < count; i++)
        if (a[i] != b[i]) return false;
    return true;
}

static int find_instance_name(const FT_MM_Var *axes, const FT_Fixed *place) {
    for (unsigned i = 0; i < axes->num_namedstyles; i++)
        if (same_place(axes->namedstyle[i].coords, place, axes->num_axis))
            return (int)axes->namedstyle[i].strid;
    return -1;
}

static mt_status move_to(mt_font *font, const FT_MM_Var *axes) {
    FT_Fixed *place = mt_arena_new(&font->scratch, axes->num_axis, sizeof *place);
    if (!place) return MT_NO_MEMORY;
    mt_status status = find_place(&font->spec, axes, place);
    if (status != MT_OK) return status;
    if (FT_Set_Var_Design_Coordinates(font->face, axes->num_axis, place) != 0) return MT_NOT_A_FONT;
    font->instance_name = find_instance_name(axes, place);
    return MT_OK;
}

/* Axes beyond the limit stay at their defaults. */
static mt_status note_place(mt_font *font, const FT_MM_Var *axes) {
    FT_Fixed *normalized = mt_arena_new(&font->scratch, axes->num_axis, sizeof *normalized);
    if (!normalized) return MT_NO_MEMORY;
    if (FT_Get_Var_Blend_Coordinates(font->face, axes->num_axis, normalized) != 0) return MT_OK;
    font->axis_count = axes->num_axis < MT_SPEC_AXES ? (int)axes->num_axis : MT_SPEC_AXES;
    for (int i = 0; i < font->axis_count; i++) {
        font->axes[i] = (uint32_t)axes->axis[i].tag;
        font->place[i] = (int32_t)normalized[i];
    }
    return MT_OK;
}

mt_status mt_font_set_axes(mt_font *font) {
    if (!FT_HAS_MULTIPLE_MASTERS(font->face)) return font->spec.axis_count ? MT_NO_AXIS : MT_OK;
    FT_MM_Var *axes;
    if (FT_Get_MM_Var(font->face, &axes) != 0) return MT_NOT_A_FONT;
    mt_status status = font->spec.axis_count ? move_to(font, axes) : MT_OK;
    if (status == MT_OK) status = note_place(font, axes);
    FT_Done_MM_Var(font->library, axes);
    return status;
}

bool mt_font_axis(const mt_font *font, uint32_t tag, double *value) {
    for (int i = 0; i < font->spec.axis_count; i++) {
        if (font->spec.axes[i].tag != tag) continue;
        *value = font->spec.axes[i].value / 65536.0;
        return true;
    }
    return false;
}

int mt_font_axes(const mt_font *font, const uint32_t **tags) {
    *tags = font->axes;
    return font->axis_count;
}
