/* What the page's worker calls: the variable font of two files, made as `morphotype variable` makes it, with the command line's words on
 * stderr. Files lie in emscripten's memory. Each call gives an exit code of the command line. */
#include <emscripten.h>
#include <stdio.h>
#include <string.h>

#include "base/file.h"
#include "base/memory.h"
#include "messages.h"
#include "specimen/specimen.h"
#include "work.h"

/* An mt_progress of the worker's: host.js. */
extern void web_progress(int done, int all, void *user);

/* ---- the font and its specimen --------------------------------------------------------------------------- */

/* `stem` and an extension; from mt_new, NULL when out of memory. */
static char *name_output(const char *stem, const char *extension) {
    size_t room = strlen(stem) + strlen(extension) + 1;
    char *name = mt_new(room, 1);
    if (name) snprintf(name, room, "%s%s", stem, extension);
    return name;
}

static mt_status write_output(const char *stem, const char *extension, const uint8_t *bytes, size_t length) {
    char *name = name_output(stem, extension);
    mt_status status = name ? mt_file_write(name, bytes, length) : MT_NO_MEMORY;
    mt_free(name);
    return status;
}

static mt_status write_all(const char *stem, const mt_specimen_made *made) {
    mt_status status = write_output(stem, ".ttf", made->font, made->font_length);
    if (status == MT_OK) status = write_output(stem, ".woff2", made->packed, made->packed_length);
    return status == MT_OK ? write_output(stem, ".html", made->page.bytes, made->page.length) : status;
}

static mt_status make_fonts(cli_work *work) {
    const mt_specimen_request request = {.variable = work->variable, .made = work_made, .user = work};
    mt_specimen_made made;
    mt_status status = mt_specimen_make(&request, &made);
    if (status != MT_OK) return status;
    status = write_all(work->options->output, &made);
    mt_specimen_made_free(&made);
    return status;
}

static mt_status make_masters(cli_work *work) {
    mt_status status = mt_variable_save(work->variable, work->options->output);
    return status == MT_OK ? work_made(work) : status;
}

/* ---- what the worker calls -------------------------------------------------------------------------------- */

/* Opens both files and makes something of them. */
static int run(const char *a, const char *b, const char *output, mt_status (*make)(cli_work *work)) {
    const cli_options options = {.command = "variable",
                                 .fonts = {a, b},
                                 .font_count = 2,
                                 .output = output,
                                 .params = mt_params_default()};
    cli_work work;
    int outcome = work_begin_variable(&options, &work);
    if (outcome == DONE) {
        mt_variable_on_progress(work.variable, web_progress, NULL);
        mt_status status = work_warn(&work);
        if (status == MT_OK) status = make(&work);
        if (status != MT_OK) outcome = work_fail(&work, status);
    }
    work_end(&work);
    return outcome;
}

/* Makes STEM.ttf, STEM.woff2 and STEM.html, a specimen. */
EMSCRIPTEN_KEEPALIVE int web_make(const char *a, const char *b, const char *stem);
int web_make(const char *a, const char *b, const char *stem) {
    return run(a, b, stem, make_fonts);
}

/* Makes PATH, a designspace, and its masters in a folder beside it. */
EMSCRIPTEN_KEEPALIVE int web_make_masters(const char *a, const char *b, const char *path);
int web_make_masters(const char *a, const char *b, const char *path) {
    return run(a, b, path, make_masters);
}
