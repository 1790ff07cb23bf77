/* A UFO's kerning: groups.plist and kerning.plist. */
#include <stdlib.h>
#include <stdio.h>
#include <string.h>

#include "save/ufo_parts.h"

/* ---- groups ----------------------------------------------------------------------------------------------- */

/* A group is named after its first glyph, which is in no other of its side. */
static mt_status name_groups(const mt_kerning_group *groups, int count, const char *prefix,
                             const mt_ufo_glyphs *glyphs, mt_arena *arena, const char ***names) {
    const char **made = mt_arena_new(arena, (size_t)count, sizeof *made);
    if (!made) return MT_NO_MEMORY;
    for (int i = 0; i < count; i++) {
        const char *first = groups[i].count ? glyphs->names[groups[i].glyphs[0]] : "";
        size_t room = strlen(prefix) + strlen(first) + 1;
        char *name = mt_arena_new(arena, room, 1);
        if (!name) return MT_NO_MEMORY;
        snprintf(name, room, "%s%s", prefix, first);
        made[i] = name;
    }
    *names = made;
    return MT_OK;
}

static void write_side(const mt_kerning_group *groups, int count, const char *const *names,
                       const mt_ufo_glyphs *glyphs, mt_xml *xml) {
    for (int i = 0; i < count; i++) {
        if (groups[i].count == 0) continue;
        mt_plist_group(xml, names[i], "array");
        for (int k = 0; k < groups[i].count; k++)
            mt_plist_string(xml, NULL, glyphs->names[groups[i].glyphs[k]]);
        mt_xml_close(xml);
    }
}

void mt_ufo_groups(const mt_ufo_kerning *kerning, const mt_ufo_glyphs *glyphs, mt_xml *xml) {
    const mt_kerning *of = kerning->of;
    mt_plist_open(xml, "dict");
    write_side(of->left, of->left_count, kerning->left, glyphs, xml);
    write_side(of->right, of->right_count, kerning->right, glyphs, xml);
    mt_plist_close(xml);
}

/* ---- pairs ------------------------------------------------------------------------------------------------ */

static int compare_pairs(const void *a, const void *b) {
    const mt_kerning_pair *p = a, *q = b;
    if (p->left_is_glyph != q->left_is_glyph) return p->left_is_glyph ? 1 : -1;
    if (p->left != q->left) return p->left < q->left ? -1 : 1;
    if (p->right_is_glyph != q->right_is_glyph) return p->right_is_glyph ? 1 : -1;
    return (p->right > q->right) - (p->right < q->right);
}

static bool same_left(const mt_kerning_pair *p, const mt_kerning_pair *q) {
    return p->left_is_glyph == q->left_is_glyph && p->left == q->left;
}

/* Whether each side is a glyph or a group that has any. */
static bool is_whole(const mt_kerning *of, const mt_kerning_pair *pair) {
    bool left = pair->left_is_glyph || of->left[pair->left].count > 0;
    return left && (pair->right_is_glyph || of->right[pair->right].count > 0);
}

mt_status mt_ufo_kerning_make(const mt_kerning *of, const mt_ufo_glyphs *glyphs, mt_arena *arena,
                              mt_ufo_kerning *kerning) {
    mt_ufo_kerning made = {.of = of,
                           .pairs = mt_arena_new(arena, (size_t)of->pair_count, sizeof *made.pairs)};
    if (!made.pairs) return MT_NO_MEMORY;
    for (int i = 0; i < of->pair_count; i++)
        if (is_whole(of, &of->pairs[i])) made.pairs[made.pair_count++] = of->pairs[i];
    if (made.pair_count) qsort(made.pairs, (size_t)made.pair_count, sizeof *made.pairs, compare_pairs);
    mt_status status = name_groups(of->left, of->left_count, "public.kern1.", glyphs, arena, &made.left);
    if (status == MT_OK)
        status = name_groups(of->right, of->right_count, "public.kern2.", glyphs, arena, &made.right);
    if (status == MT_OK) *kerning = made;
    return status;
}

void mt_ufo_pairs(const mt_ufo_kerning *kerning, const mt_ufo_glyphs *glyphs, mt_xml *xml) {
    mt_plist_open(xml, "dict");
    for (int i = 0; i < kerning->pair_count; i++) {
        const mt_kerning_pair *pair = &kerning->pairs[i];
        bool first = i == 0 || !same_left(pair - 1, pair);
        bool last = i == kerning->pair_count - 1 || !same_left(pair, pair + 1);
        const char *left = pair->left_is_glyph ? glyphs->names[pair->left] : kerning->left[pair->left];
        const char *right = pair->right_is_glyph ? glyphs->names[pair->right] : kerning->right[pair->right];
        if (first) mt_plist_group(xml, left, "dict");
        mt_plist_integer(xml, right, pair->value);
        if (last) mt_xml_close(xml);
    }
    mt_plist_close(xml);
}
