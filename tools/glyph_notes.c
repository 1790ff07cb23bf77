#include "glyph_notes.h"

#include "base/memory.h"
#include "characters.h"
#include "messages.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { NAMED_MOST = 8, LINE_ROOM = 12288 }; /* glyphs named in a line; bytes */

/* ---- collecting --------------------------------------------------------------------------------- */

static bool make_room(glyph_notes *notes) {
    glyph_note *list = mt_grow_list(notes->list, notes->count, &notes->room, sizeof *list);
    if (list) notes->list = list;
    return list != NULL;
}

void glyph_notes_add(const mt_glyph_note *note, void *user) {
    glyph_notes *notes = user;
    char *name = note->name ? mt_copy_text(note->name) : NULL;
    bool kept = (name || !note->name) && make_room(notes);
    notes->lost |= !kept;
    if (!kept) {
        mt_free(name);
        return;
    }
    notes->list[notes->count++] = (glyph_note){.code_point = note->code_point,
                                               .glyph = note->glyph,
                                               .is_form = note->is_form,
                                               .name = name,
                                               .font = note->font,
                                               .why = note->why,
                                               .t = note->t,
                                               .up = note->up,
                                               .asked = note->asked,
                                               .asked_up = note->asked_up};
}

void glyph_notes_free(glyph_notes *notes) {
    for (int i = 0; i < notes->count; i++) mt_free(notes->list[i].name);
    mt_free(notes->list);
    *notes = (glyph_notes){0};
}

/* ---- order -------------------------------------------------------------------------------------- */

static int order_of(int64_t x, int64_t y) {
    return (x > y) - (x < y);
}

static int order_of_places(double x, double y) {
    return (x > y) - (x < y);
}

static int compare_kinds(const glyph_note *x, const glyph_note *y) {
    int order = order_of(x->why, y->why);
    if (!order) order = order_of_places(x->asked, y->asked);
    if (!order) order = order_of_places(x->asked_up, y->asked_up);
    return order ? order : order_of(x->font, y->font);
}

/* By kind; then those of characters, by code point, before those of none, by number. */
static int compare(const void *a, const void *b) {
    const glyph_note *x = a, *y = b;
    int order = compare_kinds(x, y);
    if (!order) order = order_of(x->is_form || !x->code_point, y->is_form || !y->code_point);
    if (!order && !x->is_form) order = order_of(x->code_point, y->code_point);
    return order ? order : order_of(x->glyph, y->glyph);
}

/* Sorts them, and keeps one of several that are the same glyph and kind: a variable font tells of each step. */
static void sort(glyph_notes *notes) {
    int kept = 0;
    if (notes->count > 0) qsort(notes->list, (size_t)notes->count, sizeof *notes->list, compare);
    for (int i = 0; i < notes->count; i++) {
        if (kept && compare(&notes->list[kept - 1], &notes->list[i]) == 0)
            mt_free(notes->list[i].name);
        else
            notes->list[kept++] = notes->list[i];
    }
    notes->count = kept;
}

/* The index after those of the same kind as `from`. */
static int kind_end(const glyph_notes *notes, int from) {
    int end = from + 1;
    while (end < notes->count && compare_kinds(&notes->list[from], &notes->list[end]) == 0) end++;
    return end;
}

/* ---- lines -------------------------------------------------------------------------------------- */

/* The character that leads to the glyph; or its name in the first font, or its number, as --text takes them. */
static void describe(const glyph_note *note, char *text, size_t room) {
    char character[CHARACTER_NAME_ROOM];
    if (note->code_point) character_describe(note->code_point, character, sizeof character);
    if (note->code_point && !note->is_form)
        snprintf(text, room, "%s", character);
    else if (note->name)
        snprintf(text, room, "/%s", note->name);
    else if (note->code_point)
        snprintf(text, room, "/gid%lu (a form of %s)", (unsigned long)note->glyph, character);
    else
        snprintf(text, room, "/gid%lu", (unsigned long)note->glyph);
}

