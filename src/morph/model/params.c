#include "morph/model/params.h"

#include <math.h>

/* How the defaults were chosen is in docs/paper.md, with the figures. */
mt_params mt_params_default(void) {
    return (mt_params){
        .method = MT_METHOD_JOINT,
        .tolerance = 0.5,
        .fit = 0.35,
        .weights = {0.4, 0.2, 0.4},
        .rounds = 10,
        .threshold = 0.5,
        .one_scale = false,
        .rotation = MT_ROTATION_NONE,
        .degrees = 0,
        .slant = MT_SLANT_FOUND,
        .lean = 0,
        .threads = 0,
        .effort = 1,
    };
}

static bool within(double value, double low, double high) {
    return value >= low && value <= high; /* false for a NaN */
}

mt_status mt_params_check(const mt_params *params) {
    bool fine = within(params->tolerance, 0.05, 10) && within(params->fit, 0.05, 10) &&
                within(params->threshold, 0, 1) && within(params->degrees, -360, 360) &&
                within(params->lean, -45, 45) && params->slant >= MT_SLANT_FOUND &&
                params->slant <= MT_SLANT_GIVEN && params->rounds >= 0 && params->rounds <= 1000 &&
                params->threads >= 0 && within(params->effort, 0.01, 100) &&
                params->rotation >= MT_ROTATION_NONE && params->rotation <= MT_ROTATION_FOUND &&
                params->method >= MT_METHOD_JOINT && params->method <= MT_METHOD_PAPER;
    double sum = 0;
    for (int i = 0; i < 3; i++) {
        fine = fine && within(params->weights[i], 0, 1);
        sum += params->weights[i];
    }
    return fine && fabs(sum - 1) < 1e-6 ? MT_OK : MT_BAD_PARAMETER;
}
