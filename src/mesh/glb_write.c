/* Khronos, "glTF 2.0 Specification": 3.7.2.2 morph targets, 3.11 animations, 4 the container. */
#include "mesh/glb_write.h"

#include <math.h>
#include <string.h>

#include "arithmetic/angles.h"
#include "base/json.h"

enum {
    ARRAY_BUFFER = 34962,
    ELEMENT_ARRAY_BUFFER = 34963,
    TYPE_U16 = 5123,
    TYPE_U32 = 5125,
    TYPE_FLOAT = 5126
};

/* From one key of a rotation to the next. */
#define TURN_MAX 90.0

/* One accessor, with a buffer view of its own. */
typedef struct mt_glb_part {
    const char *type;
    int component, count, target; /* target 0: none */
    size_t offset, length;
    int ranges; /* components that have their least and largest values told */
    float low[3], high[3];
} mt_glb_part;

typedef struct mt_glb_writing {
    const mt_glb_content *content;
    mt_buffer binary;
    mt_status status;
    int n_parts;
    mt_glb_part parts[8];
    int keys; /* of the animation */
} mt_glb_writing;

/* ---- the binary chunk ----------------------------------------------------------------------------------- */

static void add(mt_glb_writing *w, const void *bytes, size_t length) {
    if (w->status == MT_OK) w->status = mt_buffer_add(&w->binary, bytes, length);
}

static void add_whole(mt_glb_writing *w, uint32_t value, size_t size) {
    const uint8_t bytes[4] = {(uint8_t)value, (uint8_t)(value >> 8), (uint8_t)(value >> 16),
                              (uint8_t)(value >> 24)};
    add(w, bytes, size);
}

static void add_float(mt_glb_writing *w, double value) {
    float single = (float)value;
    uint32_t bits;
    memcpy(&bits, &single, sizeof bits);
    add_whole(w, bits, sizeof bits);
}

static mt_glb_part *begin_part(mt_glb_writing *w, const char *type, int component, int count, int target) {
    mt_glb_part *part = &w->parts[w->n_parts++];
    *part = (mt_glb_part){type, component, count, target, w->binary.length, 0, 0, {0}, {0}};
    return part;
}

static void end_part(mt_glb_writing *w, mt_glb_part *part) {
    part->length = w->binary.length - part->offset;
    while (w->status == MT_OK && w->binary.length % 4 != 0) add_whole(w, 0, 1);
}

static void take_in(mt_glb_part *part, int component, double value) {
    float single = (float)value;
    if (!(single >= part->low[component])) part->low[component] = single;
    if (!(single <= part->high[component])) part->high[component] = single;
}

/* Points, or the ways from them to other points. */
static void add_places(mt_glb_writing *w, const mt_vector3 *from, const mt_vector3 *to) {
    int count = w->content->n_points;
    mt_glb_part *part = begin_part(w, "VEC3", TYPE_FLOAT, count, ARRAY_BUFFER);
    part->ranges = 3;
    for (int k = 0; k < 3; k++) part->low[k] = part->high[k] = NAN;
    for (int i = 0; i < count; i++) {
        double at[3] = {from[i].x, from[i].y, from[i].z};
        if (to) at[0] = to[i].x - at[0], at[1] = to[i].y - at[1], at[2] = to[i].z - at[2];
        for (int k = 0; k < 3; k++) {
            add_float(w, at[k]);
            take_in(part, k, at[k]);
        }
    }
    end_part(w, part);
}

static void add_indices(mt_glb_writing *w) {
    const mt_glb_content *content = w->content;
    bool small = content->n_points < 65535;
    mt_glb_part *part =
        begin_part(w, "SCALAR", small ? TYPE_U16 : TYPE_U32, 3 * content->n_triangles, ELEMENT_ARRAY_BUFFER);
    for (int i = 0; i < 3 * content->n_triangles; i++)
        add_whole(w, (uint32_t)content->triangles[i / 3].at[i % 3], small ? 2 : 4);
    end_part(w, part);
}

