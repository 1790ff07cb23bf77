/* The report's page: what base/embed.py makes of page/report.html, the styles and the scripts. */
#pragma once

#include "base/page.h"

extern const mt_page_part mt_report_page[];
