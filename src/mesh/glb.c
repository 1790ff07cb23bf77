/* Binary glTF 2.0 (Khronos, "glTF 2.0 Specification"): section 4 has the two chunks, section 3.5 nodes, 3.6 and 3.7 accessors and
 * meshes. Materials, skins, morph targets, cameras and animations are passed over. */
#include <string.h>

#include "base/json_tree.h"
#include "mesh/bytes.h"
#include "mesh/formats.h"
#include "mesh/limits.h"

enum {
    HEADER = 12,
    CHUNK = 8,
    JSON_MAX = 16 << 20,
    LEVELS_MAX = 256,
    NODES_MAX = 65536,
    PRIMITIVES_MAX = 65536
};
enum { MODE_TRIANGLES = 4, MODE_STRIP = 5, MODE_FAN = 6 };
enum { TYPE_U8 = 5121, TYPE_U16 = 5123, TYPE_U32 = 5125, TYPE_FLOAT = 5126 };

/* An affine map, columns of a 3 × 4 matrix. */
typedef struct mt_place3 {
    double m[12];
} mt_place3;

static const mt_place3 nowhere = {{1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}};

typedef struct mt_glb {
    mt_draft *draft;
    mt_arena arena;
    mt_json_value *json;
    const uint8_t *binary; /* the second chunk; NULL: none */
    size_t length;
    bool *seen;       /* of each node */
    int n_primitives; /* that were read, as often as nodes have them */
} mt_glb;

/* Where an accessor's elements are. */
typedef struct mt_accessed {
    const uint8_t *first;
    int count, type, stride;
} mt_accessed;

static mt_status refuse(const mt_glb *glb, const char *what) {
    return mt_mesh_say(glb->draft->fault, MT_BAD_MESH, "%s", what);
}

/* ---- chunks -------------------------------------------------------------------------------------------- */

static mt_status read_json(mt_glb *glb, const uint8_t *text, size_t length) {
    if (length > JSON_MAX) return mt_mesh_say(glb->draft->fault, MT_TOO_LARGE, "over 16 MB of JSON");
    mt_status status = mt_json_read((const char *)text, length, &glb->arena, &glb->json);
    return status == MT_BAD_PARAMETER ? refuse(glb, "its JSON is damaged") : status;
}

static mt_status read_chunks(mt_glb *glb, const uint8_t *bytes, size_t length) {
    if (length < HEADER + CHUNK || memcmp(bytes, "glTF", 4) != 0) return refuse(glb, "no binary glTF");
    if (mt_get_u32_little(bytes + 4) != 2) return refuse(glb, "no glTF of version 2");
    size_t whole = mt_get_u32_little(bytes + 8), json = mt_get_u32_little(bytes + HEADER);
    bool cut = whole > length || whole < HEADER + CHUNK || json > whole - HEADER - CHUNK;
    if (cut || memcmp(bytes + HEADER + 4, "JSON", 4) != 0) return refuse(glb, "cut short");
    size_t next = HEADER + CHUNK + json;
    if (whole - next >= CHUNK && memcmp(bytes + next + 4, "BIN", 4) == 0) {
        glb->binary = bytes + next + CHUNK;
        glb->length = mt_get_u32_little(bytes + next);
        if (glb->length > whole - next - CHUNK) return refuse(glb, "cut short");
    }
    return read_json(glb, bytes + HEADER + CHUNK, json);
}

/* Extensions that change nothing about where triangles are. */
static bool is_harmless(const mt_json_value *name) {
    static const char *const harmless[] = {"KHR_materials_", "KHR_texture_", "KHR_lights_", "EXT_texture_",
                                           "KHR_xmp"};
    for (size_t i = 0; i < sizeof harmless / sizeof *harmless; i++)
        if (name->text && strncmp(name->text, harmless[i], strlen(harmless[i])) == 0) return true;
    return false;
}

static mt_status check_document(const mt_glb *glb) {
    const mt_json_value *asset = mt_json_member(glb->json, "asset");
    const mt_json_value *version = mt_json_member(asset, "version");
    if (!version || !version->text || strncmp(version->text, "2.", 2) != 0)
        return refuse(glb, "no glTF of version 2");
    for (int i = 0; i < mt_json_count(glb->json, "extensionsRequired"); i++) {
        const mt_json_value *name = mt_json_item(glb->json, "extensionsRequired", i);
        if (!is_harmless(name))
            return mt_mesh_say(glb->draft->fault, MT_BAD_MESH, "it wants the extension %.60s",
                               name->text ? name->text : "that has no name");
    }
    return MT_OK;
}

