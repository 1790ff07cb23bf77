/* Wavefront OBJ, appendix B1 of the Advanced Visualizer's manual: v X Y Z, f V/VT/VN …; a backslash continues a line. */
#include <string.h>

#include "mesh/formats.h"
#include "mesh/limits.h"
#include "mesh/words.h"

static mt_status refuse(const mt_draft *draft, const mt_words *line, const char *what) {
    return mt_mesh_say(draft->fault, MT_BAD_MESH, "line %d: %s", line->line, what);
}

static mt_status read_point(mt_words *line, mt_draft *draft) {
    double at[3];
    mt_word word;
    for (int i = 0; i < 3; i++)
        if (!mt_words_next(line, &word) || !mt_word_number(word, &at[i]))
            return refuse(draft, line, "v wants three numbers");
    return mt_draft_point(draft, at[0], at[1], at[2]);
}

/* The point of V, V/VT, V//VN or V/VT/VN; -1 for none. */
static int corner_of(mt_word word, int n_points) {
    const char *slash = memchr(word.start, '/', word.length);
    long number;
    if (slash) word.length = (size_t)(slash - word.start);
    if (!mt_word_whole(word, &number)) return -1;
    if (number < 0) number += n_points + 1L;
    return number < 1 ? -1 : (int)(number - 1);
}

static mt_status read_polygon(mt_words *line, mt_draft *draft) {
    int corners[MT_MESH_CORNERS_MAX], count = 0;
    mt_word word;
    while (mt_words_next(line, &word) && *word.start != '#') {
        if (count == MT_MESH_CORNERS_MAX) return refuse(draft, line, "too many corners");
        corners[count] = corner_of(word, draft->n_points);
        if (corners[count++] < 0) return refuse(draft, line, "f wants numbers of points");
    }
    return mt_draft_polygon(draft, corners, count);
}

static mt_status read_line(mt_words *line, mt_draft *draft) {
    mt_word word;
    if (!mt_words_next(line, &word)) return MT_OK;
    if (mt_word_is(word, "v")) return read_point(line, draft);
    return mt_word_is(word, "f") ? read_polygon(line, draft) : MT_OK;
}

/* Puts blanks for each line end after a backslash. */
static void join_lines(uint8_t *bytes, size_t length) {
    for (size_t i = 0; i + 1 < length; i++) {
        if (bytes[i] != '\\') continue;
        size_t ends = bytes[i + 1] == '\n'                                             ? 1
                      : bytes[i + 1] == '\r' && i + 2 < length && bytes[i + 2] == '\n' ? 2
                                                                                       : 0;
        if (ends) memset(bytes + i, ' ', ends + 1);
    }
}

mt_status mt_read_obj(uint8_t *bytes, size_t length, mt_draft *draft) {
    mt_words line;
    mt_status status = MT_OK;
    join_lines(bytes, length);
    mt_words text = mt_words_of(bytes, length);
    while (status == MT_OK && mt_words_line(&text, &line)) status = read_line(&line, draft);
    return status;
}
