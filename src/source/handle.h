/* Inside a font handle: shared by the files that read fonts, and by nothing else. */
#pragma once

#include <setjmp.h>

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_MODULE_H

#include "base/memory.h"
#include "source/font.h"
#include "source/spec.h"

/* The largest font file that is read: 1 GiB, some fifty times the largest CJK collection. */
#define MT_FONT_FILE_MAX ((size_t)1 << 30)

typedef struct mt_kept mt_kept;

/* The glyph that features make of a character's own. */
typedef struct mt_form {
    uint32_t code_point, glyph;
} mt_form;

struct mt_font {
    char *text; /* the spec as it was given, or name and choice of a font in memory */
    mt_spec spec;
    uint8_t *bytes; /* the whole file: FreeType reads from here */
    size_t length;
    bool in_memory;   /* it was given as bytes: spec.path is but a name */
    mt_arena scratch; /* for what lives while a FreeType call is made */

    /* guard.c. Each font has a FreeType of its own: fonts share no state. */
    struct FT_MemoryRec_ memory;
    mt_kept *kept; /* all the blocks that FreeType has */
    jmp_buf escape;
    FT_Library library;
    FT_Face face; /* NULL when memory ran out */

    int axis_count;              /* of 'fvar'; 0 where the font does not vary */
    uint32_t axes[MT_SPEC_AXES]; /* their tags */
    int32_t place[MT_SPEC_AXES]; /* normalized, 16.16 */
    int instance_name; /* the name id of the named instance that the axes are set to; -1 when there is none */
    mt_names names;
    mt_metrics metrics;
    int units;
    int64_t modified;
    uint16_t embedding;
    bool is_symbol;
    bool without_layout;

    /* features.c: characters that lead to another glyph than in the character map; ascending. */
    int form_count;
    mt_form *forms;

    uint16_t *
        weights; /* load.c: of each glyph of a TrueType font; 0: not known. NULL until there is a composite */

    mt_composed *composed; /* composed.c */
    int composed_count, composed_room;

    /* metrics_file.c: the file beside a Type 1 font, NULL where none was looked for; and whether it could not be read. */
    char *metrics_path;
    uint8_t *metrics_bytes;
    size_t metrics_length;
    bool metrics_unread;
};

/* guard.c: does work in which FreeType may ask for memory. When it gets none the work ends there, FreeType
 * and all that it had is gone, font->face is NULL and MT_NO_MEMORY comes back. The work keeps what it
 * allocates in the handle or in an arena, never in a local variable alone. */
mt_status mt_font_guard(mt_font *font, mt_status (*work)(mt_font *font, void *user), void *user);
/* Starts the handle's FreeType; only within the guard. */
mt_status mt_font_start(mt_font *font);
/* Gives back all of FreeType's memory. */
void mt_font_discard(mt_font *font);

/* axes.c: moves a variable font to the place that the spec gives. MT_NO_AXIS, MT_BAD_AXIS, MT_NOT_A_FONT,
 * MT_NO_MEMORY. */
mt_status mt_font_set_axes(mt_font *font);
/* The user coordinate that the spec sets an axis to; false when it sets none. */
bool mt_font_axis(const mt_font *font, uint32_t tag, double *value);

/* features.c: fills font->forms by the spec's features. MT_NO_FEATURE, MT_NO_MEMORY. */
mt_status mt_font_read_features(mt_font *font);
/* The glyph that a character leads to, whose glyph in the character map is `glyph`. */
uint32_t mt_font_form(const mt_font *font, uint32_t code_point, uint32_t glyph);

/* names.c: fills font->names. MT_NO_MEMORY. */
mt_status mt_font_read_names(mt_font *font);
void mt_font_free_names(mt_font *font);

/* composed.c: the parts' outlines, moved. As mt_font_outline. */
mt_status mt_composed_outline(mt_font *font, const mt_composed *composed, mt_arena *arena,
                              mt_outline *outline);
void mt_font_free_composed(mt_font *font);

/* metrics_file.c: reads the kerning beside a Type 1 font; only within the guard. What cannot be read is left out.
 * MT_NO_MEMORY. */
mt_status mt_font_attach_metrics(mt_font *font);

/* load.c: FT_Load_Glyph, where what the glyph's references lead to is bounded; only within the guard. MT_BAD_GLYPH, MT_TOO_LARGE,
 * MT_NO_MEMORY. */
mt_status mt_font_load(mt_font *font, uint32_t glyph, FT_Int32 flags);

/* metrics.c: fills font->metrics, units, modified and embedding. */
void mt_font_read_metrics(mt_font *font);
