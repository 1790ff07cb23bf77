/* File names from glyph names (UFO 3, Conventions, "Common User Name to File Name Algorithm"), which no file system takes
 * for one another: not those that know no capitals either. */
#include <stdio.h>
#include <string.h>
#include <strings.h>

#include "save/ufo_parts.h"

#define SUFFIX ".glif"

enum {
    FILE_NAME_MAX = 255,
    STEM_MAX = FILE_NAME_MAX - 5, /* without the suffix */
    DIGITS = 15                   /* of the number that tells names apart */
};

/* ---- names in use ----------------------------------------------------------------------------------------- */

/* File names in small letters: a table with open addressing, at most half full. */
typedef struct mt_name_set {
    const char **slots;
    size_t mask;
} mt_name_set;

static mt_status make_set(int count, mt_arena *arena, mt_name_set *set) {
    size_t room = 16;
    while (room < 2 * (size_t)count) room *= 2;
    *set = (mt_name_set){mt_arena_new(arena, room, sizeof *set->slots), room - 1};
    return set->slots ? MT_OK : MT_NO_MEMORY;
}

static char small(char c) {
    return c >= 'A' && c <= 'Z' ? (char)(c + 'a' - 'A') : c;
}

/* Where the name stands, or the empty slot where it would. */
static const char **find(const mt_name_set *set, const char *name) {
    size_t at = 2166136261u; /* FNV-1a (Fowler, Noll, Vo) */
    for (const char *p = name; *p; p++) at = (at ^ (unsigned char)small(*p)) * 16777619u & 0xFFFFFFFF;
    for (at &= set->mask; set->slots[at]; at = (at + 1) & set->mask)
        if (strcasecmp(set->slots[at], name) == 0) break;
    return &set->slots[at];
}

/* ---- one name --------------------------------------------------------------------------------------------- */

typedef struct mt_stem {
    char text[STEM_MAX + 1];
    size_t length;
} mt_stem;

static void add(mt_stem *stem, char c) {
    if (stem->length < STEM_MAX) stem->text[stem->length++] = c;
    stem->text[stem->length] = '\0';
}

/* Letters beyond ASCII are left out of account: no glyph name has them that goes into a font. */
static bool is_illegal(char c) {
    return (unsigned char)c < ' ' || (unsigned char)c >= 0x7F || strchr("\"*+/:<>?[]\\()|", c);
}

static void spell(const char *name, mt_stem *stem) {
    for (const char *p = name; *p; p++) {
        bool hidden = p == name && *p == '.';
        add(stem, hidden || is_illegal(*p) ? '_' : *p);
        if (small(*p) != *p) add(stem, '_');
    }
}

static bool is_reserved(const char *part, size_t length) {
    static const char *const reserved[] = {"con", "prn", "aux", "clock$", "nul"};
    bool numbered = length == 4 && part[3] >= '1' && part[3] <= '9';
    if (numbered && (strncasecmp(part, "com", 3) == 0 || strncasecmp(part, "lpt", 3) == 0)) return true;
    for (size_t i = 0; i < sizeof reserved / sizeof *reserved; i++)
        if (strlen(reserved[i]) == length && strncasecmp(part, reserved[i], length) == 0) return true;
    return false;
}

/* A part between full stops that is the name of a device on some system gets an underscore before it. */
static void avoid_reserved(const mt_stem *from, mt_stem *stem) {
    const char *part = from->text;
    for (;;) {
        size_t length = strcspn(part, ".");
        if (is_reserved(part, length)) add(stem, '_');
        for (size_t i = 0; i < length; i++) add(stem, part[i]);
        if (!part[length]) return;
        add(stem, '.');
        part += length + 1;
    }
}

/* `file` has room for FILE_NAME_MAX bytes and a NUL. */
static void make_file_name(const char *name, const mt_name_set *taken, char *file) {
    mt_stem spelt = {0}, stem = {0};
    spell(name, &spelt);
    avoid_reserved(&spelt, &stem);
    snprintf(file, FILE_NAME_MAX + 1, "%s" SUFFIX, stem.text);
    for (int number = 1; *find(taken, file); number++)
        snprintf(file, FILE_NAME_MAX + 1, "%.*s%0*d" SUFFIX, STEM_MAX - DIGITS, stem.text, DIGITS, number);
}

mt_status mt_ufo_file_names(const char *const *names, int count, mt_arena *arena, const char ***files) {
    mt_name_set taken;
    const char **made = mt_arena_new(arena, (size_t)count, sizeof *made);
    if (!made || make_set(count, arena, &taken) != MT_OK) return MT_NO_MEMORY;
    for (int i = 0; i < count; i++) {
        char file[FILE_NAME_MAX + 1];
        make_file_name(names[i], &taken, file);
        char *copy = mt_arena_new(arena, strlen(file) + 1, 1);
        if (!copy) return MT_NO_MEMORY;
        made[i] = *find(&taken, file) = strcpy(copy, file);
    }
    *files = made;
    return MT_OK;
}
