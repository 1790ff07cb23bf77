/* A tree of boxes, halved along the longest side; pairs of triangles with boxes that meet are compared exactly. */
#include "mesh/crossing.h"

#include <stdlib.h>

#include "mesh/contact.h"

/* Triangles of a leaf; how many pairs are compared at the most. */
enum { LEAF = 4 };
#define PAIRS_MAX ((int64_t)1 << 27)

typedef struct mt_box3 {
    int32_t low[3], high[3];
} mt_box3;

/* Node 0 is the root; a leaf has the triangles `first` to `first + count`. */
typedef struct mt_box_node {
    mt_box3 box;
    int first, count;
    int children[2]; /* 0 in a leaf */
} mt_box_node;

typedef struct mt_box_tree {
    const mt_surface *surface;
    const mt_grid_mesh *grid;
    mt_box3 *boxes; /* of each triangle */
    int *order;     /* triangles, as the leaves have them */
    int n_nodes;
    mt_box_node *nodes;
    int64_t pairs; /* compared so far */
    int found[2];  /* triangles that touch; the first is -1 as long as there are none */
} mt_box_tree;

/* ---- the tree ------------------------------------------------------------------------------------------- */

static void take_in(mt_box3 *box, const mt_box3 *other) {
    for (int i = 0; i < 3; i++) {
        if (other->low[i] < box->low[i]) box->low[i] = other->low[i];
        if (other->high[i] > box->high[i]) box->high[i] = other->high[i];
    }
}

static mt_box3 box_of(const mt_grid_mesh *grid, int triangle) {
    mt_box3 box = {{INT32_MAX, INT32_MAX, INT32_MAX}, {INT32_MIN, INT32_MIN, INT32_MIN}};
    for (int i = 0; i < 3; i++) {
        mt_grid_point p = grid->at[grid->mesh.triangles[triangle].at[i]];
        mt_box3 point = {{p.x, p.y, p.z}, {p.x, p.y, p.z}};
        take_in(&box, &point);
    }
    return box;
}

static bool boxes_meet(const mt_box3 *a, const mt_box3 *b) {
    for (int i = 0; i < 3; i++)
        if (a->low[i] > b->high[i] || b->low[i] > a->high[i]) return false;
    return true;
}

/* Twice the middle of a triangle's box. */
static int64_t middle_of(const mt_box_tree *tree, int triangle, int axis) {
    const mt_box3 *box = &tree->boxes[triangle];
    return (int64_t)box->low[axis] + box->high[axis];
}

static bool before(const mt_box_tree *tree, int a, int b, int axis) {
    int64_t left = middle_of(tree, a, axis), right = middle_of(tree, b, axis);
    return left != right ? left < right : a < b;
}

/* Puts the `half` first of `count` triangles along the axis before the others (Hoare's selection). */
static void halve(const mt_box_tree *tree, int *order, int count, int half, int axis) {
    int low = 0, high = count - 1;
    while (low < high) {
        int pivot = order[low + (high - low) / 2], i = low, k = high;
        while (i <= k) {
            while (before(tree, order[i], pivot, axis)) i++;
            while (before(tree, pivot, order[k], axis)) k--;
            if (i > k) break;
            int swapped = order[i];
            order[i++] = order[k];
            order[k--] = swapped;
        }
        if (half <= k)
            high = k;
        else if (half >= i)
            low = i;
        else
            return;
    }
}

static int longest_side(const mt_box3 *box) {
    int longest = 0;
    for (int i = 1; i < 3; i++)
        if (box->high[i] - box->low[i] > box->high[longest] - box->low[longest]) longest = i;
    return longest;
}

/* The node of these triangles, and all below it; at most as many as twice the triangles. */
static int make_node(mt_box_tree *tree, int first, int count) {
    int number = tree->n_nodes++, half = count / 2;
    mt_box_node node = {.box = tree->boxes[tree->order[first]], .first = first, .count = count};
    for (int i = 1; i < count; i++) take_in(&node.box, &tree->boxes[tree->order[first + i]]);
    if (count > LEAF) {
        halve(tree, tree->order + first, count, half, longest_side(&node.box));
        node.children[0] = make_node(tree, first, half);
        node.children[1] = make_node(tree, first + half, count - half);
    }
    tree->nodes[number] = node;
    return number;
}

static mt_status make_tree(const mt_surface *surface, mt_arena *arena, mt_box_tree *tree) {
    const mt_grid_mesh *grid = surface->grid;
    int count = grid->mesh.n_triangles;
    *tree = (mt_box_tree){.surface = surface, .grid = grid, .found = {-1, -1}};
    tree->boxes = mt_arena_new(arena, (size_t)count, sizeof *tree->boxes);
    tree->order = mt_arena_new(arena, (size_t)count, sizeof *tree->order);
    tree->nodes = mt_arena_new(arena, 2 * (size_t)count, sizeof *tree->nodes);
    if (!tree->boxes || !tree->order || !tree->nodes) return MT_NO_MEMORY;
    for (int i = 0; i < count; i++) {
        tree->boxes[i] = box_of(grid, i);
        tree->order[i] = i;
    }
    make_node(tree, 0, count);
    return MT_OK;
}

