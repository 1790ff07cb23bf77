/* Texts that spell what a GSUB's ligatures and contexts ask for (OpenType spec, "Sequence context" and "Chained sequence
 * context", formats 1, 2 and 3). Where a context takes one glyph of several, as many texts are made as the largest of its
 * sets has glyphs: the i-th text takes the i-th of each. */
#include "glyphset/texts.h"

#include "glyphset/spelling.h"
#include "layout/ot.h"

enum { CHOICES_MAX = 32, CLASSES_MAX = 256, TEXTS_MAX = 40000 };

/* The glyphs that may stand at one place of a context: those that can be spelled. */
typedef struct mt_rule_choice {
    int count;
    uint16_t glyphs[CHOICES_MAX];
} mt_rule_choice;

/* The places of a context in the order of the text. */
typedef struct mt_context {
    int count;
    bool failed; /* longer than a text may be */
    mt_rule_choice places[MT_SPELLING_MAX];
} mt_context;

enum { BEFORE, INPUT, AFTER, PARTS };

typedef struct mt_rule_reader {
    const mt_texts *texts;
    const mt_spellings *spellings;
    mt_arena *arena;
    mt_bytes table;                 /* the subtable */
    mt_rule_choice *classes[PARTS]; /* of format 2; NULL for others */
    bool chained;
    int64_t left; /* of the texts and rules */
} mt_rule_reader;

/* ---- places -------------------------------------------------------------------------------------------- */

static void choose(const mt_rule_reader *reader, uint32_t glyph, mt_rule_choice *choice) {
    bool spelled = glyph < (uint32_t)reader->spellings->glyph_count && reader->spellings->of[glyph].count;
    if (spelled && choice->count < CHOICES_MAX) choice->glyphs[choice->count++] = (uint16_t)glyph;
}

static mt_rule_choice *add_place(mt_context *context) {
    context->failed |= context->count == MT_SPELLING_MAX;
    if (context->failed) return NULL;
    mt_rule_choice *place = &context->places[context->count++];
    place->count = 0;
    return place;
}

/* A glyph of format 1, or a class of format 2. */
static void add_value(const mt_rule_reader *reader, mt_context *context, int part, unsigned value) {
    mt_rule_choice *place = add_place(context);
    if (!place) return;
    if (!reader->classes[part])
        choose(reader, value, place);
    else if (value < CLASSES_MAX)
        *place = reader->classes[part][value];
}

/* The `count` values at `at`; what comes before stands from the nearest to the farthest. */
static void add_values(const mt_rule_reader *reader, mt_context *context, int part, mt_bytes rule, size_t at,
                       int count) {
    for (int i = 0; i < count && !context->failed; i++) {
        int k = part == BEFORE ? count - 1 - i : i;
        add_value(reader, context, part, mt_ot_u16(rule, at + 2 * (size_t)k));
    }
}

static mt_status add_coverages(const mt_rule_reader *reader, mt_context *context, int part, size_t at,
                               int count) {
    mt_status status = MT_OK;
    for (int i = 0; i < count && !context->failed && status == MT_OK; i++) {
        int k = part == BEFORE ? count - 1 - i : i, covered_count;
        mt_covered *covered;
        mt_arena_place before = mt_arena_mark(reader->arena);
        mt_rule_choice *place = add_place(context);
        if (!place) return MT_OK;
        status = mt_coverage_list(mt_ot_follow(reader->table, at + 2 * (size_t)k), reader->arena, &covered,
                                  &covered_count);
        for (int g = 0; status == MT_OK && g < covered_count; g++) choose(reader, covered[g].glyph, place);
        mt_arena_rewind(reader->arena, before);
    }
    return status;
}

/* ---- texts --------------------------------------------------------------------------------------------- */

static void spell_context(mt_rule_reader *reader, const mt_context *context) {
    const mt_texts *texts = reader->texts;
    int most = 0;
    reader->left--;
    for (int i = 0; i < context->count; i++) {
        if (!context->places[i].count) return;
        if (context->places[i].count > most) most = context->places[i].count;
    }
    for (int k = 0; k < most && !context->failed && reader->left > 0; k++, reader->left--) {
        uint32_t text[MT_SPELLING_MAX];
        int length = 0;
        bool fits = true;
        for (int i = 0; i < context->count && fits; i++) {
            const mt_rule_choice *place = &context->places[i];
            fits = mt_spell_append(reader->spellings, place->glyphs[k % place->count], text, &length);
        }
        if (fits) mt_votes_add(texts->votes, text, length);
    }
}

/* ---- rules --------------------------------------------------------------------------------------------- */

/* SequenceRule or ChainedSequenceRule; its first glyph or class is `first`. */
static void read_rule(mt_rule_reader *reader, mt_bytes rule, unsigned first) {
    mt_context context = {0};
    size_t at = 0;
    if (reader->chained) {
        int before = mt_ot_fit(rule, 2, mt_ot_u16(rule, 0), 2);
        add_values(reader, &context, BEFORE, rule, 2, before);
        at = 2 + 2 * (size_t)before;
    }
    int more = (int)mt_ot_u16(rule, at) - 1;
    size_t input = at + (reader->chained ? 2 : 4);
    more = mt_ot_fit(rule, input, more > 0 ? (unsigned)more : 0, 2);
    add_value(reader, &context, INPUT, first);
    add_values(reader, &context, INPUT, rule, input, more);
    at = input + 2 * (size_t)more;
    if (reader->chained)
        add_values(reader, &context, AFTER, rule, at + 2, mt_ot_fit(rule, at + 2, mt_ot_u16(rule, at), 2));
    spell_context(reader, &context);
}

