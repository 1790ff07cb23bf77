/* The inspection's page: what base/embed.py makes of page/inspect.html, the styles and the scripts. */
#pragma once

#include "base/page.h"

extern const mt_page_part mt_inspect_page_parts[];
