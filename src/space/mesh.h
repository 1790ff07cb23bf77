/* Meshes of triangles in space. The public interface has their struct. */
#pragma once

#include "morphotype.h"
