/* Inside a variable font in the making: shared by the files that make it, and by nothing else.
 *
 * The axis has a stop for each font, evenly spaced. Between two stops a blend of the two fonts has each glyph as contours that
 * move. Contours of neighbouring steps need not be compatible: a glyph has those of all steps, and those of a step that is not
 * at hand are collapsed to a point. Since the axis has whole places (MT_PLACE_ONE of them), a step's contours go at one place
 * and the next step's are there at the next, with nothing in between. */
#ifndef MT_BLEND_VARIABLE_JOB_H
#define MT_BLEND_VARIABLE_JOB_H

#include "blend/job.h"
#include "glyphset/charset_row.h"
#include "sfnt/axis_map.h"

struct mt_variable {
    int count; /* of the fonts */
    mt_font **fonts;
    mt_blend **steps; /* the blends of neighbours, all with the same settings: count - 1 of them */
    mt_axis_map map;
    mt_progress progress;
    void *progress_user;
};

/* What a variable font is made from. */
typedef struct mt_course {
    int units, glyph_count;
    int step_count;
    mt_job *jobs; /* of each step */
    int *stops;   /* the places of the fonts: step_count + 1 of them */
    mt_charset_row charsets;
    mt_positions *positions; /* of all fonts */
} mt_course;

/* variable_join.c: a glyph of all steps, in the arena. MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_course_join(const mt_course *course, int glyph, mt_arena *arena, mt_glyf *glyf,
                         mt_glyph_moves *moves);

/* variable_masters.c: which step a place is on, and its T there; a stop belongs to the step that ends there. */
typedef struct mt_spot {
    int step;
    double t;
} mt_spot;
mt_spot mt_course_spot(const mt_course *course, int place);
/* Gives `made` the room in the line that the glyph takes at a place. */
void mt_glyph_room_at(const mt_glyf *glyph, const mt_glyph_moves *moves, int place, mt_glyf *made);
/* Hands over the masters of the font, each with its place as the index. MT_NO_MEMORY, and what `ready` gives. */
mt_status mt_course_masters(const mt_course *course, const mt_font_data *font, mt_font_ready ready,
                            void *user);

/* variable_layout.c: what of the font is not outlines, each with how it varies: positions, widths, heights and figures of the
 * whole font. MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_course_layout(const mt_course *course, mt_arena *arena, mt_font_data *data);

/* variable_composite.c: leaves those composites of the steps that are built alike in all fonts. MT_NO_MEMORY. */
mt_status mt_course_composites(const mt_course *course, mt_arena *arena);
/* Of a composite, where its references are at each stop. MT_TOO_LARGE. */
mt_status mt_course_reference(const mt_course *course, int glyph, int reference, int stop, mt_move *offset);
/* Tells which composites have parts that may overlap, and makes those blank whose parts all are. MT_NO_MEMORY. */
mt_status mt_course_overlaps(const mt_course *course, mt_glyf *glyphs, mt_glyph_moves *moves,
                             mt_arena *arena);

#endif
