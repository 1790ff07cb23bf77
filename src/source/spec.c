#include "source/spec.h"

#include <errno.h>
#include <string.h>
#include <sys/stat.h>

#include "base/decimal.h"
#include "base/memory.h"

static bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/* Whether `path` may be the file; errno says why not. */
static bool is_file(const char *path) {
    struct stat about;
    if (stat(path, &about) != 0) return false;
    if (!S_ISDIR(about.st_mode)) return true;
    errno = EISDIR;
    return false;
}

/* Cuts `path`, a copy of `text`, down to the file that it names, and returns what follows there; NULL when
 * there is no such file. */
static const char *split(const char *text, char *path) {
    for (size_t end = strlen(text); end > 0; end--) {
        if (text[end] && text[end] != '#' && text[end] != '@') continue;
        path[end] = '\0';
        if (is_file(path)) return text + end;
    }
    if (!*text) errno = ENOENT;
    return NULL;
}

/* Reads #FACE; a face number fits 16 bits in every format. */
static bool read_face(const char **text, int *face) {
    const char *c = *text + 1;
    int number = 0;
    if (!is_digit(*c)) return false;
    for (; is_digit(*c); c++) {
        number = 10 * number + (*c - '0');
        if (number > UINT16_MAX) return false;
    }
    *text = c;
    *face = number;
    return *c == '\0' || *c == '@';
}

/* Reads the tag up to its '=': one to four printable characters. */
static bool read_tag(const char **text, uint32_t *tag) {
    const char *c = *text;
    *tag = 0;
    for (int i = 0; i < 4; i++) {
        bool named = *c > ' ' && *c <= '~' && *c != '=' && *c != ',';
        *tag = *tag << 8 | (uint32_t)(named ? *c++ : ' ');
    }
    bool read = c > *text && *c == '=';
    *text = c + 1;
    return read;
}

static bool is_set(const mt_spec *spec, uint32_t tag) {
    for (int i = 0; i < spec->axis_count; i++)
        if (spec->axes[i].tag == tag) return true;
    return false;
}

/* Reads @AXIS=VALUE,… to the end of the text. */
static bool read_axes(const char *text, mt_spec *spec) {
    do {
        mt_axis_setting axis;
        text++; /* the @, then each comma */
        if (spec->axis_count == MT_SPEC_AXES) return false;
        if (!read_tag(&text, &axis.tag) || !mt_decimal_next(&text, &axis.value)) return false;
        if (is_set(spec, axis.tag)) return false;
        spec->axes[spec->axis_count++] = axis;
    } while (*text == ',');
    return *text == '\0';
}

static mt_status read_rest(const char *rest, mt_spec *spec) {
    if (*rest == '#' && !read_face(&rest, &spec->face)) return MT_NO_FACE;
    if (*rest == '@' && !read_axes(rest, spec)) return MT_BAD_AXIS;
    return MT_OK;
}

mt_status mt_spec_parse(const char *text, mt_spec *spec) {
    mt_spec read = {.path = mt_copy_text(text)};
    if (!read.path) return MT_NO_MEMORY;
    const char *rest = split(text, read.path);
    mt_status status = rest ? read_rest(rest, &read) : MT_NO_FILE;
    if (status == MT_OK) {
        *spec = read;
        return MT_OK;
    }
    int why = errno;
    mt_spec_clear(&read);
    errno = why;
    return status;
}

void mt_spec_clear(mt_spec *spec) {
    mt_free(spec->path);
    *spec = (mt_spec){0};
}
