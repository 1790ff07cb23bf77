/* A font as Unified Font Object 3 (unifiedfontobject.org), for designers to go on with in their editor. */
#pragma once

#include "base/folder.h"
#include "write/font_data.h"

/* The file that every UFO has. */
#define MT_UFO_MARK "metainfo.plist"

/* Fills an empty folder with the font's glyphs, information and glyph order. Outlines are as 'glyf' has them, outer contours clockwise: quadratic, points
 * on the curve left implied; or cubic, each curve that quadratic one with its controls in whole units. MT_BAD_PARAMETER and MT_TOO_LARGE as for mt_font_write,
 * MT_NO_MEMORY, MT_CANNOT_WRITE (errno says why). *unsaid is raised to the rules, lookups and features that its features.fea cannot say. */
mt_status mt_ufo_write(const mt_font_data *data, mt_folder *folder, int *unsaid);
