/* The report: every glyph of a blend measured at seventeen places, and those that an eye would stumble over named with the
 * reason: by the same score that the engine chooses morphs by (morph/check/appearance.h). docs/guide.md ("report") describes what is
 * measured and the data's schema.
 *
 *     report.c   the measuring of two fonts, on threads; sorting
 *     measure.c  the figures of one glyph
 *     judge.c    what an eye would stumble over, in numbers and in words
 *     json.c     the report as data
 *     html.c     the report as a page, with strips by strip.c
 */
#pragma once

#include "base/buffer.h"
#include "blend/making.h"
#include "glyphset/naming.h"
#include "morph/check/appearance.h"
#include "morph/check/topology.h"
#include "morphotype.h"

/* Places are T = 0, 1/16 … 1; the middle one is half-way. */
#define MT_REPORT_STEPS 17
#define MT_REPORT_HALF (MT_REPORT_STEPS / 2)

/* ---- limits ---------------------------------------------------------------------------------------------- */

/* A join is a corner when it turns by more than a smooth one does after rounding, and a slight one when it
 * turns by no more than the second figure, degrees; between curves or lines that are both at least so long,
 * thousandths of the em: shorter ones are fillets. */
#define MT_REPORT_KINK_MIN 4.0
#define MT_REPORT_KINK_MAX 30.0
#define MT_REPORT_KINK_LENGTH 4.0
/* A severity from which on an eye stumbles. */
#define MT_REPORT_STUMBLES 1.0
/* The page has strips of so many glyphs, the worst. */
#define MT_REPORT_STRIPS 1000

/* ---- figures --------------------------------------------------------------------------------------------- */

typedef enum mt_report_method {
    MT_REPORT_ALIGNED, /* moves by contours alone; a blank too */
    MT_REPORT_LINKED,  /* moves by the paper's links alone */
    MT_REPORT_BOTH,
} mt_report_method;

/* How an outline is drawn. */
typedef struct mt_report_drawing {
    int points;  /* as 'glyf' has them */
    int corners; /* joins that turn by MT_REPORT_KINK_MIN or more */
    int slight;  /* of these, those that turn by MT_REPORT_KINK_MAX or less */
} mt_report_drawing;

typedef struct mt_report_glyph {
    bool measured;    /* of a font's glyphs: it is between two glyphs, and looked at */
    mt_pairing of;    /* these glyphs, with the first character that leads here, or whose form it is */
    mt_status status; /* other than MT_OK: all that follows but flags and severity is 0 */
    mt_report_method method;
    bool proved;              /* counts are in the ends' range at every T, not only where they are measured */
    mt_reach reach;           /* how far it goes on past its ends (blend/pair.h); where that is measured */
    mt_topology ink_a, ink_b; /* as the fonts draw them */
    mt_topology ink[MT_REPORT_STEPS];
    mt_appearance seen[MT_REPORT_STEPS];                  /* of each place by itself */
    mt_report_drawing drawing_a, drawing_b, drawing_half; /* a's and b's fitted by themselves */
    unsigned flags;
    double severity; /* what an eye minds, to a hundredth: flagged from MT_REPORT_STUMBLES on */
} mt_report_glyph;

/* ---- one glyph ------------------------------------------------------------------------------------------- */

/* The figures of a prepared pair, with points counted at `units` to the em; flags and severity are left to
 * mt_report_judge. Leaves nothing in the arena. As mt_morph_outline, mt_outline_resolve and mt_outline_glyf. */
mt_status mt_report_measure(const mt_glyph_pair *pair, const mt_params *params, int units, mt_arena *arena,
                            mt_report_glyph *glyph);
/* The place of a step, 0 … MT_REPORT_STEPS - 1. */
static inline double mt_report_t(int step) {
    return (double)step / (MT_REPORT_STEPS - 1);
}

/* The corners of an outline; leaves its points as they are. */
void mt_report_count_corners(const mt_outline *outline, mt_report_drawing *drawing);

