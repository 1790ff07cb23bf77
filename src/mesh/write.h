/* Meshes written into memory: OBJ, STL, PLY, OFF or GLB. Texts have nine digits, binary files binary32. */
#pragma once

#include "base/buffer.h"
#include "mesh/read.h"

/* The buffer is the caller's. MT_NO_MEMORY. */
mt_status mt_mesh_write(const mt_mesh *mesh, mt_mesh_format format, mt_buffer *file);
