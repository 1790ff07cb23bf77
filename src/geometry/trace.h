/* A ring read as the drawing that it came from: its corners, its lines, and the headings of its curves. */
#pragma once

#include "geometry/ring.h"

typedef struct mt_trace {
    mt_ring ring;
    double *length;  /* of edge i, from vertex i to the next, grid units */
    double *heading; /* of edge i, radians */
    double *turn;    /* at vertex i, radians, left is positive */
    bool *corner;    /* vertex i */
    bool *line;      /* edge i */
    double chord;    /* the tolerance that the curves were flattened with, grid units */
} mt_trace;

/* Reads a ring of three points or more whose curves were flattened within `chord` grid units. Corners are
 * known by their marks, and by turning more than a curve's vertex would; lines by theirs. Of an edge between
 * two crossings nothing is known; but a chord of length l whose ends turn by θ stands for an arc of height
 * about l·θ/8, which flattening keeps under its tolerance, so that an edge that would bulge by more was never
 * a chord. MT_NO_MEMORY. */
mt_status mt_trace_ring(const mt_ring *ring, double chord, mt_arena *arena, mt_trace *trace);

int mt_trace_after(const mt_trace *trace, int i);
int mt_trace_before(const mt_trace *trace, int i);

/* Whether a run of chords ends at vertex i: at a corner, or where a line begins or ends. */
bool mt_trace_breaks(const mt_trace *trace, int i);

/* Whether the drawing is smooth at vertex i and turns back there in x or in y. */
bool mt_trace_extremum(const mt_trace *trace, int i);

/* The drawing's heading out of vertex i, and into it, radians: the same at a smooth vertex, unless no curve between its chords can turn
 * so far. */
double mt_trace_out(const mt_trace *trace, int i);
double mt_trace_in(const mt_trace *trace, int i);

/* Whether lengths are not negative, turns at most π, and edges between two corners lines. Linear. */
bool mt_trace_is_valid(const mt_trace *trace);
