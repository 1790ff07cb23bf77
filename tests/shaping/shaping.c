/* Shapes the words of a corpus in the blends of two fonts: `shaping CORPUS DRAWN A B SCRIPT …`. At T = 0, 0.25, 0.5, 0.75 and 1, in
 * fonts of their own and in the variable font, HarfBuzz has to make of each word the glyphs that it makes of it in A, and at 0
 * each has to stand where it stands in A, within a unit. Prints how many words are right, and how many are drawn at 1 as
 * B draws them: with an intersection over union of 0.98 or more. Words with a character that A or B has not are left out; fails
 * when these are more than half of all, and when less words than DRAWN are drawn so. */
#include <cairo.h>
#include <hb-ot.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/file.h"
#include "base/utf.h"
#include "glyphset/charset.h"
#include "sfnt/axis.h"

enum { WORDS_MAX = 1024, CHARS_MAX = 4096, FEATURES_MAX = 4, PLACES = 5, FONTS = 2 * PLACES };
static const double places[PLACES] = {0, 0.25, 0.5, 0.75, 1};

typedef struct mt_word {
    const char *text;
    bool vertical;
    unsigned feature_count;
    hb_feature_t features[FEATURES_MAX];
} mt_word;

typedef struct corpus {
    int count, left_out;
    mt_word words[WORDS_MAX];
    bool asks; /* a word has features */
    int char_count;
    uint32_t chars[CHARS_MAX];
} corpus;

typedef struct run {
    mt_font *a, *b;
    hb_font_t *in_a, *in_b, *fonts[FONTS]; /* the five blends, then the variable font at five places */
    double units_a, units_b, units;
    mt_charset charset;
    mt_arena arena;
    corpus corpus;
    int right[FONTS], placed, drawn, compared;
} run;

static void check(mt_status status, const char *what) {
    if (status == MT_OK) return;
    fprintf(stderr, "%s: %s\n", what, mt_status_text(status));
    exit(1);
}

/* ---- the corpus ---------------------------------------------------------------------------------------- */

static bool has_all(const run *this, const char *text) {
    uint32_t c;
    while (mt_utf8_next(&text, &c) && c)
        if (!mt_font_glyph(this->a, c) || !mt_font_glyph(this->b, c)) return false;
    return true;
}

static void add_word(run *this, const mt_word *like, const char *text) {
    corpus *words = &this->corpus;
    uint32_t c;
    if (!has_all(this, text)) {
        words->left_out++;
        return;
    }
    if (words->count == WORDS_MAX) exit(1);
    words->words[words->count] = *like;
    words->words[words->count++].text = text;
    words->asks |= like->feature_count > 0;
    for (const char *at = text; mt_utf8_next(&at, &c) && c;)
        if (words->char_count < CHARS_MAX) words->chars[words->char_count++] = c;
}

/* "[NAME]" or "[NAME: FEATURES]"; whether the name is one of the scripts asked for. */
static bool read_heading(char *line, char **scripts, int count, mt_word *like) {
    char *name = line + 1, *end = strpbrk(name, ":]");
    *like = (mt_word){0};
    char *features = *end == ':' ? end + 1 : NULL;
    *end = '\0';
    if (features) *strchr(features, ']') = '\0';
    for (char *tag = features ? strtok(features, " ") : NULL; tag; tag = strtok(NULL, " ")) {
        if (strcmp(tag, "vertical") == 0)
            like->vertical = true;
        else
            hb_feature_from_string(tag, -1, &like->features[like->feature_count++]);
    }
    for (int i = 0; i < count; i++)
        if (strcmp(scripts[i], name) == 0) return true;
    return false;
}

static void read_corpus(run *this, char *path, char **scripts, int count) {
    char *bytes;
    size_t length;
    mt_word like = {0};
    bool wanted = false;
    check(mt_file_read(path, (size_t)1 << 20, (uint8_t **)&bytes, &length), path);
    bytes = mt_grow(bytes, length + 1, 1);
    bytes[length] = '\0';
    for (char *line = bytes, *next; *line; line = next) {
        next = line + strcspn(line, "\n");
        if (*next) *next++ = '\0';
        if (!*line || strncmp(line, "# ", 2) == 0) continue;
        if (line[0] == '[' && line[1] >= 'a' && line[1] <= 'z')
            wanted = read_heading(line, scripts, count, &like);
        else if (wanted)
            add_word(this, &like, line);
    }
}

/* ---- fonts --------------------------------------------------------------------------------------------- */

static hb_font_t *open_bytes(const uint8_t *bytes, size_t length) {
    hb_blob_t *blob =
        hb_blob_create((const char *)bytes, (unsigned)length, HB_MEMORY_MODE_READONLY, NULL, NULL);
    hb_face_t *face = hb_face_create(blob, 0);
    hb_font_t *font = hb_font_create(face);
    hb_face_destroy(face);
    hb_blob_destroy(blob);
    return font;
}

