/* PostScript names: FAMILY-STYLE in ASCII, of at most 63 bytes (OpenType spec, "name": name ID 6).
 *
 * Blanks and what PostScript keeps for itself are left out. Letters with accents lose them, and letters of Latin, Greek and
 * Cyrillic that ASCII has not are written with those it has: é as e, ß as ss, ж as zh. Any other character beyond ASCII is u
 * and its hexadecimal code point, so that names in any script stay apart. */
#pragma once

enum { MT_POSTSCRIPT_NAME_ROOM = 64 };

/* FAMILY-STYLE, the family cut short where both do not fit. */
void mt_postscript_name(const char *family, const char *style, char name[MT_POSTSCRIPT_NAME_ROOM]);

/* What the names of a variable font's places begin with: the family alone, of letters and digits (name ID 25). */
void mt_postscript_prefix(const char *family, char name[MT_POSTSCRIPT_NAME_ROOM]);

/* PREFIX-PLACE: of a named place of a variable font. */
void mt_postscript_place_name(const char *family, const char *place, char name[MT_POSTSCRIPT_NAME_ROOM]);
