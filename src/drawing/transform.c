#include "drawing/transform.h"

#include <math.h>
#include <string.h>

#include "arithmetic/angles.h"
#include "base/real.h"
#include "drawing/scan.h"

#define DEGREES (3.14159265358979323846 / 180)

mt_vector mt_affine_apply(const mt_affine *m, double x, double y) {
    return (mt_vector){m->a * x + m->c * y + m->e, m->b * x + m->d * y + m->f};
}

mt_affine mt_affine_after(const mt_affine *o, const mt_affine *i) {
    return (mt_affine){o->a * i->a + o->c * i->b,        o->b * i->a + o->d * i->b,
                       o->a * i->c + o->c * i->d,        o->b * i->c + o->d * i->d,
                       o->a * i->e + o->c * i->f + o->e, o->b * i->e + o->d * i->f + o->f};
}

static mt_affine rotation(const double *v, int count) {
    double c = mt_cos(v[0] * DEGREES), s = mt_sin(v[0] * DEGREES);
    double x = count == 3 ? v[1] : 0, y = count == 3 ? v[2] : 0;
    return (mt_affine){c, s, -s, c, x - c * x + s * y, y - s * x - c * y};
}

/* One function of the list by its name and its numbers; false where these do not fit. */
static bool make(const char *name, size_t length, const double *v, int count, mt_affine *map) {
    static const char *const names[] = {"matrix", "translate", "scale", "rotate", "skewX", "skewY"};
    static const unsigned counts[] = {1 << 6,          1 << 1 | 1 << 2, 1 << 1 | 1 << 2,
                                      1 << 1 | 1 << 3, 1 << 1,          1 << 1};
    size_t kind = 0;
    while (kind < 6 && (strlen(names[kind]) != length || strncmp(name, names[kind], length) != 0)) kind++;
    if (kind == 6 || count < 1 || !(counts[kind] >> count & 1)) return false;
    switch (kind) {
    case 0: *map = (mt_affine){v[0], v[1], v[2], v[3], v[4], v[5]}; break;
    case 1: *map = (mt_affine){1, 0, 0, 1, v[0], count == 2 ? v[1] : 0}; break;
    case 2: *map = (mt_affine){v[0], 0, 0, count == 2 ? v[1] : v[0], 0, 0}; break;
    case 3: *map = rotation(v, count); break;
    case 4: *map = (mt_affine){1, 0, mt_tan(v[0] * DEGREES), 1, 0, 0}; break;
    default: *map = (mt_affine){1, mt_tan(v[0] * DEGREES), 0, 1, 0, 0}; break;
    }
    return true;
}

bool mt_transform_read(const char *text, mt_affine *map) {
    mt_affine made = {1, 0, 0, 1, 0, 0}, one;
    for (mt_scan_blanks(&text); *text; mt_scan_comma(&text)) {
        double values[6];
        int count = 0;
        const char *name = text;
        size_t length = strspn(text, "abcdefghijklmnopqrstuvwxyzXY");
        text += length;
        mt_scan_blanks(&text);
        if (*text++ != '(') return false;
        for (mt_scan_blanks(&text); *text != ')'; mt_scan_comma(&text))
            if (count == 6 || !mt_real_next(&text, &values[count++])) return false;
        text++;
        if (!make(name, length, values, count, &one)) return false;
        made = mt_affine_after(&made, &one);
    }
    *map = made;
    return true;
}

bool mt_view_read(const char *text, mt_view *view) {
    double v[4];
    if (mt_scan_numbers(text, v, 4) != 4 || !(v[2] > 0 && v[3] > 0)) return false;
    *view = (mt_view){v[0], v[1], v[2], v[3]};
    return true;
}

mt_affine mt_view_map(const mt_view *outer, const mt_view *inner, bool stretched) {
    double x = outer->width / inner->width, y = outer->height / inner->height;
    if (!stretched) x = y = fmin(x, y);
    return (mt_affine){x,
                       0,
                       0,
                       y,
                       outer->x + outer->width / 2 - x * (inner->x + inner->width / 2),
                       outer->y + outer->height / 2 - y * (inner->y + inner->height / 2)};
}
