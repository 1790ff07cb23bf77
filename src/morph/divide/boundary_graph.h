/* The boundary of a shape as a graph, onto which the rings of the other glyph are matched: along the rings from sample to sample,
 * across the ink over chords, and across white over jumps. */
#pragma once

#include "geometry/triangulate.h"
#include "morph/align/align.h"

/* The longest chords of a division and of slits, 1/1000 em: the strokes of black faces are some 250 wide. */
#define MT_CHORD_REACH 300.0

/* An edge of the graph across the ink, in one direction: a diagonal of the triangulation. Or a jump over white to another component,
 * since a part that is whole on one side may be two on the other. */
typedef struct mt_chord {
    int to;      /* the sample at its other end */
    int edge;    /* the half-edge of its component's mesh; -1 for a jump */
    double cost; /* INFINITY: barred */
} mt_chord;

enum { MT_BLOCK_SAMPLES = 16 };

typedef struct mt_boundary {
    mt_frame frame; /* of the glyph */
    int component_count;
    mt_half_edges *meshes; /* of each component, its long edges divided */
    bool **drawn;          /* of each component's mesh: which vertices its rings had before */
    mt_box *boxes;         /* of each component */
    int *first_sample;     /* component_count + 1: vertex v of mesh c is sample first_sample[c] + v */
    int ring_count;
    int *first_of_ring; /* ring_count + 1 */
    int count;          /* of samples */
    mt_sample_view *views;
    mt_point *places; /* of each sample */
    mt_box *blocks;   /* around each MT_BLOCK_SAMPLES of them, the last fewer */
    double *length;   /* from each sample to the next, em */
    double *along;    /* from the start of its ring to each sample, em */
    int *first_chord; /* count + 1 */
    mt_chord *chords;
} mt_boundary;

/* The boundary of a shape in its glyph's frame, with samples as close as the settings' step, the chords up to `reach` grid units long,
 * and jumps if the settings have them. MT_NO_MEMORY, MT_TOO_LARGE, MT_BAD_GEOMETRY. */
mt_status mt_boundary_of(const mt_shape *shape, const mt_frame *frame, const mt_settings *settings,
                         double reach, mt_arena *arena, mt_boundary *boundary);

/* The sample that a chord leaves, and the chord back over the same diagonal. */
int mt_chord_source(const mt_boundary *boundary, int chord);
int mt_chord_back(const mt_boundary *boundary, int chord);

/* The distance between two samples, em. */
double mt_boundary_distance(const mt_boundary *boundary, int i, int j);

/* The length of a chord, em. */
double mt_chord_length(const mt_boundary *boundary, int chord);

/* The ring that a sample is on. */
int mt_boundary_ring(const mt_boundary *boundary, int sample);

/* Whether samples, rings and chords are numbered consecutively, and chords lead to other samples at a positive cost. Linear. */
bool mt_boundary_is_valid(const mt_boundary *boundary);
