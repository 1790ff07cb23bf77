/* Texts of scripts. What may stand at one place of a text is a slot; a template is a row of slots, one letter each:
 *
 *     L letter   M mark   V virama   R the letter ra   Z zero width joiner   K S the kinzi's letter and sign
 *     A B C      jamo: leading, vowel, trailing
 *
 * A template is gone through in steps that share no factor with the slots' sizes: so every member of every slot comes up as
 * often as the others when not all of the product is shaped. */
#include "glyphset/texts.h"

#include <hb-ot.h>
#include <stdlib.h>
#include <string.h>

enum { SLOTS_MAX = 6, TEXTS_MAX = 6000, ZWJ = 0x200D };

typedef struct mt_slot {
    int count;
    const uint32_t *codes;
} mt_slot;

/* ---- templates ----------------------------------------------------------------------------------------- */

static int64_t common_factor(int64_t x, int64_t y) {
    while (y) {
        int64_t rest = x % y;
        x = y;
        y = rest;
    }
    return x;
}

static void add_product(const mt_texts *texts, const mt_slot *slots, int count) {
    int64_t all = 1, sizes = 1;
    uint32_t codes[SLOTS_MAX];
    for (int i = 0; i < count; i++) all *= slots[i].count < 1024 ? slots[i].count : 1024;
    sizes = all;
    int64_t step = all / TEXTS_MAX + 1;
    while (step > 1 && common_factor(step, sizes) > 1) step++;
    for (int64_t k = 0; k < all; k += step) {
        int64_t rest = k;
        for (int i = 0; i < count; i++) {
            int size = slots[i].count < 1024 ? slots[i].count : 1024;
            codes[i] = slots[i].codes[rest % size];
            rest /= size;
        }
        mt_votes_add(texts->votes, codes, count);
    }
}

/* The characters of one script, and the slots made of them. */
typedef struct mt_script_slots {
    mt_slot of[26]; /* by the template's letter */
} mt_script_slots;

static void add_templates(const mt_texts *texts, const mt_script_slots *slots, const char *const *templates) {
    for (; *templates; templates++) {
        mt_slot row[SLOTS_MAX];
        int count = (int)strlen(*templates);
        for (int i = 0; i < count; i++) row[i] = slots->of[(*templates)[i] - 'A'];
        add_product(texts, row, count);
    }
}

/* ---- characters by script ------------------------------------------------------------------------------ */

typedef struct mt_slot_char {
    hb_script_t script;
    char slot; /* 'L', 'M', 'V', or a jamo's */
    uint32_t code;
} mt_slot_char;

static int by_slot(const void *p, const void *q) {
    const mt_slot_char *x = p, *y = q;
    if (x->script != y->script) return x->script < y->script ? -1 : 1;
    if (x->slot != y->slot) return x->slot < y->slot ? -1 : 1;
    return (x->code > y->code) - (x->code < y->code);
}

/* Marks that several scripts have are taken for those of the script whose block they are in. */
static hb_script_t script_of(uint32_t code) {
    hb_script_t script = hb_unicode_script(hb_unicode_funcs_get_default(), code);
    if (script != HB_SCRIPT_INHERITED) return script;
    if (code >= 0x0600 && code < 0x0700) return HB_SCRIPT_ARABIC;
    if (code >= 0x0900 && code < 0x0980) return HB_SCRIPT_DEVANAGARI;
    return HB_SCRIPT_LATIN;
}

static char jamo_of(uint32_t code) {
    if ((code >= 0x1100 && code < 0x1160) || (code >= 0xA960 && code < 0xA980)) return 'A';
    if ((code >= 0x1160 && code < 0x11A8) || (code >= 0xD7B0 && code < 0xD7C7)) return 'B';
    return (code >= 0x11A8 && code < 0x1200) || (code >= 0xD7CB && code < 0xD7FC) ? 'C' : 0;
}

/* 0 for what is in no slot. */
static char slot_of(uint32_t code, hb_script_t script) {
    if (script == HB_SCRIPT_HANGUL) return jamo_of(code);
    switch (hb_unicode_general_category(hb_unicode_funcs_get_default(), code)) {
    case HB_UNICODE_GENERAL_CATEGORY_LOWERCASE_LETTER:
    case HB_UNICODE_GENERAL_CATEGORY_MODIFIER_LETTER:
    case HB_UNICODE_GENERAL_CATEGORY_OTHER_LETTER:
    case HB_UNICODE_GENERAL_CATEGORY_TITLECASE_LETTER:
    case HB_UNICODE_GENERAL_CATEGORY_UPPERCASE_LETTER: return 'L';
    case HB_UNICODE_GENERAL_CATEGORY_NON_SPACING_MARK:
    case HB_UNICODE_GENERAL_CATEGORY_SPACING_MARK:
    case HB_UNICODE_GENERAL_CATEGORY_ENCLOSING_MARK:
        return hb_unicode_combining_class(hb_unicode_funcs_get_default(), code) == 9 ? 'V' : 'M';
    default: return 0;
    }
}

