/* The specimen's page: what base/embed.py makes of page/page.html, page/style.css and the scripts there. */
#pragma once

#include "base/page.h"

extern const mt_page_part mt_specimen_page[];
