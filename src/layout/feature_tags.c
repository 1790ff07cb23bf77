#include "layout/feature_tags.h"

#include <stddef.h>

#include "sfnt/sfnt.h"

/* Whether one of the tags, which stand one after another, is this one. */
static bool is_among(const char *tags, uint32_t tag) {
    for (; *tags; tags += 4)
        if (MT_TAG((uint8_t)tags[0], (uint8_t)tags[1], (uint8_t)tags[2], (uint8_t)tags[3]) == tag)
            return true;
    return false;
}

bool mt_feature_is_automatic(uint32_t tag, bool fractions) {
    static const char *const sets[] = {
        "rvrnltraltrmrtlartlmrandHarfHARFBuzzBUZZ", /* every script: hb-ot-shape.cc */
        "abvmblwmccmploclmarkmkmkrligcaltcligcursdistkernligarcltvert",
        "stchisolfinafin2fin3medimed2initmset",             /* Arabic, Syriac and those that join alike */
        "nuktakhnrphfrkrfprefblwfabvfhalfpstfvatucjctcfar", /* Indic, Khmer, Myanmar, universal: forms */
        "presabvsblwspstshaln",                             /* … and what follows them */
        "ljmovjmotjmo",                                     /* Hangul */
        "sstyflacdtls",                                     /* formulas: OpenType spec, "MATH" */
    };
    for (size_t i = 0; i < sizeof sets / sizeof *sets; i++)
        if (is_among(sets[i], tag)) return true;
    return fractions && is_among("fracnumrdnom", tag);
}
