#include "mesh/fault.h"

#include <stdarg.h>
#include <stdio.h>

#include "base/real.h"

mt_status mt_mesh_say(mt_mesh_fault *fault, mt_status status, const char *format, ...) {
    va_list list;
    va_start(list, format);
    vsnprintf(fault->line, sizeof fault->line, format, list);
    va_end(list);
    return status;
}

void mt_place_write(mt_vector3 place, char text[MT_PLACE_ROOM]) {
    enum { DIGITS = 6 };
    char x[MT_REAL_ROOM], y[MT_REAL_ROOM], z[MT_REAL_ROOM];
    mt_real_write(place.x, DIGITS, x);
    mt_real_write(place.y, DIGITS, y);
    mt_real_write(place.z, DIGITS, z);
    snprintf(text, MT_PLACE_ROOM, "(%.18s, %.18s, %.18s)", x, y, z);
}
