/* How much more one font leans than another. */
#pragma once

#include "source/font.h"

/* By how many degrees B's stems lean to the right of A's, measured on the drawings of characters that both fonts have: a declared italic
 * angle may be wrong. 0 where they lean alike. MT_NO_MEMORY. */
mt_status mt_slant_between(mt_font *a, mt_font *b, double *degrees);