/* ---- accessors ----------------------------------------------------------------------------------------- */

static mt_status view_bytes(const mt_glb *glb, int view, const uint8_t **bytes, size_t *length, int *stride) {
    const mt_json_value *object = mt_json_item(glb->json, "bufferViews", view);
    int buffer = mt_json_index(object, "buffer", -1), offset = mt_json_index(object, "byteOffset", 0);
    int size = mt_json_index(object, "byteLength", -1);
    const mt_json_value *held = mt_json_item(glb->json, "buffers", buffer);
    *stride = mt_json_index(object, "byteStride", 0);
    if (!held || offset < 0 || size < 0 || *stride < 0) return refuse(glb, "a buffer view is damaged");
    if (buffer != 0 || mt_json_member(held, "uri") || !glb->binary)
        return refuse(glb, "a buffer is outside of its binary chunk");
    if ((size_t)offset > glb->length || (size_t)size > glb->length - (size_t)offset)
        return refuse(glb, "a buffer view is larger than its buffer");
    *bytes = glb->binary + offset;
    *length = (size_t)size;
    return MT_OK;
}

static int component_size(int type) {
    return type == TYPE_U8 ? 1 : type == TYPE_U16 ? 2 : type == TYPE_U32 || type == TYPE_FLOAT ? 4 : 0;
}

/* `components` is 3 for a VEC3, and 1 for a SCALAR. */
static mt_status read_accessor(const mt_glb *glb, int accessor, int components, mt_accessed *accessed) {
    const mt_json_value *object = mt_json_item(glb->json, "accessors", accessor);
    const mt_json_value *type = mt_json_member(object, "type");
    int offset = mt_json_index(object, "byteOffset", 0), view = mt_json_index(object, "bufferView", -1);
    size_t length = 0;
    accessed->count = mt_json_index(object, "count", -1);
    accessed->type = mt_json_index(object, "componentType", -1);
    int size = component_size(accessed->type) * components;
    bool fits = type && type->text && strcmp(type->text, components == 3 ? "VEC3" : "SCALAR") == 0;
    if (mt_json_member(object, "sparse")) return refuse(glb, "an accessor is sparse");
    if (!fits || size == 0 || (components == 3) != (accessed->type == TYPE_FLOAT))
        return refuse(glb, "an accessor is of a type that is not read");
    if (offset < 0 || accessed->count < 0) return refuse(glb, "an accessor is damaged");
    mt_status status = view_bytes(glb, view, &accessed->first, &length, &accessed->stride);
    if (status != MT_OK) return status;
    if (accessed->stride == 0) accessed->stride = size;
    uint64_t end = (uint64_t)offset + (uint64_t)size;
    if (accessed->count > 0) end += ((uint64_t)accessed->count - 1) * (uint64_t)accessed->stride;
    if (accessed->stride < size || end > length)
        return refuse(glb, "an accessor is larger than its buffer view");
    accessed->first += offset;
    return MT_OK;
}

static int index_at(const mt_accessed *indices, int i) {
    const uint8_t *at = indices->first + (size_t)i * (size_t)indices->stride;
    uint64_t index = mt_get_unsigned(at, component_size(indices->type), false);
    return index > INT32_MAX ? -1 : (int)index;
}

/* ---- meshes -------------------------------------------------------------------------------------------- */

static mt_status read_points(const mt_glb *glb, const mt_accessed *places, const mt_place3 *place) {
    mt_status status = MT_OK;
    const double *m = place->m;
    for (int i = 0; i < places->count && status == MT_OK; i++) {
        const uint8_t *at = places->first + (size_t)i * (size_t)places->stride;
        double x = (double)mt_get_float(at, false), y = (double)mt_get_float(at + 4, false),
               z = (double)mt_get_float(at + 8, false);
        status =
            mt_draft_point(glb->draft, m[0] * x + m[3] * y + m[6] * z + m[9],
                           m[1] * x + m[4] * y + m[7] * z + m[10], m[2] * x + m[5] * y + m[8] * z + m[11]);
    }
    return status;
}