/* With their places where these are of interest: "“k” (U+006B) at 1.12, …" */
static void list_glyphs(const glyph_note *notes, int count, bool placed, char *text, size_t room) {
    size_t used = 0;
    int named = 0;
    *text = '\0';
    for (; named < count && named < NAMED_MOST && used + 1024 < room; named++) {
        if (named) used += (size_t)snprintf(text + used, room - used, ", ");
        describe(&notes[named], text + used, room - used);
        used += strlen(text + used);
        if (placed) used += (size_t)snprintf(text + used, room - used, " at %.2f", notes[named].t);
        if (placed && notes[named].up != notes[named].t)
            used += (size_t)snprintf(text + used, room - used, ",y=%.2f", notes[named].up);
    }
    if (named < count) snprintf(text + used, room - used, " and %d more", count - named);
}

/* Why, and in which font. */
static void describe_reason(const glyph_note *note, const cli_options *options, char *text, size_t room) {
    const char *font = note->font < 0 ? NULL : options->fonts[note->font];
    if (font && note->why == MT_NO_COUNTERPART)
        snprintf(text, room, "%s leaves %s blank", font,
                 note->is_form || !note->code_point ? "it" : "the character");
    else if (font)
        snprintf(text, room, "%s, in %s", mt_status_text(note->why), font);
    else
        snprintf(text, room, "%s", mt_status_text(note->why));
}

static void say_failures(const glyph_note *notes, int count, const cli_options *options) {
    char glyphs[LINE_ROOM], reason[4096];
    list_glyphs(notes, count, false, glyphs, sizeof glyphs);
    describe_reason(notes, options, reason, sizeof reason);
    if (count == 1)
        say("%s: not blended, %s: %s", glyphs,
            options->strict ? "as --strict asks" : "the nearer font's glyph stands in", reason);
    else
        say("%d glyphs not blended, %s: %s: %s", count,
            options->strict ? "as --strict asks" : "the nearer font's glyphs stand in", reason, glyphs);
}

void glyph_notes_say_failures(glyph_notes *notes, const cli_options *options) {
    sort(notes);
    for (int from = 0, end; from < notes->count; from = end) {
        end = options->verbose ? from + 1 : kind_end(notes, from);
        say_failures(&notes->list[from], end - from, options);
    }
}

static void say_unblended(const glyph_note *notes, int count, const cli_options *options) {
    char glyphs[LINE_ROOM];
    bool two = options->font_count == 2;
    list_glyphs(notes, count, false, glyphs, sizeof glyphs);
    say("%d glyph%s that %s %s not stay%s as in %s: %s", count, count == 1 ? "" : "s",
        two ? options->fonts[1] : "the other fonts", two ? "has" : "have", count == 1 ? "s" : "",
        options->fonts[0], glyphs);
}

void glyph_notes_say_unblended(glyph_notes *notes, const cli_options *options) {
    sort(notes);
    for (int from = 0, end; from < notes->count; from = end) {
        end = options->verbose ? from + 1 : notes->count;
        say_unblended(&notes->list[from], end - from, options);
    }
}

void glyph_notes_say_cut_short(glyph_notes *notes, const cli_options *options) {
    char glyphs[LINE_ROOM];
    sort(notes);
    for (int from = 0, end; from < notes->count; from = end) {
        end = options->verbose ? from + 1 : notes->count;
        list_glyphs(&notes->list[from], end - from, false, glyphs, sizeof glyphs);
        bool one = end - from == 1;
        say("%d glyph%s took all the effort that a glyph may, and %s the best until then; a larger --effort "
            "tries "
            "on: %s",
            end - from, one ? "" : "s", one ? "is" : "are", glyphs);
    }
}

static void write_place(const glyph_note *note, char text[96]) {
    if (note->asked == note->asked_up)
        snprintf(text, 96, "%g", note->asked);
    else
        snprintf(text, 96, "%g,y=%g", note->asked, note->asked_up);
}

void glyph_notes_say_held(glyph_notes *notes, const cli_options *options) {
    char glyphs[LINE_ROOM], place[96];
    sort(notes);
    for (int from = 0, end; from < notes->count; from = end) {
        end = options->verbose ? from + 1 : kind_end(notes, from);
        list_glyphs(&notes->list[from], end - from, true, glyphs, sizeof glyphs);
        write_place(&notes->list[from], place);
        say("%d glyph%s short of T = %s, where %s drawing would come apart or close: %s", end - from,
            end - from == 1 ? " stays" : "s stay", place, end - from == 1 ? "its" : "their", glyphs);
    }
}
