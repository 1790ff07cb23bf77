#include "sources.h"

#include "base/memory.h"
#include "messages.h"
#include "work.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

/* ---- what is read -------------------------------------------------------------------------------------------- */

static bool is_same(const struct stat *a, const struct stat *b) {
    return a->st_dev == b->st_dev && a->st_ino == b->st_ino;
}

/* The file at the start of an argument, FILE#FACE@AXIS=VALUE or FILE=TEXT: the longest start that names one. False where there is
 * none; then `path`, a copy of the argument, is spoilt. */
static bool find_file(char *path, struct stat *about) {
    for (size_t length = strlen(path); length > 0; length--) {
        path[length] = '\0';
        if (stat(path, about) == 0 && !S_ISDIR(about->st_mode)) return true;
    }
    return false;
}

/* Whether the file at `path` is somewhere in the directory. */
static bool is_within(const char *path, const struct stat *directory) {
    struct stat about;
    bool within = false;
    char *whole = realpath(path, NULL), *slash;
    while (whole && !within && (slash = strrchr(whole, '/')) && slash > whole) {
        *slash = '\0';
        within = stat(whole, &about) == 0 && is_same(&about, directory);
    }
    free(whole);
    return within;
}

/* Whether what is about to be written is the source that an argument names, or a directory around it. */
static int spare(const char *argument, const char *output, const struct stat *about) {
    struct stat source;
    char *path = mt_copy_text(argument);
    if (!path) return fail_status(argument, MT_NO_MEMORY);
    bool found = find_file(path, &source);
    int outcome = DONE;
    if (found && is_same(&source, about))
        outcome = fail("%s: is the same file as the source %s, which is not written over", output, path);
    else if (found && S_ISDIR(about->st_mode) && is_within(path, about))
        outcome = fail("%s: has the source %s in it, which is not written over", output, path);
    mt_free(path);
    return outcome;
}

int sources_spare(const cli_options *options, const char *path) {
    const char *const files[] = {options->chars_file, options->pairs_file, options->hints_file};
    struct stat about;
    int outcome = DONE;
    if (stat(path, &about) != 0) return DONE;
    for (int i = 0; outcome == DONE && i < options->font_count; i++)
        outcome = spare(options->fonts[i], path, &about);
    for (size_t i = 0; outcome == DONE && i < sizeof files / sizeof *files; i++)
        if (files[i]) outcome = spare(files[i], path, &about);
    return outcome;
}

/* ---- numbered files -------------------------------------------------------------------------------------------- */

/* Whether `name` is STEM-NUMBER.END of STEM.END, with one of the numbers. */
static bool is_numbered(const char *name, const char *base, int count) {
    char last[16];
    const char *dot = strrchr(base, '.');
    size_t stem = (size_t)(dot - base);
    if (strncmp(name, base, stem) != 0 || name[stem] != '-') return false;
    const char *number = name + stem + 1;
    size_t digits = strspn(number, "0123456789");
    if (digits == 0 || digits > 9 || strcmp(number + digits, dot) != 0) return false;
    return count == 0 || (atoi(number) <= count && (int)digits == snprintf(last, sizeof last, "%d", count));
}

int sources_spare_numbered(const cli_options *options, const char *path, int count) {
    const char *slash = strrchr(path, '/'), *base = slash ? slash + 1 : path;
    size_t room = strlen(path) + sizeof((struct dirent *)0)->d_name + 3;
    char *name = mt_new(room, 1);
    if (!name) return fail_status(path, MT_NO_MEMORY);
    size_t start = (size_t)(base - path);
    memcpy(name, slash ? path : ".", slash ? start : 1);
    DIR *directory = opendir(name);
    int outcome = DONE;
    for (struct dirent *entry; directory && outcome == DONE && (entry = readdir(directory));) {
        if (!is_numbered(entry->d_name, base, count)) continue;
        strcpy(name + start, entry->d_name);
        outcome = sources_spare(options, name);
    }
    if (directory) closedir(directory);
    mt_free(name);
    return outcome;
}
