/* The limits of solids, each with its unit and its reason. */
#pragma once

/* Pieces of one solid. A torus of 24 segments has 24; a smooth solid of a thousand triangles, cut until all is convex, some hundreds. */
#define MT_SOLID_PIECES_MAX 1024

/* Triangles of all links together: a million are past what is looked at. */
#define MT_SOLID_TRIANGLES_MAX 4000000

/* How often all pairs of pieces are tried for merging. */
#define MT_MERGE_ROUNDS 4