/* A mirror turns triangles over, and they are turned back. */
static bool is_mirror(const mt_place3 *place) {
    const double *m = place->m;
    return m[0] * (m[4] * m[8] - m[5] * m[7]) - m[3] * (m[1] * m[8] - m[2] * m[7]) +
               m[6] * (m[1] * m[5] - m[2] * m[4]) <
           0;
}

/* The places among `count` corners of those of triangle `t`. */
static void corners_of(int mode, int t, bool mirrored, int corners[3]) {
    bool turned = mirrored != (mode == MODE_STRIP && t % 2 == 1);
    int first = mode == MODE_TRIANGLES ? 3 * t : mode == MODE_STRIP ? t : 0;
    int second = mode == MODE_FAN ? t + 1 : first + 1;
    corners[0] = first;
    corners[turned ? 2 : 1] = second;
    corners[turned ? 1 : 2] = second + 1;
}

static mt_status read_triangles(const mt_glb *glb, const mt_accessed *indices, int mode, int n_points,
                                bool mirrored) {
    int count = indices ? indices->count : n_points, first = glb->draft->n_points - n_points;
    int n_triangles = mode == MODE_TRIANGLES ? count / 3 : count - 2;
    mt_status status = MT_OK;
    for (int t = 0; t < n_triangles && status == MT_OK; t++) {
        int corners[3];
        corners_of(mode, t, mirrored, corners);
        for (int i = 0; i < 3; i++) {
            int point = indices ? index_at(indices, corners[i]) : corners[i];
            if (point < 0 || point >= n_points) return refuse(glb, "a triangle has a corner at no point");
            corners[i] = first + point;
        }
        status = mt_draft_polygon(glb->draft, corners, 3);
    }
    return status;
}

/* Points and lines are no triangles, and are passed over. */
static mt_status read_primitive(const mt_glb *glb, const mt_json_value *primitive, const mt_place3 *place) {
    int mode = mt_json_index(primitive, "mode", MODE_TRIANGLES);
    mt_accessed places, indices;
    if (mode < 0 || mode > MODE_FAN) return refuse(glb, "a primitive is damaged");
    if (mode < MODE_TRIANGLES) return MT_OK;
    if (mt_json_member(mt_json_member(primitive, "extensions"), "KHR_draco_mesh_compression"))
        return refuse(glb, "it wants the extension KHR_draco_mesh_compression");
    bool indexed = mt_json_member(primitive, "indices") != NULL;
    int positions = mt_json_index(mt_json_member(primitive, "attributes"), "POSITION", -1);
    mt_status status = read_accessor(glb, positions, 3, &places);
    if (status == MT_OK && indexed)
        status = read_accessor(glb, mt_json_index(primitive, "indices", -1), 1, &indices);
    if (status == MT_OK) status = read_points(glb, &places, place);
    if (status != MT_OK) return status;
    return read_triangles(glb, indexed ? &indices : NULL, mode, places.count, is_mirror(place));
}

static mt_status read_mesh(mt_glb *glb, int mesh, const mt_place3 *place) {
    const mt_json_value *object = mt_json_item(glb->json, "meshes", mesh);
    mt_status status = object ? MT_OK : refuse(glb, "a node has a mesh that is not there");
    for (int i = 0; i < mt_json_count(object, "primitives") && status == MT_OK; i++) {
        if (glb->n_primitives++ == PRIMITIVES_MAX)
            return mt_mesh_say(glb->draft->fault, MT_TOO_LARGE, "over %d primitives", PRIMITIVES_MAX);
        status = read_primitive(glb, mt_json_item(object, "primitives", i), place);
    }
    return status;
}

/* ---- nodes --------------------------------------------------------------------------------------------- */

/* First `inner`, then `outer`. */
static mt_place3 compose(const mt_place3 *outer, const mt_place3 *inner) {
    mt_place3 both = {{0}};
    for (int column = 0; column < 4; column++)
        for (int row = 0; row < 3; row++) {
            double sum = column == 3 ? outer->m[9 + row] : 0;
            for (int k = 0; k < 3; k++) sum += outer->m[3 * k + row] * inner->m[3 * column + k];
            both.m[3 * column + row] = sum;
        }
    return both;
}

