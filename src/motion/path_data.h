/* Contours as SVG's path data (W3C, "SVG 2", 9.3), relative to the canvas. */
#pragma once

#include "base/buffer.h"
#include "motion/motion.h"

/* Units of an animation's path data: so many an em, whole numbers. */
#define MT_PATH_EM 4000

/* Adds the drawing: m, then l and q, then z for each contour, all with numbers relative to the point before. Drawings with as many
 * contours of the same degrees have the same commands. Cubic curves are not among them. MT_NO_MEMORY. */
mt_status mt_path_data_add(const mt_drawing *drawing, const mt_page *page, mt_buffer *data);

/* The sides of the canvas in those units. */
double mt_path_width(const mt_page *page);
double mt_path_height(const mt_page *page);
