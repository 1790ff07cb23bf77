/* The inspection as a picture: a row a character, A on the left and B on the right.
 *
 *     U+5F62        8 contours, 20 links
 *        ▟▙ ─────────── ▟▙        matched components share a colour
 *        ▜▛ ─────────── ▜▛        a line for each link, and for each point of an aligned contour
 *     3 components, 35 pieces   4 components, 60 pieces
 */
#include "base/memory.h"
#include "geometry/limits.h"
#include "picture/canvas.h"
#include "picture/label.h"
#include "picture/picture.h"
#include "picture/turn.h"
#include "picture/view.h"

#include <math.h>
#include <stdio.h>

/* Shares of `size`, the em. */
#define MARGIN 0.25
#define PANEL 1.25 /* the side of the square that holds one glyph */
#define GAP 0.35   /* between A's panel and B's */
/* Shares of a label's height. */
#define CAPTION 3.0

typedef struct colour {
    double red, green, blue;
} colour;

/* Hues a good way apart, one after the other, that neighbours can be told by. */
static const colour palette[] = {
    {0.12, 0.47, 0.71}, {0.90, 0.49, 0.13}, {0.17, 0.63, 0.35}, {0.80, 0.20, 0.25}, {0.53, 0.36, 0.70},
    {0.10, 0.65, 0.68}, {0.85, 0.40, 0.65}, {0.58, 0.52, 0.12}, {0.45, 0.30, 0.22}, {0.40, 0.45, 0.52},
};
#define PALETTE_COUNT ((int)(sizeof palette / sizeof palette[0]))

/* ---- colours: one for each group of components that matches hold together ------------------------------ */

static int root_of(const int *parent, int node) {
    while (parent[node] != node) node = parent[node];
    return node;
}

/* Colour numbers of A's components, then of B's; in the arena. */
static int *colour_components(const mt_view *view, mt_arena *arena) {
    const mt_morph *morph = &view->pair.morph;
    int in_a = morph->a.shape.count, count = in_a + morph->b.shape.count, next = 0;
    int *parent = mt_arena_new(arena, (size_t)count + 1, sizeof *parent);
    int *colours = mt_arena_new(arena, (size_t)count + 1, sizeof *colours);
    if (!parent || !colours) return NULL;
    for (int i = 0; i < count; i++) parent[i] = i;
    for (int i = 0; i < morph->matches.count; i++) {
        int a = root_of(parent, morph->matches.links[i].a),
            b = root_of(parent, in_a + morph->matches.links[i].b);
        if (a < b) parent[b] = a;
        if (b < a) parent[a] = b;
    }
    for (int i = 0; i < count; i++)
        colours[i] = parent[i] == i ? next++ % PALETTE_COUNT : colours[root_of(parent, i)];
    return colours;
}

static void set_colour(cairo_t *cairo, int number, double alpha) {
    colour c = palette[number];
    cairo_set_source_rgba(cairo, c.red, c.green, c.blue, alpha);
}

/* ---- where a glyph stands ------------------------------------------------------------------------------ */

/* From B's or A's grid to the page. */
typedef struct placing {
    mt_turn turn;
    double scale;          /* picture units a grid unit */
    double grid_x, grid_y; /* this point of the grid… */
    double page_x, page_y; /* …is here on the page */
} placing;

/* Puts the middle of the shape's box in the middle of a panel, at `size` an em or what fits. */
static placing place_side(const mt_shape *shape, mt_turn turn, double size, double left, double top) {
    mt_box box = mt_shape_box(shape);
    double extent = fmax((double)box.max.x - box.min.x, (double)box.max.y - box.min.y);
    double scale = size / MT_EM;
    if (extent * scale > PANEL * size) scale = PANEL * size / extent;
    return (placing){.turn = turn,
                     .scale = scale,
                     .grid_x = ((double)box.min.x + box.max.x) / 2,
                     .grid_y = ((double)box.min.y + box.max.y) / 2,
                     .page_x = left + PANEL * size / 2,
                     .page_y = top + PANEL * size / 2};
}

static void to_page(const placing *at, double *x, double *y) {
    mt_turn_point(&at->turn, x, y);
    *x = at->page_x + (*x - at->grid_x) * at->scale;
    *y = at->page_y - (*y - at->grid_y) * at->scale;
}

