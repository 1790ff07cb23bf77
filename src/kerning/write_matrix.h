/* A matrix of classes: PairPosFormat2 (OpenType spec, "GPOS"). */
#pragma once

#include "kerning/writer.h"

/* As many subtables as 16-bit offsets ask for. MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_pair_write_matrix(mt_pair_writer *writer);
