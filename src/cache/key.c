/* All is written as the entry itself is (cache/packing.h), where nothing else has the same bytes: each list tells its count first. */
#include "cache/key.h"

#include <string.h>

#include "cache/engine.h"
#include "cache/packing.h"

static void pack_outline(mt_packing *packing, const mt_outline *outline) {
    enum { CUBIC = 3 };
    mt_outline copy = *outline;
    mt_pack_list(packing, &copy.count, copy.contours, sizeof *copy.contours);
    for (int i = 0; i < copy.count; i++) mt_pack_contour(packing, &copy.contours[i], CUBIC);
}

static void pack_hints(mt_packing *packing, const mt_hints *hints) {
    int count = hints ? hints->count : 0;
    mt_pack_int(packing, &count, 0, count);
    for (int i = 0; i < count; i++) {
        mt_hint hint = hints->hints[i];
        int kind = (int)hint.kind;
        mt_pack_int(packing, &kind, 0, kind);
        mt_pack_point(packing, &hint.a);
        mt_pack_point(packing, &hint.b);
    }
}

static void pack_params(mt_packing *packing, const mt_params *params) {
    int method = (int)params->method, rotation = (int)params->rotation;
    mt_params copy = *params;
    mt_pack_int(packing, &method, 0, method);
    mt_pack_double(packing, &copy.tolerance);
    mt_pack_double(packing, &copy.fit);
    for (int i = 0; i < 3; i++) mt_pack_double(packing, &copy.weights[i]);
    mt_pack_int(packing, &copy.rounds, 0, copy.rounds);
    mt_pack_double(packing, &copy.threshold);
    mt_pack_bool(packing, &copy.one_scale);
    mt_pack_int(packing, &rotation, 0, rotation);
    mt_pack_double(packing, &copy.degrees);
    mt_pack_double(packing, &copy.lean);
    mt_pack_double(packing, &copy.effort);
}

mt_status mt_cache_key(const mt_outline outlines[2], const mt_hints *hints, const mt_params *params,
                       mt_digest *key) {
    mt_buffer bytes = {0};
    mt_packing packing = mt_packing_to(&bytes);
    pack_outline(&packing, &outlines[0]);
    pack_outline(&packing, &outlines[1]);
    pack_hints(&packing, hints);
    pack_params(&packing, params);
    mt_status status = mt_packing_end(&packing);
    mt_hashing hashing = mt_hashing_begin();
    mt_hashing_add(&hashing, mt_engine, strlen(mt_engine));
    mt_hashing_add(&hashing, bytes.bytes, bytes.length);
    if (status == MT_OK) *key = mt_hashing_end(&hashing);
    mt_buffer_free(&bytes);
    return status;
}