/* The source's own file, at its place on the axes. */
static hb_font_t *open_source(const mt_font *font) {
    char path[512];
    int face_number = 0, coords[64];
    const int32_t *place;
    snprintf(path, sizeof path, "%s", mt_font_spec(font));
    char *end = path + strcspn(path, "#@");
    if (*end == '#') face_number = atoi(end + 1);
    *end = '\0';
    hb_blob_t *blob = hb_blob_create_from_file(path);
    hb_face_t *face = hb_face_create(blob, (unsigned)face_number);
    hb_font_t *made = hb_font_create(face);
    hb_face_destroy(face);
    hb_blob_destroy(blob);
    int count = mt_font_place(font, &place);
    for (int i = 0; i < count; i++) coords[i] = place[i] >> 2;
    hb_font_set_var_coords_normalized(made, coords, (unsigned)count);
    return made;
}

/* The outlines between the ends are not looked at: the paper's method takes a tenth of the time. */
static mt_params quick(void) {
    mt_params params = mt_params_default();
    params.method = MT_METHOD_PAPER;
    return params;
}

static void make_blends(run *this) {
    mt_params params = quick();
    mt_blend *blend;
    uint8_t *bytes[PLACES];
    size_t lengths[PLACES];
    check(mt_blend_new(this->a, this->b, &params, &blend), "blend");
    check(mt_blend_set_chars(blend, this->corpus.chars, this->corpus.char_count), "characters");
    mt_blend_set_alternates(blend, this->corpus.asks);
    check(mt_blend_fonts(blend, places, PLACES, bytes, lengths), "fonts");
    for (int i = 0; i < PLACES; i++) this->fonts[i] = open_bytes(bytes[i], lengths[i]);
    mt_blend_free(blend);
}

static void make_variable(run *this) {
    mt_params params = quick();
    mt_variable *variable;
    uint8_t *bytes;
    size_t length;
    check(mt_variable_new((mt_font *[]){this->a, this->b}, 2, &params, &variable), "variable");
    check(mt_variable_set_chars(variable, this->corpus.chars, this->corpus.char_count), "characters");
    mt_variable_set_alternates(variable, this->corpus.asks);
    check(mt_variable_font(variable, &bytes, &length), "variable font");
    for (int i = 0; i < PLACES; i++) {
        hb_variation_t at = {MT_AXIS_DEFAULT.tag, (float)(places[i] * 100)};
        this->fonts[PLACES + i] = open_bytes(bytes, length);
        hb_font_set_variations(this->fonts[PLACES + i], &at, 1);
    }
    mt_variable_free(variable);
}

static void open_all(run *this, char *a, char *b) {
    check(mt_font_open(a, &this->a), a);
    check(mt_font_open(b, &this->b), b);
    this->in_a = open_source(this->a);
    this->in_b = open_source(this->b);
}

static void make_all(run *this) {
    mt_charset_request request = {
        .wanted = this->corpus.chars, .count = this->corpus.char_count, .alternates = this->corpus.asks};
    check(mt_charset_make(this->a, this->b, &request, &this->arena, &this->charset), "characters");
    make_blends(this);
    make_variable(this);
    this->units_a = hb_face_get_upem(hb_font_get_face(this->in_a));
    this->units_b = hb_face_get_upem(hb_font_get_face(this->in_b));
    this->units = hb_face_get_upem(hb_font_get_face(this->fonts[0]));
}

/* ---- comparing ----------------------------------------------------------------------------------------- */

/* By OpenType also where a source has Graphite tables, which no blend has. */
static hb_buffer_t *shape(hb_font_t *font, const mt_word *word) {
    static const char *const shapers[] = {"ot", NULL};
    hb_buffer_t *buffer = hb_buffer_create();
    hb_buffer_add_utf8(buffer, word->text, -1, 0, -1);
    if (word->vertical) hb_buffer_set_direction(buffer, HB_DIRECTION_TTB);
    hb_buffer_guess_segment_properties(buffer);
    hb_buffer_set_language(buffer, hb_language_from_string("en", -1));
    hb_shape_full(font, buffer, word->features, word->feature_count, shapers);
    return buffer;
}

static bool same_glyphs(const run *this, hb_buffer_t *in_a, hb_buffer_t *in_blend) {
    unsigned count_a, count;
    const hb_glyph_info_t *a = hb_buffer_get_glyph_infos(in_a, &count_a);
    const hb_glyph_info_t *blend = hb_buffer_get_glyph_infos(in_blend, &count);
    for (unsigned i = 0; i < count && count == count_a; i++)
        if (blend[i].codepoint >= (unsigned)this->charset.glyph_count ||
            this->charset.glyphs[blend[i].codepoint].a != a[i].codepoint)
            return false;
    return count == count_a;
}

