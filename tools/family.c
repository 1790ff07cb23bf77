#include "family.h"

#include "base/memory.h"
#include "messages.h"
#include "sfnt/axis_names.h"
#include "source/font.h"
#include "work.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- one font ------------------------------------------------------------------------------------------ */

typedef struct member {
    const char *spec;
    double value;
    bool italic;
    int given; /* its number among the arguments */
} member;

static int refuse_placeless(const cli_options *options, const char *spec, uint32_t tag) {
    const char *what = tag == MT_TAG('w', 'g', 'h', 't')   ? "no weight class (OS/2 usWeightClass)"
                       : tag == MT_TAG('w', 'd', 't', 'h') ? "no width class (OS/2 usWidthClass)"
                                                           : "does not say where it stands on the axis";
    return fail("%s: %s; --axis %s wants --stops", spec, what, options->axis_tag);
}

static int read_member(const cli_options *options, int i, uint32_t tag, member *one) {
    mt_font *font = NULL;
    *one = (member){.spec = options->fonts[i], .given = i};
    int outcome = font_open(options, one->spec, &font);
    if (outcome != DONE) return outcome;
    one->italic = mt_font_is_italic(font);
    if (options->stop_count)
        one->value = options->stops[i];
    else if (!mt_font_stop(font, tag, &one->value))
        outcome = refuse_placeless(options, one->spec, tag);
    mt_font_close(font);
    return outcome;
}

/* ---- all of them --------------------------------------------------------------------------------------- */

/* The uprights, then the italics; by their places. */
static int compare(const void *a, const void *b) {
    const member *x = a, *y = b;
    if (x->italic != y->italic) return x->italic ? 1 : -1;
    if (x->value != y->value) return x->value > y->value ? 1 : -1;
    return (x->given > y->given) - (x->given < y->given);
}

/* Whether a font leans is what these axes tell of themselves. */
static bool is_of_slope(uint32_t tag) {
    return tag == MT_TAG('s', 'l', 'n', 't') || tag == MT_TAG('i', 't', 'a', 'l');
}

static int read_members(const cli_options *options, member *members) {
    uint32_t tag;
    int outcome = DONE;
    mt_axis_tag_read(options->axis_tag, &tag);
    for (int i = 0; i < options->font_count && outcome == DONE; i++)
        outcome = read_member(options, i, tag, &members[i]);
    for (int i = 0; i < options->font_count && is_of_slope(tag); i++) members[i].italic = false;
    if (outcome == DONE) qsort(members, (size_t)options->font_count, sizeof *members, compare);
    return outcome;
}

/* Whether the places can be stops. */
static int check_members(const cli_options *options, const member *members, int count) {
    mt_axis axis = {.from = members[0].value, .to = members[count - 1].value};
    mt_axis_tag_read(options->axis_tag, &axis.tag);
    if (count < 2)
        return fail("%s: is the only %s font, and a family of one has nothing between", members[0].spec,
                    members[0].italic ? "italic" : "upright");
    for (int i = 1; i < count; i++)
        if (members[i].value - members[i - 1].value < 0.01)
            return fail("%s and %s stand at one place of the axis, %s %g; --stops says where each stands",
                        members[i - 1].spec, members[i].spec, options->axis_tag, members[i].value);
    if (mt_axis_is_valid(&axis)) return DONE;
    return fail("%s and %s: %s cannot be from %g to %g", members[0].spec, members[count - 1].spec,
                options->axis_tag, axis.from, axis.to);
}

/* ---- the family ---------------------------------------------------------------------------------------- */

/* NAME-Italic.ttf for NAME.ttf, and NAME-Italic[wght].ttf for NAME[wght].ttf, as foundries name them. */
static char *name_italic(const char *output) {
    const char *slash = strrchr(output, '/'), *base = slash ? slash + 1 : output;
    const char *dot = strrchr(base, '.'), *bracket = strchr(base, '[');
    const char *end = bracket ? bracket : dot;
    size_t room = strlen(output) + sizeof "-Italic";
    char *name = mt_new(room, 1);
    if (name) snprintf(name, room, "%.*s-Italic%s", (int)(end - output), output, end);
    return name;
}

static int add_font(const cli_options *options, const member *members, int count, const char *output,
                    family *made) {
    cli_options *font = &made->list[made->count];
    double *stops = made->stops[made->count++];
    *font = *options;
    font->output = output;
    font->font_count = count;
    font->stops = stops;
    font->stop_count = count;
    for (int i = 0; i < count; i++) {
        font->fonts[i] = members[i].spec;
        stops[i] = members[i].value;
    }
    return check_members(options, members, count);
}

static int add_both(const cli_options *options, const member *members, int uprights, family *made) {
    made->italic_output = name_italic(options->output);
    if (!made->italic_output) return fail_status(options->output, MT_NO_MEMORY);
    if (options->pairs_file)
        return misuse(options->command, "--pairs: either upright fonts or italics are wanted, not both");
    int outcome = add_font(options, members, uprights, options->output, made);
    made->list[0].has_italic = true;
    if (outcome != DONE) return outcome;
    return add_font(options, members + uprights, options->font_count - uprights, made->italic_output, made);
}

int family_read(const cli_options *options, family *made) {
    member members[MT_VARIABLE_FONTS_MAX];
    int count = options->font_count, uprights = 0;
    *made = (family){0};
    if (options->stop_count && options->stop_count != count)
        return misuse(options->command, "--stops: %d fonts are given, and %d places", count,
                      options->stop_count);
    int outcome = read_members(options, members);
    if (outcome != DONE) return outcome;
    while (uprights < count && !members[uprights].italic) uprights++;
    if (uprights > 0 && uprights < count) return add_both(options, members, uprights, made);
    return add_font(options, members, count, options->output, made);
}

void family_free(family *made) {
    mt_free(made->italic_output);
}