/* ---- pairs ---------------------------------------------------------------------------------------------- */

static bool is_done(const mt_box_tree *tree) {
    return tree->found[0] >= 0 || tree->pairs > PAIRS_MAX;
}

static bool has_corner(const mt_box_tree *tree, int triangle, int point) {
    const int *at = tree->grid->mesh.triangles[triangle].at;
    return at[0] == point || at[1] == point || at[2] == point;
}

/* Whether two triangles have a corner in common, or an edge from a corner of one to a corner of the other. */
static bool are_neighbours(mt_box_tree *tree, int a, int b) {
    const mt_surface *surface = tree->surface;
    for (int first = 3 * a; first < 3 * a + 3; first++) {
        int e = first;
        if (has_corner(tree, b, mt_surface_start(surface, e))) return true;
        do {
            int before = mt_surface_next(mt_surface_next(e));
            tree->pairs++;
            if (has_corner(tree, b, mt_surface_start(surface, before))) return true;
            e = surface->twins[before];
        } while (e != first);
    }
    return false;
}

static void compare_triangles(mt_box_tree *tree, int a, int b) {
    const mt_triangle *triangles = tree->grid->mesh.triangles;
    tree->pairs++;
    if (is_done(tree) || !boxes_meet(&tree->boxes[a], &tree->boxes[b]) ||
        !mt_triangles_touch(tree->grid, triangles[a], triangles[b]))
        return;
    if (mt_triangles_slip(tree->grid, triangles[a], triangles[b]) && are_neighbours(tree, a, b)) return;
    tree->found[0] = a < b ? a : b;
    tree->found[1] = a < b ? b : a;
}

static void compare_leaves(mt_box_tree *tree, const mt_box_node *a, const mt_box_node *b) {
    for (int i = 0; i < a->count; i++)
        for (int k = a == b ? i + 1 : 0; k < b->count; k++)
            compare_triangles(tree, tree->order[a->first + i], tree->order[b->first + k]);
}

static void compare_nodes(mt_box_tree *tree, int left, int right) {
    const mt_box_node *a = &tree->nodes[left], *b = &tree->nodes[right];
    if (is_done(tree) || !boxes_meet(&a->box, &b->box)) return;
    tree->pairs++;
    if (!a->children[0] && !b->children[0]) {
        compare_leaves(tree, a, b);
    } else if (left == right) {
        compare_nodes(tree, a->children[0], a->children[0]);
        compare_nodes(tree, a->children[0], a->children[1]);
        compare_nodes(tree, a->children[1], a->children[1]);
    } else if (!b->children[0] || (a->children[0] && a->count >= b->count)) {
        compare_nodes(tree, a->children[0], right);
        compare_nodes(tree, a->children[1], right);
    } else {
        compare_nodes(tree, left, b->children[0]);
        compare_nodes(tree, left, b->children[1]);
    }
}

static void middle_place(const mt_mesh *mesh, int triangle, char text[MT_PLACE_ROOM]) {
    mt_vector3 sum = {0};
    for (int i = 0; i < 3; i++) {
        mt_vector3 p = mesh->points[mesh->triangles[triangle].at[i]];
        sum = (mt_vector3){sum.x + p.x / 3, sum.y + p.y / 3, sum.z + p.z / 3};
    }
    mt_place_write(sum, text);
}

mt_status mt_surface_check_crossings(const mt_surface *surface, mt_arena *arena, mt_mesh_fault *fault) {
    char first[MT_PLACE_ROOM], second[MT_PLACE_ROOM];
    mt_arena_place place = mt_arena_mark(arena);
    mt_box_tree tree;
    mt_status status = make_tree(surface, arena, &tree);
    if (status == MT_OK) compare_nodes(&tree, 0, 0);
    mt_arena_rewind(arena, place);
    if (status != MT_OK) return status;
    if (tree.found[0] < 0 && tree.pairs <= PAIRS_MAX) return MT_OK;
    if (tree.found[0] < 0)
        return mt_mesh_say(fault, MT_TOO_LARGE, "too many of its triangles lie close together");
    middle_place(&surface->grid->mesh, tree.found[0], first);
    middle_place(&surface->grid->mesh, tree.found[1], second);
    return mt_mesh_say(fault, MT_NOT_SOLID, "the triangles with their middles at %s and %s cross or touch",
                       first, second);
}
