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
        if (text[end] && !strchr("#@:", text[end])) continue;
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
    return *c == '\0' || *c == '@' || *c == ':';
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

/* Reads @AXIS=VALUE,… to the end of the text or the features. */
static bool read_axes(const char **text, mt_spec *spec) {
    const char *c = *text;
    do {
        mt_axis_setting axis;
        c++; /* the @, then each comma */
        if (spec->axis_count == MT_SPEC_AXES) return false;
        if (!read_tag(&c, &axis.tag) || !mt_decimal_next(&c, &axis.value)) return false;
        if (is_set(spec, axis.tag)) return false;
        spec->axes[spec->axis_count++] = axis;
    } while (*c == ',');
    *text = c;
    return *c == '\0' || *c == ':';
}

/* ---- features ------------------------------------------------------------------------------------------ */

/* Reads a tag up to what is not part of it: four printable characters at most. */
static bool read_feature_tag(const char **text, uint32_t *tag) {
    const char *c = *text;
    *tag = 0;
    for (int i = 0; i < 4; i++) {
        bool named = *c > ' ' && *c <= '~' && !strchr("=,:", *c);
        *tag = *tag << 8 | (uint32_t)(named ? *c++ : ' ');
    }
    bool read = c > *text;
    *text = c;
    return read;
}

/* Moves past a word that ends a setting, if it is this one. */
static bool skip_word(const char **text, const char *word) {
    size_t length = strlen(word);
    if (strncmp(*text, word, length) != 0) return false;
    *text += length;
    return true;
}

/* Reads on, off or a whole number of 8 bits, which are as many as HarfBuzz has. */
static bool read_feature_value(const char **text, uint32_t *value) {
    const char *c = *text;
    *value = 1;
    if (skip_word(text, "on")) return true;
    *value = 0;
    if (skip_word(text, "off")) return true;
    for (; is_digit(*c) && *value <= UINT8_MAX; c++) *value = 10 * *value + (uint32_t)(*c - '0');
    bool read = c > *text && *value <= UINT8_MAX;
    *text = c;
    return read;
}

static bool has_feature(const mt_spec *spec, uint32_t tag) {
    for (int i = 0; i < spec->feature_count; i++)
        if (spec->features[i].tag == tag) return true;
    return false;
}

/* Reads :FEATURE[=VALUE],… to the end of the text. */
static bool read_features(const char *text, mt_spec *spec) {
    do {
        mt_feature_setting feature = {.value = 1};
        text++; /* the colon, then each comma */
        if (spec->feature_count == MT_SPEC_FEATURES || !read_feature_tag(&text, &feature.tag)) return false;
        if (*text == '=' && (text++, !read_feature_value(&text, &feature.value))) return false;
        if (has_feature(spec, feature.tag)) return false;
        spec->features[spec->feature_count++] = feature;
    } while (*text == ',');
    return *text == '\0';
}

/* ---- the spec ------------------------------------------------------------------------------------------ */

static mt_status read_rest(const char *rest, mt_spec *spec) {
    if (*rest == '#' && !read_face(&rest, &spec->face)) return MT_NO_FACE;
    if (*rest == '@' && !read_axes(&rest, spec)) return MT_BAD_AXIS;
    if (*rest == ':' && !read_features(rest, spec)) return MT_BAD_FEATURE;
    return MT_OK;
}

/* Hands over what was read, or clears it away. */
static mt_status finish(mt_status status, mt_spec *read, mt_spec *spec) {
    if (status == MT_OK) {
        *spec = *read;
        return MT_OK;
    }
    int why = errno;
    mt_spec_clear(read);
    errno = why;
    return status;
}

mt_status mt_spec_parse(const char *text, mt_spec *spec) {
    mt_spec read = {.path = mt_copy_text(text)};
    if (!read.path) return MT_NO_MEMORY;
    const char *rest = split(text, read.path);
    return finish(rest ? read_rest(rest, &read) : MT_NO_FILE, &read, spec);
}

/* What follows the path: nothing, or what one of these begins. */
static mt_status read_choice(const char *choice, mt_spec *spec) {
    if (*choice && !strchr("#@:", *choice)) return MT_BAD_PARAMETER;
    return read_rest(choice, spec);
}

mt_status mt_spec_parse_choice(const char *name, const char *choice, mt_spec *spec) {
    mt_spec read = {.path = mt_copy_text(name)};
    if (!read.path) return MT_NO_MEMORY;
    return finish(read_choice(choice, &read), &read, spec);
}

void mt_spec_clear(mt_spec *spec) {
    mt_free(spec->path);
    *spec = (mt_spec){0};
}
