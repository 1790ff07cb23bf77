/* How a font is named: FILE[#FACE][@AXIS=VALUE,…].
 *
 * A file's own name may hold # and @. FILE is therefore the longest start of the text that ends before a # or
 * an @, or at the text's end, and names something that exists and is no directory; what follows it is read as
 * the face and the axes. */
#pragma once

#include "morphotype.h"

enum { MT_SPEC_AXES = 64 }; /* axes in one spec; real fonts have up to 16 */

typedef struct mt_axis_setting {
    uint32_t tag;  /* as in 'fvar', padded with spaces */
    int32_t value; /* user coordinates, 16.16 */
} mt_axis_setting;

typedef struct mt_spec {
    char *path;
    int face; /* from 0 */
    int axis_count;
    mt_axis_setting axes[MT_SPEC_AXES]; /* tags all different */
} mt_spec;

/* MT_NO_FILE (errno says why; EISDIR for a directory), MT_NO_FACE for what follows a # and is no number,
 * MT_BAD_AXIS for a malformed or doubled setting, MT_NO_MEMORY. */
mt_status mt_spec_parse(const char *text, mt_spec *spec);
void mt_spec_clear(mt_spec *spec);