/* Sets severity and flags: mt_appearance_loss at the worst of all places, and with it each measure that it is made of. */
void mt_report_judge(mt_report_glyph *glyph);

/* Whether a place is one that makes the glyph flagged, or has counts out of the ends' range. */
bool mt_report_is_off(const mt_report_glyph *glyph, int step);
/* By severity, the worst first; equals by code point, then by number: for qsort. */
int mt_report_worst_first(const void *p, const void *q);
/* Whether all counts are in the ends' range; whether all ink is, or leaves it by MT_INK_EXCESS at most. */
bool mt_report_counts_in_range(const mt_report_glyph *glyph);
bool mt_report_ink_in_range(const mt_report_glyph *glyph);
/* The largest deviation of the ink from the straight line between the ends, relative to the larger end; with
 * its sign. */
double mt_report_ink_bend(const mt_report_glyph *glyph);
/* Slight corners half-way that neither end has as corners, slight or not: a serif that grows out of a line passes through slight ones,
 * and adds none to those of its end. */
int mt_report_kinks(const mt_report_glyph *glyph);

/* Why a glyph has a flag, in a line of English: "3 components at T = 0.5, the ends have 1 and 2". */
#define MT_REPORT_REASON_ROOM 128
void mt_report_reason(const mt_report_glyph *glyph, mt_report_flag flag, char text[MT_REPORT_REASON_ROOM]);
const char *mt_report_method_name(mt_report_method method);

/* ---- a row's glyphs -------------------------------------------------------------------------------------- */

/* What a sink (blend/making.h) measures. */
typedef struct mt_report_figures {
    bool mapped_only; /* glyphs that no character leads to are not looked at */
    bool reach;       /* how far glyphs go on past their ends is measured, too */
    int step_count, glyph_count;
    mt_report_glyph **steps; /* of each step, the new font's glyphs; all NULL until the glyphs are known */
} mt_report_figures;

/* Measures and judges each glyph that lies between two others, but for .notdef, which nobody asks for. A glyph that fails is a
 * finding, and no failure of the sink. */
mt_sink mt_report_sink(mt_report_figures *figures);
void mt_report_figures_free(mt_report_figures *figures); /* all zero is fine */

/* ---- two fonts ------------------------------------------------------------------------------------------- */

typedef struct mt_report_summary {
    int flagged, failed;
    int methods[3]; /* glyphs that did not fail, by mt_report_method */
    int proved;     /* glyphs whose counts are proved to be in the ends' range at every T */
    int in_range;   /* glyphs whose components and holes are in the ends' range at every place */
    int ink_near;   /* glyphs whose ink is within MT_INK_EXCESS of it */
} mt_report_summary;

struct mt_report {
    mt_row *row;       /* of two fonts */
    mt_naming *naming; /* of the first */
    int count;
    mt_report_glyph *glyphs; /* the worst first; equals by code point, then by number; from mt_new */
    int unblended_count;
    mt_pairing *unblended; /* without a partner, so that there is nothing to measure; from mt_new */
    mt_report_summary summary;
};

/* A count of glyphs over that of all; 1 where there are none. */
static inline double mt_report_share(const mt_report *report, int count) {
    return report->count ? (double)count / report->count : 1;
}

/* What the page has of a glyph's in-betweens: an SVG picture for each place, those that are out of the ends'
 * counts marked. As mt_morph_outline. */
mt_status mt_report_strip(const mt_glyph_pair *pair, const mt_params *params, const mt_report_glyph *glyph,
                          mt_arena *arena, mt_buffer *text);

/* The report in a buffer of the caller's. MT_NO_MEMORY. */
mt_status mt_report_add_json(const mt_report *report, mt_buffer *text);
mt_status mt_report_add_html(const mt_report *report, mt_buffer *text);

/* The format that a file name's extension asks for, in either case. MT_UNKNOWN_FORMAT. */
mt_status mt_report_format_of(const char *path, mt_report_format *format);
