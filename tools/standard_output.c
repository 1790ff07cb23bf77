#include "standard_output.h"

#include "base/temporaries.h"
#include "base/tree.h"
#include "messages.h"
#include "work.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <unistd.h>

#define TEXTS "svg html json obj off" /* formats that a terminal may show */

/* Whether `word` is one of words with blanks between. */
static bool is_among(const char *word, const char *words) {
    size_t length = strlen(word);
    for (const char *at = words; *at; at += strspn(at, " ")) {
        size_t this = strcspn(at, " ");
        if (this == length && strncasecmp(at, word, length) == 0) return true;
        at += this;
    }
    return false;
}

static int check(const cli_command *command, const cli_options *options) {
    const char *format = options->format;
    if (!format) return misuse(command->name, "-o -: --format is wanted, one of %s", command->writes);
    if (!is_among(format, command->writes))
        return misuse(command->name, "--format %s: one of %s is wanted", format, command->writes);
    if (options->json) return misuse(command->name, "-o -: --json is for stdout too");
    if (isatty(STDOUT_FILENO) && !is_among(format, TEXTS))
        return misuse(command->name, "-o -: a terminal shows no %s; a file or a pipe is wanted", format);
    return DONE;
}

static int make_folder(const cli_options *options, standard_output *output) {
    const char *directory = getenv("TMPDIR");
    int length = snprintf(output->folder, sizeof output->folder, "%s/morphotype-XXXXXX",
                          directory && *directory ? directory : "/tmp");
    bool fits = length >= 0 && (size_t)length < sizeof output->folder - 32;
    if (!fits || !mkdtemp(output->folder)) {
        *output = (standard_output){0};
        return fail_status("stdout: a folder for temporary files", MT_CANNOT_WRITE);
    }
    mt_temporary_begin(output->folder);
    snprintf(output->path, sizeof output->path, "%.*s/stdout.%.16s", length, output->folder, options->format);
    return DONE;
}

int standard_output_begin(const cli_command *command, cli_options *options, standard_output *output) {
    bool wanted = options->output && strcmp(options->output, "-") == 0;
    *output = (standard_output){0};
    if (!wanted && options->format) return misuse(command->name, "--format is for -o -");
    if (!wanted) return DONE;
    int outcome = check(command, options);
    if (outcome == DONE) outcome = make_folder(options, output);
    if (outcome == DONE) options->output = output->path;
    return outcome;
}

/* How many files and folders there are. */
static int count_made(const standard_output *output) {
    int count = 0;
    DIR *folder = opendir(output->folder);
    for (struct dirent *entry; folder && (entry = readdir(folder));)
        count += strcmp(entry->d_name, ".") != 0 && strcmp(entry->d_name, "..") != 0;
    if (folder) closedir(folder);
    return count;
}

/* main looks whether stdout took it all. */
static int print(const standard_output *output) {
    struct stat made;
    char block[1 << 14];
    if (count_made(output) != 1 || stat(output->path, &made) != 0 || !S_ISREG(made.st_mode))
        return fail("stdout: it takes one file, and this makes several, or a folder");
    FILE *file = fopen(output->path, "rb");
    if (!file) return fail_status("stdout", MT_CANNOT_WRITE);
    for (size_t read; (read = fread(block, 1, sizeof block, file)) > 0;) fwrite(block, 1, read, stdout);
    bool whole = !ferror(file);
    fclose(file);
    return whole ? DONE : fail_status("stdout", MT_CANNOT_WRITE);
}

int standard_output_end(standard_output *output, int outcome) {
    if (!*output->folder) return outcome;
    if (outcome == DONE) outcome = print(output);
    mt_tree_remove(output->folder);
    mt_temporary_end(output->folder);
    return outcome;
}
