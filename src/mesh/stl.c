/* STL (3D Systems, "StereoLithography Interface Specification"): as text, facets of vertices; binary, 80 bytes, a count, and 50
 * bytes a triangle. Normals are passed over: the order of the vertices tells the outside. */
#include "mesh/bytes.h"
#include "mesh/formats.h"
#include "mesh/words.h"

enum { HEADER = 84, FACET = 50, NORMAL = 12, VERTEX = 12 };

/* ---- binary -------------------------------------------------------------------------------------------- */

static mt_status read_facet(const uint8_t *facet, mt_draft *draft) {
    int corners[3];
    for (int i = 0; i < 3; i++) {
        const uint8_t *vertex = facet + NORMAL + i * VERTEX;
        corners[i] = draft->n_points;
        mt_status status =
            mt_draft_point(draft, (double)mt_get_float(vertex, false),
                           (double)mt_get_float(vertex + 4, false), (double)mt_get_float(vertex + 8, false));
        if (status != MT_OK) return status;
    }
    return mt_draft_polygon(draft, corners, 3);
}

static mt_status read_binary(const uint8_t *bytes, size_t length, mt_draft *draft) {
    uint32_t count = mt_get_u32_little(bytes + HEADER - 4);
    mt_status status = mt_draft_expect(draft, count);
    if (status == MT_OK && count > (length - HEADER) / FACET)
        status = mt_mesh_say(draft->fault, MT_BAD_MESH, "cut short: %u triangles are told, %zu are there",
                             (unsigned)count, (length - HEADER) / FACET);
    for (uint32_t i = 0; i < count && status == MT_OK; i++)
        status = read_facet(bytes + HEADER + (size_t)i * FACET, draft);
    return status;
}

/* ---- text ---------------------------------------------------------------------------------------------- */

/* Three vertices at most; more are counted. */
typedef struct mt_loop {
    int count;
    int corners[3];
} mt_loop;

static mt_status read_vertex(mt_words *text, mt_loop *loop, mt_draft *draft) {
    double at[3];
    mt_word word;
    for (int i = 0; i < 3; i++)
        if (!mt_words_next(text, &word) || !mt_word_number(word, &at[i]))
            return mt_mesh_say(draft->fault, MT_BAD_MESH, "line %d: vertex wants three numbers",
                               text->line + 1);
    if (loop->count < 3) loop->corners[loop->count] = draft->n_points;
    loop->count++;
    return mt_draft_point(draft, at[0], at[1], at[2]);
}

static mt_status end_loop(const mt_words *text, mt_loop *loop, mt_draft *draft) {
    int count = loop->count;
    loop->count = 0;
    if (count == 3) return mt_draft_polygon(draft, loop->corners, 3);
    return mt_mesh_say(draft->fault, MT_BAD_MESH, "line %d: a facet of %d vertices", text->line + 1, count);
}

static mt_status read_text(const uint8_t *bytes, size_t length, mt_draft *draft) {
    mt_words text = mt_words_of(bytes, length);
    mt_loop loop = {0};
    mt_word word;
    mt_status status = MT_OK;
    while (status == MT_OK && mt_words_next(&text, &word)) {
        if (mt_word_is(word, "vertex"))
            status = read_vertex(&text, &loop, draft);
        else if (mt_word_is(word, "endloop"))
            status = end_loop(&text, &loop, draft);
    }
    if (status == MT_OK && loop.count > 0)
        status = mt_mesh_say(draft->fault, MT_BAD_MESH, "cut short: the last facet does not end");
    return status;
}

/* Some binary files begin with the word, too; their length tells them. */
static bool is_text(const uint8_t *bytes, size_t length) {
    if (length >= HEADER) {
        uint64_t whole = HEADER + (uint64_t)mt_get_u32_little(bytes + HEADER - 4) * FACET;
        if (whole == length) return false;
    }
    return length >= 5 && memcmp(bytes, "solid", 5) == 0;
}

mt_status mt_read_stl(const uint8_t *bytes, size_t length, mt_draft *draft) {
    if (is_text(bytes, length)) return read_text(bytes, length, draft);
    if (length >= HEADER) return read_binary(bytes, length, draft);
    return mt_mesh_say(draft->fault, MT_BAD_MESH, "no STL: neither text nor long enough for binary");
}
