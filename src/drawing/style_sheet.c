#include "drawing/style_sheet.h"

#include <ctype.h>
#include <string.h>

#include "drawing/element.h"

/* A copy of the text without comments. */
static char *without_comments(const char *text, mt_arena *arena) {
    char *copy = mt_arena_new(arena, strlen(text) + 1, 1), *to = copy;
    if (!copy) return NULL;
    while (*text) {
        if (strncmp(text, "/*", 2) != 0) {
            *to++ = *text++;
            continue;
        }
        const char *end = strstr(text + 2, "*/");
        text = end ? end + 2 : text + strlen(text);
    }
    *to = '\0';
    return copy;
}

static bool is_name(const char *text) {
    if (!*text) return false;
    for (; *text; text++)
        if (!isalnum((unsigned char)*text) && *text != '-' && *text != '_' && !((unsigned char)*text & 0x80))
            return false;
    return true;
}

/* Cuts the text down to what stands between blanks. */
static char *trim(char *text) {
    while (isspace((unsigned char)*text)) text++;
    size_t length = strlen(text);
    while (length > 0 && isspace((unsigned char)text[length - 1])) text[--length] = '\0';
    return text;
}

static mt_status add_selector(char *selector, const char *declarations, mt_arena *arena,
                              mt_style_sheet *sheet) {
    char kind = *selector == '.' || *selector == '#' || strcmp(selector, "*") == 0 ? *selector : '\0';
    const char *name = kind ? selector + 1 : selector;
    if (kind != '*' && !is_name(name)) {
        sheet->whole = false;
        return MT_OK;
    }
    if (sheet->count == MT_STYLE_RULES_MAX) return MT_TOO_LARGE;
    mt_style_rule *grown = mt_arena_grow_list(arena, sheet->rules, sheet->count, &sheet->room, sizeof *grown);
    if (!grown) return MT_NO_MEMORY;
    sheet->rules = grown;
    grown[sheet->count++] = (mt_style_rule){kind, name, declarations};
    return MT_OK;
}

/* One rule: selectors with commas between them, which are cut in place. */
static mt_status add_rule(char *selectors, const char *declarations, mt_arena *arena, mt_style_sheet *sheet) {
    mt_status status = MT_OK;
    while (selectors && status == MT_OK) {
        char *comma = strchr(selectors, ',');
        if (comma) *comma = '\0';
        status = add_selector(trim(selectors), declarations, arena, sheet);
        selectors = comma ? comma + 1 : NULL;
    }
    return status;
}

/* Past a block { … } with blocks in it; the text's end where it has none. */
static char *pass_block(char *at) {
    int depth = 0;
    for (at += strcspn(at, "{;"); *at; at++) {
        depth += (*at == '{') - (*at == '}');
        if (depth <= 0) return at + 1;
    }
    return at;
}

mt_status mt_style_sheet_add(const char *text, mt_arena *arena, mt_style_sheet *sheet) {
    char *at = without_comments(text, arena);
    mt_status status = at ? MT_OK : MT_NO_MEMORY;
    while (status == MT_OK && *(at += strspn(at, " \t\r\n\f"))) {
        char *open = strchr(at, '{'), *close = open ? strchr(open, '}') : NULL;
        if (*at == '@') {
            sheet->whole = false;
            at = pass_block(at);
            continue;
        }
        if (!close) break;
        *open = *close = '\0';
        status = add_rule(at, open + 1, arena, sheet);
        at = close + 1;
    }
    return status;
}

/* Whether the word is among those of the list, with blanks between them. */
static bool has_word(const char *list, const char *word) {
    size_t length = strlen(word);
    while (list && *(list += strspn(list, " \t\r\n\f"))) {
        size_t own = strcspn(list, " \t\r\n\f");
        if (own == length && strncmp(list, word, length) == 0) return true;
        list += own;
    }
    return false;
}

static bool selects(const mt_style_rule *rule, const xmlNode *element) {
    const char *id;
    switch (rule->kind) {
    case '*': return true;
    case '.': return has_word(mt_element_attribute(element, "class"), rule->name);
    case '#': id = mt_element_attribute(element, "id"); return id && strcmp(id, rule->name) == 0;
    default: return strcmp((const char *)element->name, rule->name) == 0;
    }
}

void mt_style_sheet_apply(const mt_style_sheet *sheet, const xmlNode *element, mt_style *style) {
    static const char order[] = {'*', '\0', '.', '#'};
    for (size_t k = 0; k < sizeof order; k++)
        for (int i = 0; i < sheet->count; i++)
            if (sheet->rules[i].kind == order[k] && selects(&sheet->rules[i], element))
                mt_style_set_all(style, sheet->rules[i].declarations);
}
