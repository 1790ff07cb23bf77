/* The shapes of SVG ("SVG 2", chapters 9 and 10), and attributes of elements. */
#pragma once

#include <libxml/tree.h>

#include "drawing/pen.h"

/* An attribute's value, of no namespace or of any; NULL without it. */
const char *mt_element_attribute(const xmlNode *element, const char *name);
/* A length of an attribute, in pixels; `without` where it is missing or wrong. Shares in per cent are of `whole`. */
double mt_element_length(const xmlNode *element, const char *name, double whole, double without);

bool mt_element_is_shape(const char *name);
/* Draws the element as it stands in a view of that size. Elements that are no shapes draw nothing. */
void mt_element_draw(const xmlNode *element, double width, double height, mt_pen *pen);
