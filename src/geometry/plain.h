/* Shapes whose rings do not cross. */
#pragma once

#include "geometry/ring.h"

/* Makes sure that each component can be triangulated, and that its triangles have its area: that no edges of its rings cross, and that its
 * holes are within it and apart. A union keeps to that but where it rounds: there edges may cross by a grid unit or two, or a hole get to
 * the wrong component. Such a shape is made anew from the triangles of all its rings, rounded until no edges cross; nothing moves by more
 * than a grid unit on either axis. Any other shape stays as it is, also one that is too large to triangulate. *shape is of the caller or
 * the arena. MT_NO_MEMORY, MT_TOO_LARGE. The cost is that of the triangulations. */
mt_status mt_shape_make_plain(const mt_shape *given, mt_arena *arena, mt_shape *shape);
