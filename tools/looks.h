/* Which glyphs of a variable font need a look, judged as a report does while the font is made. */
#pragma once

#include "report/report.h"
#include "work.h"

/* Says of each two neighbours which glyphs between them need a look, the worst first, and why: with --verbose each in a line. The
 * figures are of the work's fonts. DONE or, said, COULD_NOT. */
int looks_say(const cli_work *work, const mt_report_figures *figures);
