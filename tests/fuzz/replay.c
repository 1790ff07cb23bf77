/* Gives a harness the files of a folder, in the order of their names, and an empty input: what was found stays mended. For compilers that
 * have no libFuzzer, and for the tests.
 *
 *     replay FOLDER */
#include "fuzz.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/file.h"
#include "base/memory.h"

static int is_visible(const struct dirent *entry) {
    return entry->d_name[0] != '.';
}

static void replay(const char *folder, const char *name) {
    char path[4096];
    uint8_t *bytes;
    size_t length;
    snprintf(path, sizeof path, "%s/%s", folder, name);
    fuzz_require(mt_file_read(path, 1 << 24, &bytes, &length) == MT_OK);
    fprintf(stderr, "%s\n", name);
    LLVMFuzzerTestOneInput(bytes, length);
    mt_free(bytes);
}

int main(int count, char **arguments) {
    struct dirent **entries;
    fuzz_require(count == 2);
    int files = scandir(arguments[1], &entries, is_visible, alphasort);
    fuzz_require(files > 0);
    LLVMFuzzerTestOneInput((const uint8_t *)"", 0);
    for (int i = 0; i < files; i++) {
        replay(arguments[1], entries[i]->d_name);
        free(entries[i]);
    }
    free(entries);
    return 0;
}
