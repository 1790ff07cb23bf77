/* SplitMix64 (G. Steele, D. Lea, C. Flood, "Fast splittable pseudorandom number generators", 2014). */
#include "support/random.h"

#include <stdlib.h>

#define GOLDEN_GAMMA 0x9e3779b97f4a7c15u

static uint64_t setting(const char *name) {
    const char *text = getenv(name);
    uint64_t value = text ? strtoull(text, NULL, 0) : 0;
    return value ? value : 1;
}

uint64_t mt_test_seed(void) {
    return setting("MT_SEED");
}

int mt_test_cases(int usual) {
    return usual * (int)setting("MT_CASES");
}

mt_random mt_random_case(int number) {
    mt_random random = {mt_test_seed() * 0x100000001b3u};
    random.state = mt_random_next(&random) + (uint64_t)number;
    return random;
}

uint64_t mt_random_next(mt_random *random) {
    uint64_t z = random->state += GOLDEN_GAMMA;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

int mt_random_between(mt_random *random, int low, int high) {
    uint64_t span = (uint64_t)((int64_t)high - low) + 1;
    return (int)(low + (int64_t)(mt_random_next(random) % span));
}

double mt_random_unit(mt_random *random) {
    return (double)(mt_random_next(random) >> 11) * 0x1p-53;
}

mt_point mt_random_point(mt_random *random, int low, int high) {
    int x = mt_random_between(random, low, high);
    return (mt_point){x, mt_random_between(random, low, high)};
}

bool mt_random_one_in(mt_random *random, int n) {
    return mt_random_between(random, 1, n) == 1;
}