/* Within a unit of the blend's for each glyph. */
static bool same_places(const run *this, hb_buffer_t *in_a, hb_buffer_t *in_blend) {
    unsigned count;
    const hb_glyph_position_t *a = hb_buffer_get_glyph_positions(in_a, &count);
    const hb_glyph_position_t *blend = hb_buffer_get_glyph_positions(in_blend, NULL);
    double scale = this->units / this->units_a;
    for (unsigned i = 0; i < count; i++)
        if (fabs(a[i].x_advance * scale - blend[i].x_advance) > 1 ||
            fabs(a[i].y_advance * scale - blend[i].y_advance) > 1 ||
            fabs(a[i].x_offset * scale - blend[i].x_offset) > 1 ||
            fabs(a[i].y_offset * scale - blend[i].y_offset) > 1)
            return false;
    return true;
}

static void say_wrong(const run *this, const mt_word *word, int font, hb_buffer_t *a, hb_buffer_t *blend,
                      const char *what) {
    char in_a[2048], in_blend[2048];
    hb_buffer_serialize_flags_t flags = HB_BUFFER_SERIALIZE_FLAG_NO_CLUSTERS;
    hb_buffer_serialize_glyphs(a, 0, hb_buffer_get_length(a), in_a, sizeof in_a, NULL, this->in_a,
                               HB_BUFFER_SERIALIZE_FORMAT_TEXT, flags);
    hb_buffer_serialize_glyphs(blend, 0, hb_buffer_get_length(blend), in_blend, sizeof in_blend, NULL,
                               this->fonts[font], HB_BUFFER_SERIALIZE_FORMAT_TEXT, flags);
    printf("  %s at %g%s: %s\n    in A      %s\n    in blend  %s\n", word->text, places[font % PLACES],
           font < PLACES ? "" : ", variable", what, in_a, in_blend);
}

/* ---- drawing ------------------------------------------------------------------------------------------- */

enum { EM = 64, WIDTH = 2048, HEIGHT = 256, LEFT = 256, BASELINE = 160 };

static void move_to(hb_draw_funcs_t *draw, void *cairo, hb_draw_state_t *state, float x, float y,
                    void *user) {
    (void)draw, (void)state, (void)user;
    cairo_move_to(cairo, x, y);
}

static void line_to(hb_draw_funcs_t *draw, void *cairo, hb_draw_state_t *state, float x, float y,
                    void *user) {
    (void)draw, (void)state, (void)user;
    cairo_line_to(cairo, x, y);
}

static void cubic_to(hb_draw_funcs_t *draw, void *cairo, hb_draw_state_t *state, float x1, float y1, float x2,
                     float y2, float x, float y, void *user) {
    (void)draw, (void)state, (void)user;
    cairo_curve_to(cairo, x1, y1, x2, y2, x, y);
}

static cairo_surface_t *draw(hb_font_t *font, hb_buffer_t *shaped) {
    unsigned count;
    const hb_glyph_info_t *glyphs = hb_buffer_get_glyph_infos(shaped, &count);
    const hb_glyph_position_t *at = hb_buffer_get_glyph_positions(shaped, NULL);
    hb_draw_funcs_t *functions = hb_draw_funcs_create();
    cairo_surface_t *surface = cairo_image_surface_create(CAIRO_FORMAT_A8, WIDTH, HEIGHT);
    cairo_t *cairo = cairo_create(surface);
    double scale = (double)EM / hb_face_get_upem(hb_font_get_face(font));
    hb_draw_funcs_set_move_to_func(functions, move_to, NULL, NULL);
    hb_draw_funcs_set_line_to_func(functions, line_to, NULL, NULL);
    hb_draw_funcs_set_cubic_to_func(functions, cubic_to, NULL, NULL);
    cairo_translate(cairo, LEFT, BASELINE);
    cairo_scale(cairo, scale, -scale);
    for (unsigned i = 0; i < count; i++) {
        cairo_save(cairo);
        cairo_translate(cairo, at[i].x_offset, at[i].y_offset);
        hb_font_get_glyph_shape(font, glyphs[i].codepoint, functions, cairo);
        cairo_fill(cairo);
        cairo_restore(cairo);
        cairo_translate(cairo, at[i].x_advance, at[i].y_advance);
    }
    cairo_destroy(cairo);
    hb_draw_funcs_destroy(functions);
    cairo_surface_flush(surface);
    return surface;
}

