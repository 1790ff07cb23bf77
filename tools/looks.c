#include "looks.h"

#include "base/memory.h"
#include "characters.h"
#include "messages.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { NAMED_MOST = 8, NAME_ROOM = MT_GLYPH_LABEL_ROOM + CHARACTER_NAME_ROOM, LINE_ROOM = 8192 };

/* The flagged glyphs of a step, the worst first. */
typedef struct looks {
    const mt_naming *naming; /* of the first font */
    const mt_report_glyph **list;
    int count;
} looks;

static int compare(const void *a, const void *b) {
    return mt_report_worst_first(*(const mt_report_glyph *const *)a, *(const mt_report_glyph *const *)b);
}

static void collect(const mt_report_figures *figures, int step, looks *found) {
    found->count = 0;
    for (int i = 0; i < figures->glyph_count; i++) {
        const mt_report_glyph *glyph = &figures->steps[step][i];
        if (glyph->measured && glyph->flags) found->list[found->count++] = glyph;
    }
    qsort(found->list, (size_t)found->count, sizeof(const mt_report_glyph *), compare);
}

static void describe(const looks *found, const mt_report_glyph *glyph, char text[NAME_ROOM]) {
    if (glyph->of.mapped)
        character_describe(glyph->of.code_point, text, NAME_ROOM);
    else
        mt_naming_label(found->naming, glyph->of.a, text);
}

/* "“k” (U+006B): strays", with the flags' names or, at length, their reasons. */
static void describe_flags(const mt_report_glyph *glyph, bool reasons, char *text, size_t room) {
    size_t used = 0;
    *text = '\0';
    for (unsigned flag = 1; flag & MT_FLAG_ALL; flag <<= 1) {
        char reason[MT_REPORT_REASON_ROOM];
        if (!(glyph->flags & flag)) continue;
        if (reasons) mt_report_reason(glyph, (mt_report_flag)flag, reason);
        snprintf(text + used, room - used, "%s%s", used ? "; " : "",
                 reasons ? reason : mt_report_flag_name((mt_report_flag)flag));
        used += strlen(text + used);
    }
}

static void say_each(const looks *found, const char *between) {
    for (int i = 0; i < found->count; i++) {
        char name[NAME_ROOM], why[LINE_ROOM];
        describe(found, found->list[i], name);
        describe_flags(found->list[i], true, why, sizeof why);
        say("%s: %s needs a look: %s", between, name, why);
    }
}

static void say_together(const looks *found, const char *between) {
    char line[LINE_ROOM] = "", name[NAME_ROOM], why[256];
    size_t used = 0;
    for (int i = 0; i < found->count && i < NAMED_MOST; i++) {
        describe(found, found->list[i], name);
        describe_flags(found->list[i], false, why, sizeof why);
        snprintf(line + used, sizeof line - used, "%s%s: %s", used ? ", " : "", name, why);
        used += strlen(line + used);
    }
    if (found->count > NAMED_MOST)
        snprintf(line + used, sizeof line - used, " and %d more", found->count - NAMED_MOST);
    if (found->count > 0)
        say("%s: %d glyph%s need%s a look: %s", between, found->count, found->count == 1 ? "" : "s",
            found->count == 1 ? "s" : "", line);
}

int looks_say(const cli_work *work, const mt_report_figures *figures) {
    const cli_options *options = work->options;
    mt_naming *naming = NULL;
    size_t glyphs = (size_t)figures->glyph_count;
    looks found = {.list = mt_new(glyphs, sizeof *found.list)};
    mt_status status = found.list ? mt_naming_open(work->fonts[0], &naming) : MT_NO_MEMORY;
    found.naming = naming;
    for (int step = 0; step < figures->step_count && status == MT_OK; step++) {
        char between[LINE_ROOM];
        snprintf(between, sizeof between, "%s to %s", options->fonts[step], options->fonts[step + 1]);
        collect(figures, step, &found);
        if (options->verbose)
            say_each(&found, between);
        else
            say_together(&found, between);
    }
    mt_naming_close(naming);
    mt_free(found.list);
    return status == MT_OK ? DONE : fail_status(options->output, status);
}
