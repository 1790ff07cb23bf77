#include "support/solids.h"

#include "space/vector.h"

static mt_mesh mesh_of(mt_arena *arena, int n_points, int n_triangles, const int (*triangles)[3]) {
    mt_mesh mesh = {n_points, n_triangles, mt_arena_new(arena, (size_t)n_points, sizeof(mt_vector3)),
                    mt_arena_new(arena, (size_t)n_triangles, sizeof(mt_triangle))};
    if (!mesh.points || !mesh.triangles) return (mt_mesh){0};
    for (int t = 0; t < n_triangles; t++)
        mesh.triangles[t] = (mt_triangle){{triangles[t][0], triangles[t][1], triangles[t][2]}};
    return mesh;
}

mt_mesh mt_test_box(mt_arena *arena, mt_vector3 low, mt_vector3 high) {
    static const int triangles[12][3] = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                                         {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    mt_mesh mesh = mesh_of(arena, 8, 12, triangles);
    for (int i = 0; i < mesh.n_points; i++)
        mesh.points[i] = (mt_vector3){i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z};
    return mesh;
}

mt_mesh mt_test_block(mt_arena *arena) {
    static const double corners[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    int triangles[32][3], n = 0;
    for (int i = 0; i < 4; i++) {
        int k = (i + 1) % 4; /* outer points at y = -0.4 and 0.4 are 0 and 8 on, the hole's 4 and 12 */
        int faces[4][4] = {{i, k, 8 + k, 8 + i},
                           {4 + k, 4 + i, 12 + i, 12 + k},
                           {k, i, 4 + i, 4 + k},
                           {8 + i, 8 + k, 12 + k, 12 + i}};
        for (int f = 0; f < 4; f++)
            for (int half = 0; half < 2; half++, n++)
                for (int c = 0; c < 3; c++) triangles[n][c] = faces[f][c == 0 ? 0 : c + half];
    }
    for (int t = 0; t < n; t++) { /* y points the other way */
        int swap = triangles[t][1];
        triangles[t][1] = triangles[t][2];
        triangles[t][2] = swap;
    }
    mt_mesh mesh = mesh_of(arena, 16, 32, (const int(*)[3])triangles);
    for (int i = 0; i < mesh.n_points; i++) {
        double size = i % 8 < 4 ? 1 : 0.45;
        mesh.points[i] = (mt_vector3){size * corners[i % 4][0], i < 8 ? -0.4 : 0.4, size * corners[i % 4][1]};
    }
    return mesh;
}

mt_mesh mt_random_star(mt_random *random, mt_arena *arena, double rough) {
    static const int faces[8][3] = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                    {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    static const mt_vector3 tips[6] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    mt_vector3 points[18];
    int triangles[32][3], middle[6][6] = {{0}}, n_points = 6, n = 0;
    for (int i = 0; i < 6; i++) points[i] = tips[i];
    for (int f = 0; f < 8; f++) {
        int m[3];
        for (int i = 0; i < 3; i++) {
            int p = faces[f][i], q = faces[f][(i + 1) % 3];
            if (!middle[p][q]) {
                mt_vector3 sum = mt_plus3(tips[p], tips[q]);
                points[n_points] = mt_times3(1 / mt_length3(sum), sum);
                middle[p][q] = middle[q][p] = n_points++;
            }
            m[i] = middle[p][q];
        }
        int parts[4][3] = {{faces[f][0], m[0], m[2]},
                           {m[0], faces[f][1], m[1]},
                           {m[2], m[1], faces[f][2]},
                           {m[0], m[1], m[2]}};
        for (int i = 0; i < 4; i++, n++)
            for (int c = 0; c < 3; c++) triangles[n][c] = parts[i][c];
    }
    mt_mesh mesh = mesh_of(arena, 18, 32, (const int(*)[3])triangles);
    for (int i = 0; i < mesh.n_points; i++)
        mesh.points[i] = mt_times3(1 + rough * (2 * mt_random_unit(random) - 1), points[i]);
    return mesh;
}

double mt_test_turns(const mt_vector3 *points, const mt_triangle *triangles, int n, mt_vector3 p) {
    double sum = 0;
    for (int t = 0; t < n; t++) {
        mt_vector3 a = mt_minus3(points[triangles[t].at[0]], p), b = mt_minus3(points[triangles[t].at[1]], p),
                   c = mt_minus3(points[triangles[t].at[2]], p);
        double la = mt_length3(a), lb = mt_length3(b), lc = mt_length3(c);
        sum += atan2(mt_dot3(a, mt_cross3(b, c)),
                     la * lb * lc + mt_dot3(a, b) * lc + mt_dot3(b, c) * la + mt_dot3(c, a) * lb);
    }
    return sum / (2 * M_PI);
}