/* ---- the animation -------------------------------------------------------------------------------------- */

/* Steps from weight 0 to weight 1. */
static int steps_of(const mt_glb_content *content) {
    double turns = ceil(fabs(content->degrees) / TURN_MAX);
    return turns > 1 ? (int)turns : 1;
}

static double weight_at(const mt_glb_writing *w, int key) {
    int steps = steps_of(w->content);
    return (double)(key <= steps ? key : 2 * steps - key) / steps;
}

static void add_times(mt_glb_writing *w) {
    mt_glb_part *part = begin_part(w, "SCALAR", TYPE_FLOAT, w->keys, 0);
    double step = w->content->duration / steps_of(w->content);
    part->ranges = 1;
    part->low[0] = part->high[0] = NAN;
    for (int i = 0; i < w->keys; i++) {
        add_float(w, step * i);
        take_in(part, 0, step * i);
    }
    end_part(w, part);
}

static void add_weights(mt_glb_writing *w) {
    mt_glb_part *part = begin_part(w, "SCALAR", TYPE_FLOAT, w->keys, 0);
    for (int i = 0; i < w->keys; i++) add_float(w, weight_at(w, i));
    end_part(w, part);
}

/* The middle about which it turns, or the way back to the origin from there. */
static mt_vector3 middle_at(const mt_glb_content *content, double weight, double sign) {
    mt_vector3 a = content->middle_a, b = content->middle_b;
    return (mt_vector3){sign * (a.x + weight * (b.x - a.x)), sign * (a.y + weight * (b.y - a.y)),
                        sign * (a.z + weight * (b.z - a.z))};
}

static void add_middles(mt_glb_writing *w, double sign) {
    mt_glb_part *part = begin_part(w, "VEC3", TYPE_FLOAT, w->keys, 0);
    for (int i = 0; i < w->keys; i++) {
        mt_vector3 middle = middle_at(w->content, weight_at(w, i), sign);
        add_float(w, middle.x);
        add_float(w, middle.y);
        add_float(w, middle.z);
    }
    end_part(w, part);
}

static void add_rotations(mt_glb_writing *w) {
    mt_glb_part *part = begin_part(w, "VEC4", TYPE_FLOAT, w->keys, 0);
    mt_vector3 axis = w->content->axis;
    for (int i = 0; i < w->keys; i++) {
        double half = weight_at(w, i) * w->content->degrees * M_PI / 360;
        add_float(w, axis.x * mt_sin(half));
        add_float(w, axis.y * mt_sin(half));
        add_float(w, axis.z * mt_sin(half));
        add_float(w, mt_cos(half));
    }
    end_part(w, part);
}

/* ---- the JSON chunk ------------------------------------------------------------------------------------- */

/* Accessors by their numbers; those of a mesh that does not move end with the indices, and without a rotation with the weights. */
enum { PLACES, INDICES, TARGET, TIMES, WEIGHTS, MIDDLES, ROTATIONS, BACK };

static void write_numbers(mt_json *json, const char *key, const float *numbers, int count) {
    mt_json_array(json, key);
    for (int i = 0; i < count; i++) mt_json_real(json, NULL, (double)numbers[i], 9);
    mt_json_array_end(json);
}

static void write_place(mt_json *json, mt_vector3 place) {
    const float numbers[3] = {(float)place.x, (float)place.y, (float)place.z};
    write_numbers(json, "translation", numbers, 3);
}

static void write_int_member(mt_json *json, const char *object, const char *key, int value) {
    mt_json_object(json, object);
    mt_json_int(json, key, value);
    mt_json_object_end(json);
}

