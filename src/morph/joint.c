#include "morph/joint.h"

#include "morph/divide.h"
#include "morph/join.h"

/* One match on its way: what each side puts in, and which other matches it hangs together with. */
typedef struct mt_strand {
    mt_link match;
    mt_component in_a, in_b; /* the whole component, or the match's share of it */
    int group;
} mt_strand;

typedef struct mt_loom {
    mt_morph *morph;
    const mt_params *params;
    mt_arena *arena;
    int count;
    mt_strand *strands;
    bool *failed; /* each group */
} mt_loom;

/* ---- groups -------------------------------------------------------------------------------------------------- */

static void name_groups(mt_loom *loom) {
    for (int i = 0; i < loom->count; i++) loom->strands[i].group = i;
    bool changed = true;
    while (changed) {
        changed = false;
        for (int i = 0; i < loom->count; i++)
            for (int k = 0; k < i; k++) {
                mt_strand *p = &loom->strands[i], *q = &loom->strands[k];
                bool together = p->match.a == q->match.a || p->match.b == q->match.b;
                if (!together || p->group == q->group) continue;
                p->group = q->group = p->group < q->group ? p->group : q->group;
                changed = true;
            }
    }
}

/* ---- shares -------------------------------------------------------------------------------------------------- */

static int end_of(const mt_strand *strand, bool in_a) {
    return in_a ? strand->match.a : strand->match.b;
}

/* Divides component k of one side among its partners, when it has several; its strands get the shares. */
static mt_status share_out(mt_loom *loom, int k, bool in_a) {
    int count = 0;
    for (int i = 0; i < loom->count; i++) count += end_of(&loom->strands[i], in_a) == k;
    if (count < 2) return MT_OK;
    int *strands = mt_arena_new(loom->arena, (size_t)count, sizeof *strands);
    int *partners = mt_arena_new(loom->arena, (size_t)count, sizeof *partners);
    mt_component *shares = mt_arena_new(loom->arena, (size_t)count, sizeof *shares);
    if (!strands || !partners || !shares) return MT_NO_MEMORY;
    count = 0;
    for (int i = 0; i < loom->count; i++) {
        if (end_of(&loom->strands[i], in_a) != k) continue;
        partners[count] = end_of(&loom->strands[i], !in_a);
        strands[count++] = i;
    }
    const mt_side *from = in_a ? &loom->morph->a : &loom->morph->b,
                  *to = in_a ? &loom->morph->b : &loom->morph->a;
    bool divided;
    mt_status status = mt_divide(from, k, to, partners, count, loom->arena, shares, &divided);
    if (status != MT_OK) return status;
    if (!divided) loom->failed[loom->strands[strands[0]].group] = true;
    for (int i = 0; i < count && divided; i++) {
        mt_strand *strand = &loom->strands[strands[i]];
        if (in_a)
            strand->in_a = shares[i];
        else
            strand->in_b = shares[i];
    }
    return MT_OK;
}

static mt_status start_loom(mt_loom *loom, const mt_links *matches) {
    loom->count = matches->count;
    loom->strands = mt_arena_new(loom->arena, (size_t)loom->count, sizeof *loom->strands);
    loom->failed = mt_arena_new(loom->arena, (size_t)loom->count, sizeof *loom->failed);
    if (!loom->strands || !loom->failed) return MT_NO_MEMORY;
    for (int i = 0; i < loom->count; i++) {
        mt_link match = matches->links[i];
        loom->strands[i] = (mt_strand){match, loom->morph->a.shape.components[match.a],
                                       loom->morph->b.shape.components[match.b], i};
    }
    name_groups(loom);
    mt_status status = MT_OK;
    for (int k = 0; status == MT_OK && k < loom->morph->a.shape.count; k++) status = share_out(loom, k, true);
    for (int l = 0; status == MT_OK && l < loom->morph->b.shape.count; l++)
        status = share_out(loom, l, false);
    return status;
}

/* ---- contours ------------------------------------------------------------------------------------------------ */

/* Joins the strands of a group; when one cannot be, none is. */
static mt_status join_group(mt_loom *loom, int group) {
    mt_morph *morph = loom->morph;
    int before = morph->contour_count;
    for (int i = group; i < loom->count && !loom->failed[group]; i++) {
        const mt_strand *strand = &loom->strands[i];
        if (strand->group != group) continue;
        mt_part a = {&strand->in_a, morph->a.box}, b = {&strand->in_b, morph->b.box};
        int made = 0;
        mt_status status =
            mt_join(a, b, loom->params, loom->arena, morph->contours + morph->contour_count, &made);
        if (status != MT_OK) return status;
        morph->contour_count += made;
        loom->failed[group] = made == 0;
    }
    if (loom->failed[group]) morph->contour_count = before;
    return MT_OK;
}

static size_t rings_in(const mt_loom *loom) {
    size_t rings = 0;
    for (int i = 0; i < loom->count; i++)
        rings += (size_t)loom->strands[i].in_a.count + (size_t)loom->strands[i].in_b.count;
    return rings;
}

mt_status mt_joint(mt_morph *morph, const mt_params *params, mt_arena *arena, mt_links *rest) {
    mt_loom loom = {morph, params, arena, 0, NULL, NULL};
    mt_status status = start_loom(&loom, &morph->matches);
    if (status != MT_OK) return status;
    morph->contours = mt_arena_new(arena, rings_in(&loom), sizeof(mt_masters));
    *rest = (mt_links){0, mt_arena_new(arena, (size_t)loom.count, sizeof(mt_link))};
    if (!morph->contours || !rest->links) return MT_NO_MEMORY;
    for (int group = 0; status == MT_OK && group < loom.count; group++)
        if (loom.strands[group].group == group) status = join_group(&loom, group);
    for (int i = 0; i < loom.count; i++)
        if (loom.failed[loom.strands[i].group]) rest->links[rest->count++] = loom.strands[i].match;
    return status;
}