static void read_set(mt_rule_reader *reader, mt_bytes set, unsigned first) {
    int rules = mt_ot_fit(set, 2, mt_ot_u16(set, 0), 2);
    for (int i = 0; i < rules && reader->left > 0; i++)
        read_rule(reader, mt_ot_follow(set, 2 + 2 * (size_t)i), first);
}

/* Format 1: a set for each covered glyph. */
static mt_status read_glyphs(mt_rule_reader *reader) {
    mt_covered *covered;
    int count;
    unsigned sets = mt_ot_u16(reader->table, 4);
    mt_status status = mt_coverage_list(mt_ot_follow(reader->table, 2), reader->arena, &covered, &count);
    for (int i = 0; status == MT_OK && i < count && reader->left > 0; i++)
        if (covered[i].index < sets)
            read_set(reader, mt_ot_follow(reader->table, 6 + 2 * (size_t)covered[i].index), covered[i].glyph);
    return status;
}

static mt_status list_classes(mt_rule_reader *reader, int part, size_t at) {
    mt_bytes definition = mt_ot_follow(reader->table, at);
    mt_rule_choice *classes = mt_arena_new(reader->arena, CLASSES_MAX, sizeof *classes);
    if (!classes) return MT_NO_MEMORY;
    for (int i = 0; i < reader->spellings->glyph_count; i++) {
        if (!reader->spellings->of[i].count) continue;
        unsigned class = mt_class_find(definition, (uint32_t)i);
        if (class < CLASSES_MAX) choose(reader, (uint32_t)i, &classes[class]);
    }
    reader->classes[part] = classes;
    return MT_OK;
}

/* Format 2: a set for each class of the first glyph. */
static mt_status read_classes(mt_rule_reader *reader) {
    size_t input = reader->chained ? 6 : 4, sets_at = reader->chained ? 10 : 6;
    mt_status status = list_classes(reader, INPUT, input);
    if (status == MT_OK && reader->chained) status = list_classes(reader, BEFORE, 4);
    if (status == MT_OK && reader->chained) status = list_classes(reader, AFTER, 8);
    int sets = mt_ot_fit(reader->table, sets_at + 2, mt_ot_u16(reader->table, sets_at), 2);
    for (int i = 0; status == MT_OK && i < sets && reader->left > 0; i++)
        read_set(reader, mt_ot_follow(reader->table, sets_at + 2 + 2 * (size_t)i), (unsigned)i);
    return status;
}

/* Format 3: one rule, of coverages. */
static mt_status read_coverages(mt_rule_reader *reader) {
    mt_context context = {0};
    mt_status status = MT_OK;
    size_t at = 2;
    int first = reader->chained ? BEFORE : INPUT, last = reader->chained ? AFTER : INPUT;
    for (int part = first; part <= last && status == MT_OK; part++) {
        size_t list = reader->chained ? at + 2 : 6;
        int count = mt_ot_fit(reader->table, list, mt_ot_u16(reader->table, at), 2);
        status = add_coverages(reader, &context, part, list, count);
        at = list + 2 * (size_t)count;
    }
    if (status == MT_OK) spell_context(reader, &context);
    return status;
}

static mt_status read_context(mt_rule_reader *reader, int type, mt_bytes table) {
    mt_arena_place before = mt_arena_mark(reader->arena);
    mt_status status = MT_OK;
    reader->table = table;
    reader->chained = type == MT_GSUB_CHAIN;
    for (int i = 0; i < PARTS; i++) reader->classes[i] = NULL;
    switch (mt_ot_u16(table, 0)) {
    case 1: status = read_glyphs(reader); break;
    case 2: status = read_classes(reader); break;
    case 3: status = read_coverages(reader); break;
    default: break;
    }
    mt_arena_rewind(reader->arena, before);
    return status;
}

/* ---- lookups ------------------------------------------------------------------------------------------- */

static void read_ligatures(mt_rule_reader *reader, const mt_gsub_subtable *subtable) {
    const mt_texts *texts = reader->texts;
    for (int i = 0; i < subtable->count && reader->left > 0; i++, reader->left--) {
        const mt_substitution *ligature = &subtable->list[i];
        uint32_t text[MT_SPELLING_MAX];
        int length = 0;
        bool fits = true;
        for (int k = 0; k < ligature->inputs && fits; k++)
            fits = mt_spell_append(reader->spellings, ligature->glyphs[k], text, &length);
        if (fits) mt_votes_add(texts->votes, text, length);
    }
}

mt_status mt_texts_of_rules(const mt_texts *texts, const mt_gsub *gsub, mt_arena *arena) {
    mt_spellings spellings;
    mt_rule_reader reader = {.texts = texts, .spellings = &spellings, .arena = arena, .left = TEXTS_MAX};
    mt_status status = mt_spell(texts->votes->a->font, gsub, texts->chars, texts->count, arena, &spellings);
    for (int i = 0; status == MT_OK && i < gsub->layout.lookup_count; i++) {
        const mt_gsub_lookup *lookup = &gsub->lookups[i];
        bool context = lookup->type == MT_GSUB_CONTEXT || lookup->type == MT_GSUB_CHAIN;
        for (int k = 0; k < lookup->subtable_count && status == MT_OK && reader.left > 0; k++) {
            if (lookup->type == MT_GSUB_LIGATURE)
                read_ligatures(&reader, &lookup->subtables[k]);
            else if (context)
                status = read_context(&reader, lookup->type, lookup->subtables[k].table);
        }
    }
    return status;
}
