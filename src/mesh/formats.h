/* Readers of the formats: bytes become a draft. What a format has besides points and polygons, such as colours, normals and
 * groups, is passed over. MT_BAD_MESH, with the fault said, for damaged files; MT_TOO_LARGE; MT_NO_MEMORY. */
#pragma once

#include "mesh/draft.h"

/* Wavefront OBJ: v and f, with indices that count from the start or back from the end. Joins lines in `bytes`. */
mt_status mt_read_obj(uint8_t *bytes, size_t length, mt_draft *draft);

/* STL, as text or binary. */
mt_status mt_read_stl(const uint8_t *bytes, size_t length, mt_draft *draft);

/* PLY 1.0, as text or binary in either order of bytes: x, y and z of vertex, vertex_indices or vertex_index of face. */
mt_status mt_read_ply(const uint8_t *bytes, size_t length, mt_draft *draft);

/* OFF, with or without normals, colours and places on textures (NOFF, COFF, STOFF). */
mt_status mt_read_off(const uint8_t *bytes, size_t length, mt_draft *draft);

/* Binary glTF 2.0: the triangles of its scene, moved by its nodes. */
mt_status mt_read_glb(const uint8_t *bytes, size_t length, mt_draft *draft);
