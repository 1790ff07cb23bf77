/* Pieces divided among their counterparts. */
#pragma once

#include "solid/links.h"

/* A piece that is linked with several pieces that meet is divided as they are: by a plane along the wall where they meet, where it has
 * their shares of the volume on both sides, each part linked with those on its side. What has grown together would otherwise grow once
 * for each of them, and all of it around the whole piece. Pieces that do not meet stay linked with the whole of their counterpart.
 * Divided pieces are again what mt_cells_decompose leaves; where no plane does that, the piece stays whole. Both halves are measured anew.
 * MT_NO_MEMORY. */
mt_status mt_links_share(mt_arena *arena, mt_half *first, mt_half *second, mt_links *links);
