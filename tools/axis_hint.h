/* Which axes a font has, where one was asked for that it has not. */
#pragma once

#include <stddef.h>

enum { AXIS_HINT_ROOM = 256 };

/* What may follow the message on a font whose axis is not there: "; did you mean wght?", "; it has wght and opsz", or that it
 * does not vary. "" where that cannot be told. */
void axis_hint(const char *spec, char text[AXIS_HINT_ROOM]);
