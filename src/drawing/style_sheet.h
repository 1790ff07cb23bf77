/* Style sheets of a drawing: rules for all elements of a name, a class or an id ("CSS 2.1", chapter 5), as drawing programs write them. */
#pragma once

#include <libxml/tree.h>

#include "base/memory.h"
#include "drawing/style.h"

/* Rules and their selectors, of all sheets together. */
#define MT_STYLE_RULES_MAX 1024

typedef struct mt_style_rule {
    char kind;        /* '.', '#', or 0 for the name of an element; '*' for any */
    const char *name; /* without that; "" for any */
    const char *declarations;
} mt_style_rule;

typedef struct mt_style_sheet {
    int count, room;
    mt_style_rule *rules; /* in their order */
    bool whole;           /* no rule was left out */
} mt_style_sheet;

/* Adds the rules of a sheet's text, in the arena. Those that select by anything else, and those after an @, are left out. MT_TOO_LARGE
 * for more than MT_STYLE_RULES_MAX, MT_NO_MEMORY. */
mt_status mt_style_sheet_add(const char *text, mt_arena *arena, mt_style_sheet *sheet);

/* Sets what the rules say of the element: those of names, then of classes, then of ids. */
void mt_style_sheet_apply(const mt_style_sheet *sheet, const xmlNode *element, mt_style *style);
