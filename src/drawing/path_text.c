#include "drawing/path_text.h"

#include <string.h>

#include "base/real.h"
#include "drawing/scan.h"

/* A command's arguments: f is a flag, which may stand without a blank. */
static const char *arguments_of(char command) {
    switch (command) {
    case 'M':
    case 'L':
    case 'T': return "nn";
    case 'H':
    case 'V': return "n";
    case 'Q':
    case 'S': return "nnnn";
    case 'C': return "nnnnnn";
    case 'A': return "nnnffnn";
    default: return NULL;
    }
}

static bool read_flag(const char **at, double *flag) {
    if (**at != '0' && **at != '1') return false;
    *flag = *(*at)++ - '0';
    return true;
}

static bool read_arguments(const char **at, const char *kinds, double *values) {
    for (; *kinds; kinds++, values++) {
        if (!(*kinds == 'f' ? read_flag(at, values) : mt_real_next(at, values))) return false;
        mt_scan_comma(at);
    }
    return true;
}

typedef struct mt_path_reading {
    mt_pen *pen;
    char before;      /* the command before, as a capital */
    mt_vector handle; /* its last control point */
} mt_path_reading;

/* Where a smooth curve sets out to: the handle before mirrored, if that was of such a curve. */
static mt_vector mirrored(const mt_path_reading *r, const char *kinds) {
    mt_vector at = r->pen->at;
    bool goes_on = strchr(kinds, r->before) != NULL;
    return goes_on ? (mt_vector){2 * at.x - r->handle.x, 2 * at.y - r->handle.y} : at;
}

static void draw_curve(mt_path_reading *r, char command, const double *v) {
    mt_pen *pen = r->pen;
    mt_vector first;
    switch (command) {
    case 'C':
        r->handle = (mt_vector){v[2], v[3]};
        mt_pen_cubic(pen, v[0], v[1], v[2], v[3], v[4], v[5]);
        break;
    case 'S':
        first = mirrored(r, "CS");
        r->handle = (mt_vector){v[0], v[1]};
        mt_pen_cubic(pen, first.x, first.y, v[0], v[1], v[2], v[3]);
        break;
    case 'Q':
        r->handle = (mt_vector){v[0], v[1]};
        mt_pen_quadratic(pen, v[0], v[1], v[2], v[3]);
        break;
    default:
        r->handle = mirrored(r, "QT");
        mt_pen_quadratic(pen, r->handle.x, r->handle.y, v[0], v[1]);
        break;
    }
}

static void draw(mt_path_reading *r, char command, const double *v) {
    mt_pen *pen = r->pen;
    switch (command) {
    case 'M': mt_pen_move(pen, v[0], v[1]); break;
    case 'L': mt_pen_line(pen, v[0], v[1]); break;
    case 'H': mt_pen_line(pen, v[0], pen->at.y); break;
    case 'V': mt_pen_line(pen, pen->at.x, v[0]); break;
    case 'A': mt_pen_arc(pen, v[0], v[1], v[2], v[3] != 0, v[4] != 0, v[5], v[6]); break;
    default: draw_curve(r, command, v); break;
    }
    r->before = command;
}

/* Relative arguments as absolute ones. */
static void add_place(char command, const char *kinds, mt_vector at, double *v) {
    size_t count = strlen(kinds);
    if (command == 'V') {
        v[0] += at.y;
        return;
    }
    for (size_t i = command == 'A' ? 5 : 0; i < count; i++) v[i] += (i + (command == 'A')) % 2 ? at.y : at.x;
}

/* A command as often as its arguments follow. False where the data are wrong. */
static bool draw_all(mt_path_reading *r, const char **at, char letter) {
    bool relative = letter >= 'a';
    char command = relative ? (char)(letter - 'a' + 'A') : letter;
    const char *kinds = arguments_of(command);
    if (!kinds) return false;
    do {
        double values[7];
        if (!read_arguments(at, kinds, values)) return false;
        if (relative) add_place(command, kinds, r->pen->at, values);
        draw(r, command, values);
        if (command == 'M') command = 'L';
        mt_scan_blanks(at);
    } while (r->pen->status == MT_OK && **at && strchr("+-.0123456789", **at));
    return true;
}

void mt_path_text_draw(const char *text, mt_pen *pen) {
    mt_path_reading reading = {.pen = pen, .before = ' '};
    mt_scan_blanks(&text);
    bool good = *text == 'M' || *text == 'm';
    while (good && *text && pen->status == MT_OK) {
        char letter = *text++;
        mt_scan_blanks(&text);
        if (letter == 'Z' || letter == 'z') {
            mt_pen_close(pen);
            reading.before = 'Z';
        } else {
            good = ((letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z')) &&
                   draw_all(&reading, &text, letter);
        }
    }
}
