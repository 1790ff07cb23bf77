/* A family: fonts that each stand at a place of their own on the axis, and the italics among them, which are a font of their own. */
#pragma once

#include "options.h"

/* One variable font each, of the uprights and of the italics; where there is but one of these, that. */
typedef struct family {
    int count;
    cli_options list
        [2]; /* of the fonts that each has, by their places, with these and the output; they share the rest */
    double stops[2][MT_VARIABLE_FONTS_MAX];
    char *italic_output; /* from mt_new */
} family;

/* Finds where each font stands, and which are italic. DONE or, said, COULD_NOT or WRONG_USAGE; either way the family is to be
 * freed. It refers to the options. */
int family_read(const cli_options *options, family *made);
void family_free(family *made);
