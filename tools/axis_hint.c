#include "axis_hint.h"

#include "base/memory.h"
#include "source/font.h"
#include "source/spec.h"
#include "suggest.h"

#include <stdio.h>
#include <string.h>

enum { TAG_ROOM = 5 };

typedef char tag_text[TAG_ROOM];

static void write_tag(uint32_t tag, tag_text text) {
    for (int i = 0; i < 4; i++) text[i] = (char)(tag >> (24 - 8 * i) & 0xff);
    text[4] = '\0';
}

/* The first axis that is set and not there; 0 where all are. */
static uint32_t find_missing(const mt_spec *spec, const uint32_t *tags, int count) {
    for (int i = 0; i < spec->axis_count; i++) {
        bool there = false;
        for (int k = 0; k < count; k++) there = there || tags[k] == spec->axes[i].tag;
        if (!there) return spec->axes[i].tag;
    }
    return 0;
}

/* "; it has wght, wdth and opsz", as many as fit. */
static void list_axes(const tag_text *names, int count, char *text) {
    size_t used = (size_t)snprintf(text, AXIS_HINT_ROOM, "; it has ");
    for (int i = 0; i < count && used < AXIS_HINT_ROOM; i++) {
        const char *before = i == 0 ? "" : i + 1 < count ? ", " : " and ";
        used += (size_t)snprintf(text + used, AXIS_HINT_ROOM - used, "%s%s", before, names[i]);
    }
}

static void tell(const mt_spec *spec, const mt_font *font, char *text) {
    const uint32_t *tags;
    int count = mt_font_axes(font, &tags);
    tag_text names[MT_SPEC_AXES], wanted;
    char hint[SUGGEST_ROOM];
    write_tag(find_missing(spec, tags, count), wanted);
    suggestion nearest = suggest_for(wanted);
    for (int i = 0; i < count; i++) {
        write_tag(tags[i], names[i]);
        suggest(&nearest, names[i]);
    }
    if (nearest.word)
        snprintf(text, AXIS_HINT_ROOM, "%s", suggest_text(&nearest, "", hint));
    else if (count)
        list_axes((const tag_text *)names, count, text);
    else
        snprintf(text, AXIS_HINT_ROOM, "; it does not vary");
}

void axis_hint(const char *spec, char text[AXIS_HINT_ROOM]) {
    mt_spec parsed;
    mt_font *font;
    *text = '\0';
    if (mt_spec_parse(spec, &parsed) != MT_OK) return;
    size_t room = strlen(parsed.path) + 16;
    char *plain = mt_new(room, 1); /* the face as it stands without a setting */
    if (plain) snprintf(plain, room, "%s#%d", parsed.path, parsed.face);
    if (plain && mt_font_open(plain, &font) == MT_OK) {
        tell(&parsed, font, text);
        mt_font_close(font);
    }
    mt_free(plain);
    mt_spec_clear(&parsed);
}
