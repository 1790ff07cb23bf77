#include "suggest.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>

/* Of the first i bytes of a word and j of another. */
typedef int cost_table[SUGGEST_MOST + 1][SUGGEST_MOST + 1];

static int least(int a, int b) {
    return a < b ? a : b;
}

/* The costs of all that is shorter are there. */
static int cost_of(const char *a, const char *b, int i, int j, cost_table cost) {
    if (i == 0 || j == 0) return i + j;
    int replaced = cost[i - 1][j - 1] + (a[i - 1] != b[j - 1]);
    int best = least(replaced, least(cost[i - 1][j], cost[i][j - 1]) + 1);
    bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
    return swapped ? least(best, cost[i - 2][j - 2] + 1) : best;
}

int word_distance(const char *a, const char *b) {
    cost_table cost;
    int n = (int)strnlen(a, SUGGEST_MOST + 1), m = (int)strnlen(b, SUGGEST_MOST + 1);
    if (n > SUGGEST_MOST || m > SUGGEST_MOST) return SUGGEST_FAR;
    for (int i = 0; i <= n; i++)
        for (int j = 0; j <= m; j++) cost[i][j] = cost_of(a, b, i, j, cost);
    return cost[n][m];
}

/* A third of the word may be wrong, and one letter of any word of more than one. */
suggestion suggest_for(const char *wanted) {
    int length = (int)strnlen(wanted, SUGGEST_MOST);
    int most = length / 3 > 1 ? length / 3 : length > 1;
    return (suggestion){.wanted = wanted, .distance = most + 1};
}

void suggest(suggestion *nearest, const char *word) {
    int distance = word_distance(nearest->wanted, word);
    if (distance >= nearest->distance) return;
    nearest->distance = distance;
    nearest->word = word;
}

const char *suggest_text(const suggestion *nearest, const char *prefix, char text[SUGGEST_ROOM]) {
    *text = '\0';
    if (nearest->word) snprintf(text, SUGGEST_ROOM, "; did you mean %s%s?", prefix, nearest->word);
    return text;
}