static void write_head(mt_json *json) {
    mt_json_object(json, "asset");
    mt_json_text(json, "version", "2.0");
    mt_json_text(json, "generator", "Morphotype " MORPHOTYPE_VERSION);
    mt_json_object_end(json);
    mt_json_int(json, "scene", 0);
    mt_json_array(json, "scenes");
    mt_json_object(json, NULL);
    mt_json_array(json, "nodes");
    mt_json_int(json, NULL, 0);
    mt_json_array_end(json);
    mt_json_object_end(json);
    mt_json_array_end(json);
}

/* Node 0; where the mesh turns, it stands in node 1, which brings the middle to the origin for node 0 to turn. */
static void write_nodes(mt_json *json, const mt_glb_content *content) {
    mt_json_array(json, "nodes");
    mt_json_object(json, NULL);
    if (content->degrees != 0) {
        write_place(json, middle_at(content, 0, 1));
        mt_json_array(json, "children");
        mt_json_int(json, NULL, 1);
        mt_json_array_end(json);
        mt_json_object_end(json);
        mt_json_object(json, NULL);
        write_place(json, middle_at(content, 0, -1));
    }
    mt_json_int(json, "mesh", 0);
    mt_json_object_end(json);
    mt_json_array_end(json);
}

static void write_mesh(mt_json *json, const mt_glb_content *content) {
    mt_json_array(json, "meshes");
    mt_json_object(json, NULL);
    mt_json_array(json, "primitives");
    mt_json_object(json, NULL);
    write_int_member(json, "attributes", "POSITION", PLACES);
    mt_json_int(json, "indices", INDICES);
    mt_json_int(json, "material", 0);
    if (content->at_b) {
        mt_json_array(json, "targets");
        write_int_member(json, NULL, "POSITION", TARGET);
        mt_json_array_end(json);
    }
    mt_json_object_end(json);
    mt_json_array_end(json);
    if (content->at_b) {
        mt_json_array(json, "weights");
        mt_json_int(json, NULL, 0);
        mt_json_array_end(json);
    }
    mt_json_object_end(json);
    mt_json_array_end(json);
}

static void write_material(mt_json *json) {
    static const float colour[] = {0.7F, 0.7F, 0.7F, 1};
    mt_json_array(json, "materials");
    mt_json_object(json, NULL);
    mt_json_object(json, "pbrMetallicRoughness");
    write_numbers(json, "baseColorFactor", colour, 4);
    mt_json_int(json, "metallicFactor", 0);
    mt_json_real(json, "roughnessFactor", 0.75, 3);
    mt_json_object_end(json);
    mt_json_object_end(json);
    mt_json_array_end(json);
}

static void write_channel(mt_json *json, int sampler, int node, const char *path) {
    mt_json_object(json, NULL);
    mt_json_int(json, "sampler", sampler);
    mt_json_object(json, "target");
    mt_json_int(json, "node", node);
    mt_json_text(json, "path", path);
    mt_json_object_end(json);
    mt_json_object_end(json);
}

static void write_animation(mt_json *json, bool turns) {
    mt_json_array(json, "animations");
    mt_json_object(json, NULL);
    mt_json_array(json, "channels");
    write_channel(json, 0, turns ? 1 : 0, "weights");
    if (turns) {
        write_channel(json, MIDDLES - WEIGHTS, 0, "translation");
        write_channel(json, ROTATIONS - WEIGHTS, 0, "rotation");
        write_channel(json, BACK - WEIGHTS, 1, "translation");
    }
    mt_json_array_end(json);
    mt_json_array(json, "samplers");
    for (int output = WEIGHTS; output <= (turns ? BACK : WEIGHTS); output++) {
        mt_json_object(json, NULL);
        mt_json_int(json, "input", TIMES);
        mt_json_int(json, "output", output);
        mt_json_object_end(json);
    }
    mt_json_array_end(json);
    mt_json_object_end(json);
    mt_json_array_end(json);
}

