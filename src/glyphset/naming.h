/* Glyphs of one font by their names, as font editors and this program's texts have them: a.sc, f_i, gid12. */
#pragma once

#include "source/font.h"

typedef struct mt_naming mt_naming;

/* Reads the names; keeps using the font. MT_NO_MEMORY. */
mt_status mt_naming_open(mt_font *font, mt_naming **naming);
void mt_naming_close(mt_naming *naming); /* NULL is fine */

/* The glyph that a name of `length` bytes stands for. The first of these that there is:
 *
 *     the font's own name for it; of several glyphs of one name, the first has it
 *     gid12               glyph number 12
 *     uni0661, u1F600     the character's glyph (Adobe Glyph List, section 2)
 *     f_i                 the ligature that text of these characters becomes, or that a substitution makes of these glyphs;
 *                         a part is a name as above, or a character itself
 *
 * MT_NO_GLYPH, MT_ENDLESS_LOOKUPS, MT_NO_MEMORY. */
mt_status mt_naming_find(mt_naming *naming, const char *name, size_t length, uint32_t *glyph);

enum { MT_GLYPH_LABEL_ROOM = 260 };

/* Writes /NAME: the glyph's own name where that finds it again in a text, otherwise its number. */
void mt_naming_label(const mt_naming *naming, uint32_t glyph, char label[MT_GLYPH_LABEL_ROOM]);