static void add_ring(cairo_t *cairo, const mt_ring *ring, const placing *at) {
    cairo_new_sub_path(cairo);
    for (int i = 0; i < ring->count; i++) {
        double x = ring->points[i].x, y = ring->points[i].y;
        to_page(at, &x, &y);
        cairo_line_to(cairo, x, y);
    }
    cairo_close_path(cairo);
}

static void piece_centre(const mt_ring *piece, const placing *at, double *x, double *y) {
    mt_ring_centre(piece, x, y);
    to_page(at, x, y);
}

/* ---- the drawing --------------------------------------------------------------------------------------- */

static void draw_component(cairo_t *cairo, const mt_side *side, int index, int number, const placing *at) {
    const mt_component *component = &side->shape.components[index];
    for (int i = 0; i < component->count; i++) add_ring(cairo, &component->rings[i], at);
    set_colour(cairo, number, 0.45);
    cairo_fill(cairo);
    for (int i = side->first[index]; i < side->first[index + 1]; i++)
        add_ring(cairo, &side->pieces.rings[i], at);
    set_colour(cairo, number, 1);
    cairo_stroke(cairo);
}

static void draw_side(cairo_t *cairo, const mt_side *side, const int *colours, const placing *at) {
    for (int i = 0; i < side->shape.count; i++) draw_component(cairo, side, i, colours[i], at);
}

/* The component that a piece belongs to. */
static int component_of(const mt_side *side, int piece) {
    int component = 0;
    while (side->first[component + 1] <= piece) component++;
    return component;
}

static void draw_links(cairo_t *cairo, const mt_view *view, const int *colours, const placing *at) {
    const mt_morph *morph = &view->pair.morph;
    for (int i = 0; i < morph->links.count; i++) {
        mt_link link = morph->links.links[i];
        double ax, ay, bx, by;
        piece_centre(&morph->a.pieces.rings[link.a], &at[0], &ax, &ay);
        piece_centre(&morph->b.pieces.rings[link.b], &at[1], &bx, &by);
        cairo_move_to(cairo, ax, ay);
        cairo_line_to(cairo, bx, by);
        set_colour(cairo, colours[component_of(&morph->a, link.a)], 0.5);
        cairo_stroke(cairo);
    }
}

/* The component of A whose boundary comes closest to a point, at a vertex. */
static int component_near(const mt_side *side, mt_point point) {
    int nearest = 0;
    int64_t least = INT64_MAX;
    for (int i = 0; i < side->shape.count; i++)
        for (int k = 0; k < side->shape.components[i].count; k++) {
            const mt_ring *ring = &side->shape.components[i].rings[k];
            for (int n = 0; n < ring->count; n++) {
                int64_t distance = mt_distance2(point, ring->points[n]);
                if (distance >= least) continue;
                least = distance;
                nearest = i;
            }
        }
    return nearest;
}

/* Where the lines and curves of aligned contours end, on both sides. */
static void draw_moves(cairo_t *cairo, const mt_view *view, const int *colours, const placing *at) {
    const mt_morph *morph = &view->pair.morph;
    for (int i = 0; i < morph->contour_count; i++) {
        const mt_contour *a = &morph->contours[i].a, *b = &morph->contours[i].b;
        for (int k = 0; k < a->count; k++) {
            double ax = a->segments[k].end.x, ay = a->segments[k].end.y;
            double bx = b->segments[k].end.x, by = b->segments[k].end.y;
            to_page(&at[0], &ax, &ay);
            to_page(&at[1], &bx, &by);
            cairo_move_to(cairo, ax, ay);
            cairo_line_to(cairo, bx, by);
        }
        set_colour(cairo, colours[component_near(&morph->a, a->segments[0].end)], 0.5);
        cairo_stroke(cairo);
    }
}

static const char *plural(int count) {
    return count == 1 ? "" : "s";
}

static void draw_caption(cairo_t *cairo, const mt_side *side, double x, double y, double height,
                         double room) {
    char text[80];
    int components = side->shape.count, pieces = side->pieces.count;
    snprintf(text, sizeof text, "%d component%s, %d piece%s", components, plural(components), pieces,
             plural(pieces));
    mt_label_draw_centred(cairo, text, x, y, mt_label_fitting(text, height, room));
}

