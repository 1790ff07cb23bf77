/* OFF (Geomview manual, "OFF Files"): a line of the word, unless it is left out; the counts of points, polygons and edges; a line a
 * point; a line a polygon. # begins a comment. */
#include <string.h>

#include "mesh/formats.h"
#include "mesh/limits.h"
#include "mesh/words.h"

static mt_status refuse(const mt_draft *draft, const mt_words *line, const char *what) {
    return mt_mesh_say(draft->fault, MT_BAD_MESH, "line %d: %s", line->line, what);
}

/* The next line that is neither blank nor a comment, without its comment. */
static bool next_line(mt_words *text, mt_words *line) {
    mt_word word;
    while (mt_words_line(text, line)) {
        const char *comment = memchr(line->at, '#', (size_t)(line->end - line->at));
        if (comment) line->end = comment;
        mt_words words = *line;
        if (mt_words_next(&words, &word)) return true;
    }
    return false;
}

/* Whether the word is OFF, or that of points with normals, colours or places on a texture; in three dimensions. */
static bool is_header(mt_word word) {
    static const char *const headers[] = {"OFF",   "COFF",   "NOFF",   "CNOFF",
                                          "STOFF", "STCOFF", "STNOFF", "STCNOFF"};
    for (size_t i = 0; i < sizeof headers / sizeof *headers; i++)
        if (mt_word_is(word, headers[i])) return true;
    return false;
}

static bool read_counts(mt_words *line, long counts[2]) {
    mt_word word;
    for (int i = 0; i < 2; i++)
        if (!mt_words_next(line, &word) || !mt_word_whole(word, &counts[i]) || counts[i] < 0) return false;
    return true;
}

/* The counts stand behind the header, or on the next line. */
static mt_status read_head(mt_words *text, mt_draft *draft, long counts[2]) {
    mt_words line, rest;
    mt_word word;
    if (!next_line(text, &line)) return mt_mesh_say(draft->fault, MT_BAD_MESH, "no OFF: it is empty");
    rest = line;
    mt_words_next(&rest, &word);
    if (is_header(word)) {
        line = rest;
        if (!mt_words_next(&rest, &word) && !next_line(text, &line))
            return mt_mesh_say(draft->fault, MT_BAD_MESH, "cut short: no counts");
    }
    if (!read_counts(&line, counts)) return refuse(draft, &line, "no counts of points and polygons");
    return mt_draft_expect(draft, counts[1]);
}

static mt_status read_point(mt_words *line, mt_draft *draft) {
    double at[3];
    mt_word word;
    for (int i = 0; i < 3; i++)
        if (!mt_words_next(line, &word) || !mt_word_number(word, &at[i]))
            return refuse(draft, line, "a point wants three numbers");
    return mt_draft_point(draft, at[0], at[1], at[2]);
}

static mt_status read_polygon(mt_words *line, mt_draft *draft) {
    int corners[MT_MESH_CORNERS_MAX];
    mt_word word;
    long count, number;
    if (!mt_words_next(line, &word) || !mt_word_whole(word, &count) || count < 0 ||
        count > MT_MESH_CORNERS_MAX)
        return refuse(draft, line, "a polygon wants the count of its corners");
    for (int i = 0; i < count; i++) {
        if (!mt_words_next(line, &word) || !mt_word_whole(word, &number) || number < 0)
            return refuse(draft, line, "a polygon wants numbers of points");
        corners[i] = (int)number;
    }
    return mt_draft_polygon(draft, corners, (int)count);
}

mt_status mt_read_off(const uint8_t *bytes, size_t length, mt_draft *draft) {
    mt_words text = mt_words_of(bytes, length), line;
    long counts[2];
    mt_status status = read_head(&text, draft, counts);
    for (long i = 0; i < counts[0] + counts[1] && status == MT_OK; i++) {
        if (!next_line(&text, &line))
            return mt_mesh_say(draft->fault, MT_BAD_MESH,
                               "cut short: %ld points and %ld polygons are told, %ld lines are there",
                               counts[0], counts[1], i);
        status = i < counts[0] ? read_point(&line, draft) : read_polygon(&line, draft);
    }
    return status;
}
