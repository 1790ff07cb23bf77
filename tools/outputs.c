#include "outputs.h"

#include "base/memory.h"
#include "messages.h"
#include "numbers.h"

#include <stdio.h>
#include <string.h>

/* OUT.ttf, or OUT-0.25.ttf or OUT-0.25,y=0.5.ttf where there are several; from mt_new, NULL when out of memory. */
static char *path_of(const cli_options *options, int index) {
    char t[32], up[32];
    bool own_height = options->at_up[index] != options->at[index];
    if (options->at_count == 1) return mt_copy_text(options->output);
    size_t room = strlen(options->output) + sizeof t + sizeof up + 4;
    int stem = (int)(strrchr(options->output, '.') - options->output);
    char *path = mt_new(room, 1);
    number_write(options->at[index], t);
    number_write(options->at_up[index], up);
    if (path)
        snprintf(path, room, "%.*s-%s%s%s%s", stem, options->output, t, own_height ? ",y=" : "",
                 own_height ? up : "", options->output + stem);
    return path;
}

mt_status outputs_name(const cli_options *options, outputs *named) {
    size_t count = (size_t)options->at_count;
    named->paths = mt_new(count, sizeof *named->paths);
    named->lengths = mt_new(count, sizeof *named->lengths);
    if (!named->paths || !named->lengths) return MT_NO_MEMORY;
    named->count = options->at_count;
    for (int i = 0; i < named->count; i++) {
        named->paths[i] = path_of(options, i);
        if (!named->paths[i]) return MT_NO_MEMORY;
    }
    return MT_OK;
}

void outputs_free(outputs *named) {
    for (int i = 0; i < named->count; i++) mt_free(named->paths[i]);
    mt_free(named->paths);
    mt_free(named->lengths);
}

int outputs_check_places(const cli_options *options) {
    for (int i = 0; i < options->at_count; i++)
        for (int k = 0; k < i; k++)
            if (options->at[i] == options->at[k] && options->at_up[i] == options->at_up[k])
                return misuse(options->command, "--at: %g stands there twice", options->at[i]);
    return DONE;
}
