/* The parameters' ranges. */
#pragma once

#include "morphotype.h"

/* MT_OK, or MT_BAD_PARAMETER when one is out of its range (morphotype.h). */
mt_status mt_params_check(const mt_params *params);