/* Of a unit quaternion. */
static mt_place3 scaled_and_turned(const double q[4], const double scale[3], const double moved[3]) {
    double x = q[0], y = q[1], z = q[2], w = q[3];
    mt_place3 place = {{1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y),
                        2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x),
                        2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y), moved[0], moved[1],
                        moved[2]}};
    for (int i = 0; i < 9; i++) place.m[i] *= scale[i / 3];
    return place;
}

/* Fills in a member that is there; false for one that is not as long as it should be. */
static bool read_member(const mt_json_value *node, const char *key, int count, double *numbers) {
    return !mt_json_member(node, key) || mt_json_numbers(node, key, count, numbers);
}

static mt_status read_place(const mt_glb *glb, const mt_json_value *node, mt_place3 *place) {
    double matrix[16], moved[3] = {0}, q[4] = {0, 0, 0, 1}, scale[3] = {1, 1, 1};
    if (mt_json_member(node, "matrix")) {
        if (!mt_json_numbers(node, "matrix", 16, matrix)) return refuse(glb, "a node's matrix is damaged");
        for (int i = 0; i < 12; i++) place->m[i] = matrix[i / 3 * 4 + i % 3];
        return MT_OK;
    }
    if (!read_member(node, "translation", 3, moved) || !read_member(node, "rotation", 4, q) ||
        !read_member(node, "scale", 3, scale))
        return refuse(glb, "a node's place is damaged");
    *place = scaled_and_turned(q, scale, moved);
    return MT_OK;
}

static mt_status read_node(mt_glb *glb, int index, const mt_place3 *above, int level) {
    const mt_json_value *node = mt_json_item(glb->json, "nodes", index);
    mt_place3 own;
    if (!node) return refuse(glb, "a node is not there");
    if (glb->seen[index]) return refuse(glb, "a node stands below two others, or below itself");
    if (level == LEVELS_MAX) return refuse(glb, "over 256 levels of nodes");
    glb->seen[index] = true;
    mt_status status = read_place(glb, node, &own);
    if (status != MT_OK) return status;
    mt_place3 place = compose(above, &own);
    if (mt_json_member(node, "mesh")) status = read_mesh(glb, mt_json_index(node, "mesh", -1), &place);
    const mt_json_value *children = mt_json_member(node, "children");
    for (int i = 0; i < mt_json_count(node, "children") && status == MT_OK; i++) {
        const mt_json_value *child = children->items[i];
        bool whole = child->kind == MT_JSON_NUMBER && child->number >= 0 && child->number < INT32_MAX;
        status = read_node(glb, whole ? (int)child->number : -1, &place, level + 1);
    }
    return status;
}

/* The scene that is shown first. */
static mt_status read_scene(mt_glb *glb) {
    const mt_json_value *scene = mt_json_item(glb->json, "scenes", mt_json_index(glb->json, "scene", 0));
    const mt_json_value *roots = mt_json_member(scene, "nodes");
    if (!scene) return refuse(glb, "it has no scene");
    if (mt_json_count(glb->json, "nodes") > NODES_MAX)
        return mt_mesh_say(glb->draft->fault, MT_TOO_LARGE, "over %d nodes", NODES_MAX);
    glb->seen = mt_arena_new(&glb->arena, (size_t)mt_json_count(glb->json, "nodes") + 1, sizeof *glb->seen);
    if (!glb->seen) return MT_NO_MEMORY;
    mt_status status = MT_OK;
    for (int i = 0; i < mt_json_count(scene, "nodes") && status == MT_OK; i++) {
        const mt_json_value *root = roots->items[i];
        bool whole = root->kind == MT_JSON_NUMBER && root->number >= 0 && root->number < INT32_MAX;
        status = read_node(glb, whole ? (int)root->number : -1, &nowhere, 0);
    }
    return status;
}

mt_status mt_read_glb(const uint8_t *bytes, size_t length, mt_draft *draft) {
    mt_glb glb = {.draft = draft};
    mt_status status = read_chunks(&glb, bytes, length);
    if (status == MT_OK) status = check_document(&glb);
    if (status == MT_OK) status = read_scene(&glb);
    mt_arena_release(&glb.arena);
    return status;
}