static void write_accessors(mt_json *json, const mt_glb_writing *w) {
    mt_json_array(json, "accessors");
    for (int i = 0; i < w->n_parts; i++) {
        const mt_glb_part *part = &w->parts[i];
        mt_json_object(json, NULL);
        mt_json_int(json, "bufferView", i);
        mt_json_int(json, "componentType", part->component);
        mt_json_int(json, "count", part->count);
        mt_json_text(json, "type", part->type);
        if (part->ranges > 0) {
            write_numbers(json, "min", part->low, part->ranges);
            write_numbers(json, "max", part->high, part->ranges);
        }
        mt_json_object_end(json);
    }
    mt_json_array_end(json);
}

static void write_views(mt_json *json, const mt_glb_writing *w) {
    mt_json_array(json, "bufferViews");
    for (int i = 0; i < w->n_parts; i++) {
        mt_json_object(json, NULL);
        mt_json_int(json, "buffer", 0);
        mt_json_int(json, "byteOffset", (int64_t)w->parts[i].offset);
        mt_json_int(json, "byteLength", (int64_t)w->parts[i].length);
        if (w->parts[i].target) mt_json_int(json, "target", w->parts[i].target);
        mt_json_object_end(json);
    }
    mt_json_array_end(json);
    mt_json_array(json, "buffers");
    write_int_member(json, NULL, "byteLength", (int)w->binary.length);
    mt_json_array_end(json);
}

static mt_status write_json(const mt_glb_writing *w, mt_buffer *text) {
    mt_json json = {0};
    mt_json_one_line(&json);
    mt_json_object(&json, NULL);
    write_head(&json);
    write_nodes(&json, w->content);
    write_mesh(&json, w->content);
    write_material(&json);
    if (w->content->at_b) write_animation(&json, w->content->degrees != 0);
    write_accessors(&json, w);
    write_views(&json, w);
    mt_json_object_end(&json);
    while (json.status == MT_OK && json.text.length % 4 != 0) json.status = mt_buffer_add(&json.text, " ", 1);
    *text = json.text;
    return json.status;
}

/* ---- the container -------------------------------------------------------------------------------------- */

static void add_parts(mt_glb_writing *w) {
    const mt_glb_content *content = w->content;
    w->keys = steps_of(content) * (content->yoyo ? 2 : 1) + 1;
    add_places(w, content->at_a, NULL);
    add_indices(w);
    if (!content->at_b) return;
    add_places(w, content->at_a, content->at_b);
    add_times(w);
    add_weights(w);
    if (content->degrees == 0) return;
    add_middles(w, 1);
    add_rotations(w);
    add_middles(w, -1);
}

static mt_status add_chunk(mt_buffer *file, const char *name, const mt_buffer *chunk) {
    uint8_t head[8];
    for (int i = 0; i < 4; i++) head[i] = (uint8_t)(chunk->length >> 8 * i);
    memcpy(head + 4, name, 4);
    mt_status status = mt_buffer_add(file, head, sizeof head);
    return status == MT_OK ? mt_buffer_add(file, chunk->bytes, chunk->length) : status;
}

mt_status mt_glb_write(const mt_glb_content *content, mt_buffer *file) {
    mt_glb_writing w = {.content = content};
    mt_buffer json = {0};
    uint8_t head[12] = {'g', 'l', 'T', 'F', 2};
    *file = (mt_buffer){0};
    add_parts(&w);
    mt_status status = w.status == MT_OK ? write_json(&w, &json) : w.status;
    size_t whole = sizeof head + 8 + json.length + 8 + w.binary.length;
    for (int i = 0; i < 4; i++) head[8 + i] = (uint8_t)(whole >> 8 * i);
    if (status == MT_OK) status = mt_buffer_add(file, head, sizeof head);
    if (status == MT_OK) status = add_chunk(file, "JSON", &json);
    if (status == MT_OK) status = add_chunk(file, "BIN\0", &w.binary);
    mt_buffer_free(&json);
    mt_buffer_free(&w.binary);
    if (status != MT_OK) mt_buffer_free(file);
    return status;
}