/* "2 contours, 13 links, turned by -7.5" */
static void describe_morph(const mt_morph *morph, char *text, size_t room) {
    int contours = morph->contour_count, links = morph->links.count, used = 0;
    if (contours > 0) used = snprintf(text, room, "%d contour%s, ", contours, plural(contours));
    used += snprintf(text + used, room - (size_t)used, "%d link%s", links, plural(links));
    if (morph->degrees != 0) snprintf(text + used, room - (size_t)used, ", turned by %.1f", morph->degrees);
}

static void draw_captions(cairo_t *cairo, const mt_view *view, double size, double top) {
    char text[80], label[MT_CHOICE_LABEL_ROOM];
    const mt_morph *morph = &view->pair.morph;
    double height = mt_label_height(size), left = MARGIN * size, bottom = top + PANEL * size + 2 * height;
    mt_choice_label(view->choice, label);
    cairo_set_source_rgb(cairo, 0, 0, 0);
    mt_label_draw(cairo, label, left, top, mt_label_fitting(label, height, 0.75 * PANEL * size));
    draw_caption(cairo, &morph->a, left + PANEL * size / 2, bottom, height, PANEL * size);
    if (!view->paired) return;
    draw_caption(cairo, &morph->b, left + (PANEL * 1.5 + GAP) * size, bottom, height, PANEL * size);
    describe_morph(morph, text, sizeof text);
    mt_label_draw_centred(cairo, text, left + (PANEL + GAP / 2) * size, top, height);
}

static mt_status draw_view(cairo_t *cairo, const mt_view *view, double size, double top, mt_arena *arena) {
    const mt_glyph_pair *pair = &view->pair;
    const int *colours = colour_components(view, arena);
    if (!colours) return MT_NO_MEMORY;
    double left = MARGIN * size;
    placing at[2] = {place_side(&pair->a, (mt_turn){.cosine = 1}, size, left, top)};
    cairo_set_line_width(cairo, fmax(0.4, size / 500));
    cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
    draw_side(cairo, &pair->morph.a, colours, &at[0]);
    if (view->paired) {
        at[1] = place_side(&pair->b, mt_turn_back(pair), size, left + (PANEL + GAP) * size, top);
        draw_side(cairo, &pair->morph.b, colours + pair->morph.a.shape.count, &at[1]);
        draw_moves(cairo, view, colours, at);
        draw_links(cairo, view, colours, at);
    }
    draw_captions(cairo, view, size, top);
    return MT_OK;
}

/* ---- the picture --------------------------------------------------------------------------------------- */

static double row_height(double size) {
    return PANEL * size + CAPTION * mt_label_height(size) + GAP * size;
}

typedef struct picture {
    cairo_t *cairo;
    const mt_inspection *what;
} picture;

static mt_status open_canvas(const mt_inspection *what, bool paired, mt_format format, mt_canvas *canvas) {
    double width = (2 * MARGIN + (paired ? 2 * PANEL + GAP : PANEL)) * what->size;
    double height = (2 * MARGIN - GAP) * what->size + what->count * row_height(what->size);
    return mt_canvas_open(format, width, height, canvas);
}

/* An mt_view_taken. */
static mt_status take_view(const mt_view *view, int index, mt_arena *arena, void *user) {
    const picture *drawing = user;
    double size = drawing->what->size;
    return draw_view(drawing->cairo, view, size, MARGIN * size + index * row_height(size), arena);
}

mt_status mt_inspect_save(mt_row *row, const mt_inspection *what, const char *path, int *failed) {
    mt_format format;
    mt_canvas canvas;
    *failed = -1;
    mt_status status = mt_format_of(path, &format);
    if (status != MT_OK) return status;
    if (what->count < 1 || !(what->size >= MT_SIZE_MIN && what->size <= MT_SIZE_MAX)) return MT_BAD_PARAMETER;
    status = open_canvas(what, row->font_count > 1, format, &canvas);
    if (status != MT_OK) return status;
    picture drawing = {canvas.cairo, what};
    status = mt_views_make(row, what, take_view, &drawing, failed);
    if (status == MT_OK) status = mt_canvas_save(&canvas, path);
    mt_canvas_close(&canvas);
    return status;
}