static double overlap(cairo_surface_t *x, cairo_surface_t *y) {
    const uint8_t *in_x = cairo_image_surface_get_data(x), *in_y = cairo_image_surface_get_data(y);
    double both = 0, either = 0;
    for (size_t i = 0; i < (size_t)cairo_image_surface_get_stride(x) * HEIGHT; i++) {
        both += in_x[i] < in_y[i] ? in_x[i] : in_y[i];
        either += in_x[i] > in_y[i] ? in_x[i] : in_y[i];
    }
    return either > 0 ? both / either : 1;
}

static bool drawn_alike(hb_font_t *blend, hb_font_t *in_b, const mt_word *word) {
    hb_buffer_t *one = shape(blend, word), *other = shape(in_b, word);
    cairo_surface_t *x = draw(blend, one), *y = draw(in_b, other);
    double ratio = overlap(x, y);
    cairo_surface_destroy(x);
    cairo_surface_destroy(y);
    hb_buffer_destroy(one);
    hb_buffer_destroy(other);
    return ratio >= 0.98;
}

/* The glyphs of a shaped word, each with its place and advance: of the blend, what they are in B. */
static void say_run(const run *this, hb_buffer_t *shaped, bool in_blend) {
    unsigned count;
    const hb_glyph_info_t *glyphs = hb_buffer_get_glyph_infos(shaped, &count);
    const hb_glyph_position_t *at = hb_buffer_get_glyph_positions(shaped, NULL);
    for (unsigned i = 0; i < count; i++) {
        char name[64];
        uint32_t own = glyphs[i].codepoint;
        mt_pairing pairing = in_blend ? this->charset.glyphs[own] : (mt_pairing){.b = own};
        bool alone = pairing.b == MT_NO_PARTNER;
        hb_font_glyph_to_string(alone ? this->in_a : this->in_b, alone ? pairing.a : pairing.b, name,
                                sizeof name);
        double to_em = 1000.0 / (in_blend ? this->units : this->units_b);
        printf(" %s%s@%.0f,%.0f+%.0f", alone ? "A:" : "", name, at[i].x_offset * to_em,
               at[i].y_offset * to_em, at[i].x_advance * to_em);
    }
    printf("\n");
}

static void say_drawn(const run *this, const mt_word *word) {
    hb_buffer_t *blend = shape(this->fonts[PLACES - 1], word), *b = shape(this->in_b, word);
    printf("  %s at 1: not as B draws it\n    in B     ", word->text);
    say_run(this, b, false);
    printf("    in blend ");
    say_run(this, blend, true);
    hb_buffer_destroy(blend);
    hb_buffer_destroy(b);
}

/* ---- all words ----------------------------------------------------------------------------------------- */

static void check_word(run *this, const mt_word *word, bool verbose) {
    hb_buffer_t *a = shape(this->in_a, word);
    for (int i = 0; i < FONTS; i++) {
        hb_buffer_t *blend = shape(this->fonts[i], word);
        bool right = same_glyphs(this, a, blend), placed = right && same_places(this, a, blend);
        this->right[i] += right;
        if (i % PLACES == 0) this->placed += placed;
        if (!right && verbose) say_wrong(this, word, i, a, blend, "other glyphs");
        if (right && !placed && i % PLACES == 0 && verbose)
            say_wrong(this, word, i, a, blend, "other positions");
        hb_buffer_destroy(blend);
    }
    hb_buffer_destroy(a);
    if (word->vertical) return;
    bool drawn = drawn_alike(this->fonts[PLACES - 1], this->in_b, word);
    this->compared++;
    this->drawn += drawn;
    if (!drawn && verbose) say_drawn(this, word);
}

/* Whether all are right. */
static bool report(const run *this, int drawn) {
    const corpus *words = &this->corpus;
    bool all = words->count > words->left_out && this->placed == 2 * words->count && this->drawn >= drawn;
    printf("%d words, %d left out; right", words->count, words->left_out);
    for (int i = 0; i < FONTS; i++) {
        printf(i == PLACES ? "; variable %d" : " %d", this->right[i]);
        all = all && this->right[i] == words->count;
    }
    printf("; in place at 0: %d of %d; drawn as B at 1: %d of %d; unblended glyphs: %d of %d\n", this->placed,
           2 * words->count, this->drawn, this->compared, this->charset.unblended_count,
           this->charset.glyph_count);
    return all;
}

int main(int argc, char **argv) {
    bool verbose = argc > 1 && strcmp(argv[1], "-v") == 0;
    argv += verbose;
    argc -= verbose;
    if (argc < 6) return 2;
    static run this;
    open_all(&this, argv[3], argv[4]);
    read_corpus(&this, argv[1], argv + 5, argc - 5);
    if (this.corpus.count == 0) return 1;
    make_all(&this);
    for (int i = 0; i < this.corpus.count; i++) check_word(&this, &this.corpus.words[i], verbose);
    return report(&this, atoi(argv[2])) ? 0 : 1;
}
