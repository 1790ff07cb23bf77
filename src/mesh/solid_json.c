/* What is between two solids, as data.
 *
 *     {
 *       "format": "morphotype solid",
 *       "version": 1,
 *       "method": "joint",
 *       "a": SIDE,
 *       "b": SIDE,
 *       "rotation": {"degrees": 90, "axis": [0, 1, 0]},         formula (5); left out where there is none
 *       "links": [{"a": 0, "b": 2, "points": 32, "triangles": 60}, …]    piece 0 of A goes with piece 2 of B
 *     }
 *
 * A SIDE is one of the solids:
 *
 *     {
 *       "file": NAME,
 *       "points": 16, "triangles": 32, "volume": 3.828,
 *       "low": [-1, -0.6, -1], "high": [1, 0.6, 1],             the box
 *       "components": 1,
 *       "pieces": [{"component": 0, "volume": 0.9, "points": 8, "triangles": 12}, …]
 *     }
 *
 * Lengths are in the units of the files; indices count from 0. */
#include <math.h>

#include "base/json.h"
#include "mesh/solid_blend.h"

enum { DIGITS = 9 };

static double volume_of(const mt_mesh *mesh) {
    double sum = 0;
    mt_vector3 o = mesh->n_points > 0 ? mesh->points[0] : (mt_vector3){0};
    for (int i = 0; i < mesh->n_triangles; i++) {
        const int *at = mesh->triangles[i].at;
        mt_vector3 a = mesh->points[at[0]], b = mesh->points[at[1]], c = mesh->points[at[2]];
        a = (mt_vector3){a.x - o.x, a.y - o.y, a.z - o.z};
        b = (mt_vector3){b.x - o.x, b.y - o.y, b.z - o.z};
        c = (mt_vector3){c.x - o.x, c.y - o.y, c.z - o.z};
        sum += a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) + a.z * (b.x * c.y - b.y * c.x);
    }
    return sum / 6;
}

static void write_place(mt_json *json, const char *key, mt_vector3 place) {
    mt_json_one_line(json);
    mt_json_array(json, key);
    mt_json_real(json, NULL, place.x, DIGITS);
    mt_json_real(json, NULL, place.y, DIGITS);
    mt_json_real(json, NULL, place.z, DIGITS);
    mt_json_array_end(json);
}

static void write_box(mt_json *json, const mt_mesh *mesh) {
    mt_vector3 low = mesh->points[0], high = low;
    for (int i = 1; i < mesh->n_points; i++) {
        mt_vector3 p = mesh->points[i];
        low = (mt_vector3){fmin(low.x, p.x), fmin(low.y, p.y), fmin(low.z, p.z)};
        high = (mt_vector3){fmax(high.x, p.x), fmax(high.y, p.y), fmax(high.z, p.z)};
    }
    write_place(json, "low", low);
    write_place(json, "high", high);
}

static void write_piece(mt_json *json, const mt_mesh *piece, int component) {
    mt_json_one_line(json);
    mt_json_object(json, NULL);
    mt_json_int(json, "component", component);
    mt_json_real(json, "volume", volume_of(piece), DIGITS);
    mt_json_int(json, "points", piece->n_points);
    mt_json_int(json, "triangles", piece->n_triangles);
    mt_json_object_end(json);
}

static void write_side(mt_json *json, const char *key, const char *name, const mt_mesh *mesh,
                       const mt_solid_side *side) {
    mt_json_object(json, key);
    mt_json_text(json, "file", name);
    mt_json_int(json, "points", mesh->n_points);
    mt_json_int(json, "triangles", mesh->n_triangles);
    mt_json_real(json, "volume", volume_of(mesh), DIGITS);
    write_box(json, mesh);
    mt_json_int(json, "components", side->n_components);
    mt_json_array(json, "pieces");
    for (int i = 0; i < side->n_pieces; i++) write_piece(json, &side->pieces[i], side->component_of[i]);
    mt_json_array_end(json);
    mt_json_object_end(json);
}

static void write_links(mt_json *json, const mt_solid_morph *morph) {
    mt_json_array(json, "links");
    for (int i = 0; i < morph->n_links; i++) {
        const mt_solid_link *link = &morph->links[i];
        mt_json_one_line(json);
        mt_json_object(json, NULL);
        mt_json_int(json, "a", link->piece_a);
        mt_json_int(json, "b", link->piece_b);
        mt_json_int(json, "points", link->n_points);
        mt_json_int(json, "triangles", link->n_triangles);
        mt_json_object_end(json);
    }
    mt_json_array_end(json);
}

static void write_rotation(mt_json *json, const mt_solid_morph *morph) {
    mt_json_object(json, "rotation");
    mt_json_real(json, "degrees", morph->degrees, DIGITS);
    write_place(json, "axis", morph->axis);
    mt_json_object_end(json);
}

mt_status mt_solid_blend_json(const mt_solid_blend *blend, const char *name_a, const char *name_b,
                              mt_buffer *text) {
    const mt_solid_morph *morph = &blend->morph;
    mt_json json = {0};
    mt_json_object(&json, NULL);
    mt_json_text(&json, "format", "morphotype solid");
    mt_json_int(&json, "version", 1);
    mt_json_text(&json, "method", blend->params.method == MT_METHOD_PAPER ? "paper" : "joint");
    write_side(&json, "a", name_a, &blend->a, &morph->a);
    write_side(&json, "b", name_b, &blend->b, &morph->b);
    if (morph->degrees != 0) write_rotation(&json, morph);
    write_links(&json, morph);
    mt_json_object_end(&json);
    if (json.status != MT_OK) mt_buffer_free(&json.text);
    *text = json.text;
    return json.status;
}
