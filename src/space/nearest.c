/* A tree of boxes, halved along its longest side at the middle triangle, so that it is at most log2(n) deep; a search visits the nearer
 * half first, and leaves out boxes that are farther than what is found. */
#include "space/nearest.h"

#include <stdlib.h>

#include "space/vector.h"

enum { LEAF = 4, DEPTH = 64 };

struct mt_nearest_node {
    mt_vector3 low, high;
    int first, count; /* of the order */
    int child;        /* the first of two, or 0 for a leaf */
};

double mt_triangle_distance(mt_vector3 p, mt_vector3 a, mt_vector3 b, mt_vector3 c) {
    mt_vector3 corners[3] = {a, b, c}, normal = mt_cross3(mt_minus3(b, a), mt_minus3(c, a));
    double least = INFINITY, area2 = mt_dot3(normal, normal);
    bool over = area2 > 0; /* p is over the triangle, not beside it */
    for (int i = 0; i < 3; i++) {
        mt_vector3 from = corners[i], edge = mt_minus3(corners[(i + 1) % 3], from), to = mt_minus3(p, from);
        double length2 = mt_dot3(edge, edge);
        double along = length2 > 0 ? fmin(fmax(mt_dot3(to, edge) / length2, 0), 1) : 0;
        least = fmin(least, mt_length3(mt_minus3(to, mt_times3(along, edge))));
        if (mt_dot3(mt_cross3(normal, edge), to) < 0) over = false;
    }
    return over ? fmin(least, fabs(mt_dot3(normal, mt_minus3(p, a))) / sqrt(area2)) : least;
}

static mt_vector3 lower(mt_vector3 p, mt_vector3 q) {
    return (mt_vector3){fmin(p.x, q.x), fmin(p.y, q.y), fmin(p.z, q.z)};
}

static mt_vector3 higher(mt_vector3 p, mt_vector3 q) {
    return (mt_vector3){fmax(p.x, q.x), fmax(p.y, q.y), fmax(p.z, q.z)};
}

/* A triangle by three times its middle along the side at hand. */
typedef struct mt_keyed {
    double key;
    int triangle;
} mt_keyed;

static int by_key(const void *p, const void *q) {
    const mt_keyed *x = p, *y = q;
    return x->key != y->key ? (x->key > y->key) - (x->key < y->key)
                            : (x->triangle > y->triangle) - (x->triangle < y->triangle);
}

static void bound(const mt_nearest_tree *tree, mt_nearest_node *node) {
    node->low = (mt_vector3){INFINITY, INFINITY, INFINITY};
    node->high = (mt_vector3){-INFINITY, -INFINITY, -INFINITY};
    for (int i = node->first; i < node->first + node->count; i++)
        for (int k = 0; k < 3; k++) {
            mt_vector3 p = tree->points[tree->triangles[tree->order[i]].at[k]];
            node->low = lower(node->low, p);
            node->high = higher(node->high, p);
        }
}

static void halve(mt_nearest_tree *tree, mt_nearest_node *node, mt_keyed *keyed) {
    mt_vector3 sides = mt_minus3(node->high, node->low);
    mt_vector3 axis = {0, 0, 1};
    if (sides.x >= sides.y && sides.x >= sides.z)
        axis = (mt_vector3){1, 0, 0};
    else if (sides.y >= sides.z)
        axis = (mt_vector3){0, 1, 0};
    for (int i = 0; i < node->count; i++) {
        const int *at = tree->triangles[tree->order[node->first + i]].at;
        mt_vector3 sum = mt_plus3(tree->points[at[0]], mt_plus3(tree->points[at[1]], tree->points[at[2]]));
        keyed[i] = (mt_keyed){mt_dot3(axis, sum), tree->order[node->first + i]};
    }
    qsort(keyed, (size_t)node->count, sizeof *keyed, by_key);
    for (int i = 0; i < node->count; i++) tree->order[node->first + i] = keyed[i].triangle;
    node->child = tree->n_nodes;
    int half = node->count / 2;
    tree->nodes[tree->n_nodes++] = (mt_nearest_node){.first = node->first, .count = half};
    tree->nodes[tree->n_nodes++] =
        (mt_nearest_node){.first = node->first + half, .count = node->count - half};
}

mt_status mt_nearest_tree_of(mt_arena *arena, const mt_vector3 *points, const mt_triangle *triangles,
                             int n_triangles, mt_nearest_tree *tree) {
    mt_nearest_tree made = {points, triangles, mt_arena_new(arena, (size_t)n_triangles, sizeof(int)),
                            mt_arena_new(arena, 2 * (size_t)n_triangles + 1, sizeof(mt_nearest_node)), 1};
    mt_keyed *keyed = mt_arena_new(arena, (size_t)n_triangles, sizeof *keyed);
    if (!made.order || !made.nodes || !keyed) return MT_NO_MEMORY;
    for (int t = 0; t < n_triangles; t++) made.order[t] = t;
    made.nodes[0] = (mt_nearest_node){.count = n_triangles};
    for (int i = 0; i < made.n_nodes; i++) {
        bound(&made, &made.nodes[i]);
        if (made.nodes[i].count > LEAF) halve(&made, &made.nodes[i], keyed);
    }
    *tree = made;
    return MT_OK;
}

static double box_distance(const mt_nearest_node *node, mt_vector3 p) {
    mt_vector3 zero = {0, 0, 0};
    return mt_length3(higher(zero, higher(mt_minus3(node->low, p), mt_minus3(p, node->high))));
}

double mt_nearest(const mt_nearest_tree *tree, mt_vector3 p, int *triangle) {
    int stack[DEPTH], depth = 0;
    double least = INFINITY;
    *triangle = 0;
    stack[depth++] = 0;
    while (depth > 0) {
        const mt_nearest_node *node = &tree->nodes[stack[--depth]];
        if (box_distance(node, p) >= least) continue;
        if (node->child) {
            int near = node->child, far = node->child + 1;
            if (box_distance(&tree->nodes[far], p) < box_distance(&tree->nodes[near], p)) {
                near = node->child + 1;
                far = node->child;
            }
            stack[depth++] = far;
            stack[depth++] = near;
            continue;
        }
        for (int i = node->first; i < node->first + node->count; i++) {
            const int *at = tree->triangles[tree->order[i]].at;
            double distance =
                mt_triangle_distance(p, tree->points[at[0]], tree->points[at[1]], tree->points[at[2]]);
            if (distance >= least) continue;
            least = distance;
            *triangle = tree->order[i];
        }
    }
    return least;
}
