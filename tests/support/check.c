#include "support/check.h"

#include "support/corpus.h"
#include "support/random.h"

#include <stdio.h>

void *mt_test_new(size_t count, size_t size) {
    void *memory = calloc(count ? count : 1, size);
    if (!memory) abort();
    return memory;
}

void mt_test_fail(const char *condition, const mt_subject *subject, const char *file, int line) {
    fprintf(stderr, "not so: %s\non %s", condition, subject->name);
    if (subject->number >= 0)
        fprintf(stderr, ", case %d, MT_SEED=%llu", subject->number, (unsigned long long)mt_test_seed());
    fprintf(stderr, "\n");
    for (int i = 0; i < 4; i++)
        if (subject->shapes[i]) mt_corpus_print(stderr, subject->name, subject->shapes[i]);
    _fail(file, line);
}
