/* Meshes from files and from memory, checked to be the surface of a solid. */
#pragma once

#include "base/memory.h"
#include "mesh/fault.h"

/* The format that a file name's extension tells, in either case. */
typedef enum mt_mesh_format {
    MT_MESH_OBJ,
    MT_MESH_STL,
    MT_MESH_PLY,
    MT_MESH_OFF,
    MT_MESH_GLB
} mt_mesh_format;
bool mt_mesh_format_of(const char *path, mt_mesh_format *format);

/* A closed mesh in the arena: welded, without triangles that have no area, facing outwards. Its faults are said. MT_UNKNOWN_FORMAT,
 * MT_NO_FILE (errno says why), MT_BAD_MESH, MT_NOT_SOLID, MT_TOO_LARGE, MT_NO_MEMORY. */
mt_status mt_mesh_read(const char *path, mt_arena *arena, mt_mesh *mesh, mt_mesh_fault *fault);

/* The same of the contents of a file. Lines of an OBJ are joined in `bytes`. */
mt_status mt_mesh_parse(uint8_t *bytes, size_t length, mt_mesh_format format, mt_arena *arena, mt_mesh *mesh,
                        mt_mesh_fault *fault);

/* The same of a mesh from memory. */
mt_status mt_mesh_check(const mt_mesh *given, mt_arena *arena, mt_mesh *mesh, mt_mesh_fault *fault);
