/* A font's GSUB, GPOS and GDEF as text (Adobe, "OpenType Feature File Specification"), for editors and compilers to go on with.
 *
 * What such sources keep elsewhere is left to them: kerning pairs of Latin text (groups.plist, kerning.plist), and attachment of
 * marks and of cursive lines, which becomes anchors of the glyphs. In their places the text has empty features with the comment
 * "Automatic Code", where compilers (ufo2ft) put what they make of these. */
#pragma once

#include "base/buffer.h"
#include "base/memory.h"
#include "sfnt/sfnt.h"

typedef struct mt_fea_source {
    mt_bytes gsub, gpos, gdef; /* of version 1; empty where the font has none */
    int glyph_count;
    const char *const
        *names; /* of all glyphs: letters, digits, dots and underscores, the first of them no digit */
    int place;  /* on the only axis (axis.h), where GPOS varies */
    bool kerns; /* pairs are told elsewhere */
} mt_fea_source;

enum { MT_FEA_ANCHOR_ROOM = 24 };

/* "mark001" of a base, "mark001_2" of a ligature's second part, "_mark001" of the mark that goes there; "mkmk…" where marks bear
 * marks; "entry" and "exit". */
typedef struct mt_fea_anchor {
    uint16_t glyph;
    char name[MT_FEA_ANCHOR_ROOM];
    int x, y;
} mt_fea_anchor;

/* The same lookups, classes and anchors at every place of an axis. */
typedef struct mt_fea {
    mt_buffer text; /* the caller's to free */
    int anchor_count;
    mt_fea_anchor *anchors; /* by glyph; in the arena */
    int unsaid;             /* lookups and features that text cannot say, and are left out */
} mt_fea;

/* MT_NO_MEMORY; MT_ENDLESS_LOOKUPS; MT_TOO_LARGE for more than any font has. */
mt_status mt_fea_make(const mt_fea_source *source, mt_arena *arena, mt_fea *fea);