static bool has_system(const mt_gsub *gsub, hb_script_t script) {
    hb_tag_t tags[HB_OT_MAX_TAGS_PER_SCRIPT];
    unsigned count = HB_OT_MAX_TAGS_PER_SCRIPT;
    hb_ot_tags_from_script_and_language(script, HB_LANGUAGE_INVALID, &count, tags, NULL, NULL);
    for (unsigned i = 0; i < count; i++)
        for (int k = 0; k < gsub->layout.system_count; k++)
            if (gsub->layout.systems[k].script == tags[i]) return true;
    return false;
}

/* Neither letters that join nor conjuncts. */
static bool is_plain(hb_script_t script) {
    return script == HB_SCRIPT_LATIN || script == HB_SCRIPT_GREEK || script == HB_SCRIPT_CYRILLIC;
}

static bool has_templates(hb_script_t script, const mt_gsub *gsub_a, const mt_gsub *gsub_b) {
    if (script == HB_SCRIPT_COMMON || script == HB_SCRIPT_HAN || script == HB_SCRIPT_UNKNOWN) return false;
    return script == HB_SCRIPT_ARABIC || has_system(gsub_a, script) || has_system(gsub_b, script);
}

static mt_status list_members(const mt_texts *texts, const mt_gsub *gsub_a, const mt_gsub *gsub_b,
                              mt_arena *arena, mt_slot_char **members, int *count) {
    mt_slot_char *list = mt_arena_new(arena, (size_t)texts->count + 1, sizeof *list);
    *count = 0;
    if (!list) return MT_NO_MEMORY;
    hb_script_t script = HB_SCRIPT_INVALID;
    bool wanted = false;
    for (int i = 0; i < texts->count; i++) {
        uint32_t code = texts->chars[i];
        hb_script_t now = script_of(code);
        if (now != script) wanted = has_templates(now, gsub_a, gsub_b);
        script = now;
        char slot = wanted ? slot_of(code, script) : 0;
        if (slot) list[(*count)++] = (mt_slot_char){script, slot, code};
    }
    if (*count) qsort(list, (size_t)*count, sizeof *list, by_slot);
    *members = list;
    return MT_OK;
}

/* ---- the scripts --------------------------------------------------------------------------------------- */

/* The blocks from Devanagari to Malayalam have ra at the same place. */
static uint32_t letter_ra(uint32_t first) {
    return first >= 0x0900 && first < 0x0D80 ? (first & ~0x7Fu) + 0x30 : 0;
}

/* `codes` are the members' characters, in their order. */
static void add_script(const mt_texts *texts, const mt_slot_char *members, const uint32_t *codes, int count) {
    static const char *const plain[] = {"LM", "LMM", NULL};
    static const char *const jamo[] = {"AB", "ABC", NULL};
    static const char *const joined[] = {"ZL",  "LZ",   "ZLZ",  "LL",    "ZLL",  "LLZ",   "ZLLZ",
                                         "LM",  "LMM",  "ZLM",  "LMZ",   "ZLMZ", "LML",   "LV",
                                         "LVZ", "LVL",  "LVLM", "RVL",   "RVLM", "RVLMM", "RVLVL",
                                         "LVR", "LVRM", "LMVL", "LVLVL", "KSVL", "KSVLM", NULL};
    static const uint32_t fixed[] = {ZWJ, 0x1004, 0x103A};
    const hb_script_t script = members[0].script;
    const uint32_t ra = letter_ra(codes[count - 1]);
    mt_script_slots slots = {0};
    for (int i = 0; i < count; i++) {
        mt_slot *slot = &slots.of[members[i].slot - 'A'];
        if (!slot->count++) slot->codes = &codes[i];
    }
    slots.of['Z' - 'A'] = (mt_slot){1, &fixed[0]};
    slots.of['R' - 'A'] = (mt_slot){ra != 0, &ra};
    slots.of['K' - 'A'] = (mt_slot){script == HB_SCRIPT_MYANMAR, &fixed[1]};
    slots.of['S' - 'A'] = (mt_slot){script == HB_SCRIPT_MYANMAR, &fixed[2]};
    add_templates(texts, &slots, script == HB_SCRIPT_HANGUL ? jamo : is_plain(script) ? plain : joined);
}

mt_status mt_texts_of_scripts(const mt_texts *texts, const mt_gsub *gsub_a, const mt_gsub *gsub_b,
                              mt_arena *arena) {
    mt_slot_char *members;
    int count;
    mt_status status = list_members(texts, gsub_a, gsub_b, arena, &members, &count);
    uint32_t *codes = status == MT_OK ? mt_arena_new(arena, (size_t)count + 1, sizeof *codes) : NULL;
    if (!codes) return MT_NO_MEMORY;
    for (int i = 0; i < texts->count; i++) mt_votes_add(texts->votes, &texts->chars[i], 1);
    for (int i = 0; i < count; i++) codes[i] = members[i].code;
    for (int i = 0, end; i < count; i = end) {
        for (end = i + 1; end < count && members[end].script == members[i].script;) end++;
        add_script(texts, members + i, codes + i, end - i);
    }
    return MT_OK;
}
