/* How a font is named: FILE[#FACE][@AXIS=VALUE,…][:FEATURE[=VALUE],…].
 *
 * A file's own name may hold #, @ and colons. FILE is therefore the longest start of the text that ends before one of
 * these, or at the text's end, and names something that exists and is no directory; what follows it is read as the face,
 * the axes and the features. */
#pragma once

#include "morphotype.h"

enum { MT_SPEC_AXES = 64, MT_SPEC_FEATURES = 64 }; /* in one spec; real fonts have up to 16 axes */

typedef struct mt_axis_setting {
    uint32_t tag;  /* as in 'fvar', padded with spaces */
    int32_t value; /* user coordinates, 16.16 */
} mt_axis_setting;

typedef struct mt_feature_setting {
    uint32_t tag;   /* of GSUB, padded with spaces */
    uint32_t value; /* 0: off; 1: on; of a list of alternates the number, from 1 to 255 */
} mt_feature_setting;

typedef struct mt_spec {
    char *path;
    int face; /* from 0 */
    int axis_count;
    mt_axis_setting axes[MT_SPEC_AXES]; /* tags all different */
    int feature_count;
    mt_feature_setting features[MT_SPEC_FEATURES]; /* tags all different */
} mt_spec;

/* MT_NO_FILE (errno says why; EISDIR for a directory), MT_NO_FACE for what follows a # and is no number,
 * MT_BAD_AXIS or MT_BAD_FEATURE for a malformed or doubled setting, MT_NO_MEMORY. */
mt_status mt_spec_parse(const char *text, mt_spec *spec);
/* The same of a font that is no file: what `choice` has after FILE, and `name` in place of the path. MT_BAD_PARAMETER for a
 * choice that begins with none of #, @ and :, otherwise the same but for MT_NO_FILE. */
mt_status mt_spec_parse_choice(const char *name, const char *choice, mt_spec *spec);
void mt_spec_clear(mt_spec *spec);
