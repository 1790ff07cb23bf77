/* Random numbers that are the same on every machine, and how many random cases a test tries.
 *
 * The environment variable MT_SEED sets the seed, MT_CASES multiplies the number of cases: MT_SEED=7
 * MT_CASES=100. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "geometry/point.h"

typedef struct mt_random {
    uint64_t state;
} mt_random;

/* MT_SEED, or 1. */
uint64_t mt_test_seed(void);

/* `usual` times MT_CASES. */
int mt_test_cases(int usual);

/* The numbers of case `number` under mt_test_seed: each case has its own, whatever ran before it. */
mt_random mt_random_case(int number);

uint64_t mt_random_next(mt_random *random);
int mt_random_between(mt_random *random, int low, int high);    /* both inclusive */
double mt_random_unit(mt_random *random);                       /* 0 … 1, without 1 */
mt_point mt_random_point(mt_random *random, int low, int high); /* x, then y: compilers differ otherwise */
bool mt_random_one_in(mt_random *random, int n);
