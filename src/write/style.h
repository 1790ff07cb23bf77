/* What the name of a style says: its weight, width and slope, and how old applications link it.
 *
 * A family of these has four styles: Regular, Bold, Italic and Bold Italic. The last words of a style that are one of these
 * link it; what stands before them makes a family of its own, FAMILY SEMIBOLD with Regular and Italic (OpenType spec, "name":
 * name IDs 1, 2, 16 and 17). */
#pragma once

#include <stdbool.h>
#include <stddef.h>

typedef struct mt_style {
    int weight;     /* OS/2 usWeightClass, 100 … 1000; 0: the name says nothing of it */
    int width;      /* OS/2 usWidthClass, 1 … 9; 0: nothing */
    bool is_linked; /* the name says how it is linked: it has a word of a weight or of a slope */
    bool bold, italic;
    size_t own; /* how many bytes of the name stand before the words that link it, without the last blank */
} mt_style;

/* Words are told apart by blanks and hyphens, capitals do not count, and Semi, Demi, Extra and Ultra may stand by themselves
 * before the word that they belong to. A style that has no word of a weight, but one of a width or slope, is of weight
 * 400. */
mt_style mt_style_read(const char *name);

/* Writes the name without the words of its slope; "" where that is all of it. `upright` has room for the name. */
void mt_style_drop_slope(const char *name, char *upright);
