/* Affine maps of SVG (W3C, "SVG 2", chapter 8, and "CSS Transforms Level 1", section 8). */
#pragma once

#include "geometry/point.h"

/* x' = a x + c y + e, y' = b x + d y + f */
typedef struct mt_affine {
    double a, b, c, d, e, f;
} mt_affine;

mt_vector mt_affine_apply(const mt_affine *map, double x, double y);
/* The inner map first. */
mt_affine mt_affine_after(const mt_affine *outer, const mt_affine *inner);

/* An attribute transform: matrix, translate, scale, rotate, skewX and skewY in a list. False for anything else. */
bool mt_transform_read(const char *text, mt_affine *map);

typedef struct mt_view {
    double x, y, width, height;
} mt_view;

/* An attribute viewBox, whose sides are above 0; false for anything else. */
bool mt_view_read(const char *text, mt_view *view);
/* What puts `inner` into the middle of `outer` as large as fits (preserveAspectRatio's default), or stretched to it. */
mt_affine mt_view_map(const mt_view *outer, const mt_view *inner, bool stretched);
