#include "blend/private_names.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

#include "source/glyph_names.h"

/* The names of the first font's glyphs and of another's. */
typedef struct mt_name_comparison {
    mt_font *const *fonts;
    const mt_charset_request *request;
    int font; /* the other's number */
    const char **in_first, **in_other;
    int count;           /* of characters whose names differ */
    uint32_t code_point; /* the first of them */
    const char *first, *other;
} mt_name_comparison;

static bool is_private(uint32_t c) {
    return (c >= 0xE000 && c <= 0xF8FF) || (c >= 0xF0000 && c <= 0xFFFFD) || (c >= 0x100000 && c <= 0x10FFFD);
}

/* Names such as uniE001 and u1F600 (Adobe Glyph List Specification, section 2). */
static bool tells_code(const char *name) {
    const char *digits = strncmp(name, "uni", 3) == 0 ? name + 3 : name + 1;
    int count = 0;
    while (isxdigit((unsigned char)digits[count])) count++;
    return name[0] == 'u' && count >= 4 && (digits[count] == '\0' || digits[count] == '.');
}

static void compare(mt_name_comparison *this, uint32_t code_point) {
    mt_font *const *fonts = this->fonts;
    uint32_t a = mt_font_glyph(fonts[0], code_point), b = mt_font_glyph(fonts[this->font], code_point);
    if (!a || !b || mt_given_partner(this->request->pairs, a, this->font)) return;
    const char *first = this->in_first[a], *other = this->in_other[b];
    if (!first || !other || tells_code(first) || tells_code(other) || strcmp(first, other) == 0) return;
    if (this->count++ > 0) return;
    this->code_point = code_point;
    this->first = first;
    this->other = other;
}

/* The private characters that are asked for. */
static void compare_all(mt_name_comparison *this) {
    const mt_charset_request *request = this->request;
    uint32_t c = 0;
    for (int i = 0; i < request->count; i++)
        if (is_private(request->wanted[i])) compare(this, request->wanted[i]);
    bool more = request->count == 0 && mt_font_next_char(this->fonts[0], 0xE000, &c);
    for (; more; more = mt_font_next_char(this->fonts[0], c + 1, &c))
        if (is_private(c)) compare(this, c);
}

static void say(const mt_name_comparison *this, mt_warning call, void *user) {
    char line[1024];
    snprintf(line, sizeof line,
             "%d private character%s other names in %s than in %s (U+%04lX is /%.64s there and /%.64s here): "
             "--pairs FILE "
             "says which glyphs go together",
             this->count, this->count == 1 ? " has" : "s have", mt_font_spec(this->fonts[this->font]),
             mt_font_spec(this->fonts[0]), (unsigned long)this->code_point, this->other, this->first);
    call(line, user);
}

mt_status mt_private_names_review(mt_font *const *fonts, int count, const mt_charset_request *request,
                                  mt_warning call, void *user) {
    mt_arena arena = {0};
    mt_name_comparison this = {.fonts = fonts, .request = request};
    mt_status status = mt_font_glyph_names(fonts[0], &arena, &this.in_first);
    for (int i = 1; i < count && this.in_first && status == MT_OK && !this.count; i++) {
        this.font = i;
        status = mt_font_glyph_names(fonts[i], &arena, &this.in_other);
        if (status == MT_OK && this.in_other) compare_all(&this);
    }
    if (status == MT_OK && this.count) say(&this, call, user);
    mt_arena_release(&arena);
    return status;
}
