/* morphotype solid: what is between two solids, as a morph target, as meshes, as a picture or as data. */
#include "base/file.h"
#include "base/file_set.h"
#include "commands.h"
#include "mesh/read.h"
#include "mesh/solid_blend.h"
#include "mesh/write.h"
#include "messages.h"
#include "outputs.h"
#include "picture/canvas.h"
#include "scene/strip.h"
#include "sources.h"
#include "work.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

#define STEPS 9
#define SIZE 160.0
#define DURATION 2.0

/* What the output is. */
typedef enum output_kind { MORPH, MESHES, PICTURE, DATA } output_kind;

typedef struct solid_work {
    cli_options *options;
    output_kind kind;
    mt_mesh_format format; /* of meshes */
    mt_solid_blend *blend;
} solid_work;

/* ---- what is asked ------------------------------------------------------------------------------------- */

static bool is_data(const char *path) {
    const char *dot = strrchr(path, '.');
    return dot && strcasecmp(dot, ".json") == 0;
}

static int find_kind(solid_work *this) {
    const cli_options *options = this->options;
    mt_format picture;
    bool places = options->at_count > 0 || options->steps > 0;
    if (!options->output || is_data(options->output))
        this->kind = DATA;
    else if (mt_format_of(options->output, &picture) == MT_OK)
        this->kind = PICTURE;
    else if (mt_mesh_format_of(options->output, &this->format))
        this->kind = this->format == MT_MESH_GLB && !places ? MORPH : MESHES;
    else
        return misuse(options->command,
                      "-o %s: solid writes .glb, .obj, .stl, .ply, .off, .png, .svg, .pdf and .json",
                      options->output);
    return DONE;
}

static int check(solid_work *this) {
    const cli_options *options = this->options;
    if (options->font_count < 2) return misuse(options->command, "two solids are wanted: A.obj B.obj");
    if (!options->output && !options->json)
        return misuse(options->command, "-o OUT.glb|obj|stl|ply|off|png|svg|pdf or --json is wanted");
    if (options->params.rotation == MT_ROTATION_FOUND)
        return misuse(options->command,
                      "--rotate auto: the angle of two solids is not found; DEGREES are wanted");
    if (options->size != 0 && (options->size < MT_SCENE_SIZE_MIN || options->size > MT_SCENE_SIZE_MAX))
        return misuse(options->command, "--size: a number from %g to %g is wanted", MT_SCENE_SIZE_MIN,
                      MT_SCENE_SIZE_MAX);
    int outcome = find_kind(this);
    if (outcome == DONE && this->kind == MESHES) outcome = outputs_check_places(options);
    return outcome;
}

/* ---- the solids ---------------------------------------------------------------------------------------- */

static int open_solid(const char *path, mt_solid **solid) {
    mt_mesh_fault fault;
    errno = 0;
    mt_status status = mt_solid_open(path, solid, &fault);
    if (status == MT_OK) return DONE;
    if (status == MT_UNKNOWN_FORMAT)
        return fail("%s: solids are read from .obj, .stl, .ply, .off and .glb", path);
    if (status == MT_NO_MEMORY || !fault.line[0]) return fail_status(path, status);
    return fail("%s: %s", path, fault.line);
}

static mt_solid_params params_of(const cli_options *options) {
    mt_solid_params params = mt_solid_params_default();
    const cli_solid *asked = &options->solid;
    params.method = options->params.method;
    if (asked->depth > 0) params.depth = asked->depth;
    if (asked->axis.x != 0 || asked->axis.y != 0 || asked->axis.z != 0) params.axis = asked->axis;
    if (options->params.rotation == MT_ROTATION_GIVEN) params.degrees = options->params.degrees;
    return params;
}

static int make_blend(solid_work *this) {
    const cli_options *options = this->options;
    mt_solid *solids[2] = {NULL, NULL};
    mt_solid_params params = params_of(options);
    char names[8192];
    int outcome = DONE;
    for (int i = 0; i < 2 && outcome == DONE; i++) outcome = open_solid(options->fonts[i], &solids[i]);
    if (outcome == DONE) {
        mt_status status = mt_solid_blend_new(solids[0], solids[1], &params, &this->blend);
        work_name(options, names, sizeof names);
        if (status != MT_OK) outcome = fail_status(names, status);
    }
    for (int i = 0; i < 2; i++) mt_solid_free(solids[i]);
    return outcome;
}

static void tell(const solid_work *this) {
    const mt_solid_morph *morph = &this->blend->morph;
    const mt_solid_side *sides[] = {&morph->a, &morph->b};
    for (int i = 0; i < 2; i++)
        say("%s: %d component%s, %d piece%s", this->options->fonts[i], sides[i]->n_components,
            sides[i]->n_components == 1 ? "" : "s", sides[i]->n_pieces, sides[i]->n_pieces == 1 ? "" : "s");
    say("%d link%s", morph->n_links, morph->n_links == 1 ? "" : "s");
}

/* ---- meshes -------------------------------------------------------------------------------------------- */

static mt_status make_file(const solid_work *this, double t, mt_buffer *file) {
    mt_arena arena = {0};
    mt_mesh mesh;
    mt_status status = mt_solid_blend_at(this->blend, t, &arena, &mesh);
    if (status == MT_OK) status = mt_mesh_write(&mesh, this->format, file);
    mt_arena_release(&arena);
    return status;
}

static void tell_overlaps(const solid_work *this) {
    const cli_options *options = this->options;
    bool between = this->kind == MORPH;
    for (int i = 0; i < options->at_count; i++)
        between = between || (options->at[i] > 0 && options->at[i] < 1);
    if (options->quiet || !between || this->blend->morph.n_links < 2) return;
    say("%s: between the two, the solid is the union of %d closed meshes that overlap", options->output,
        this->blend->morph.n_links);
}

/* Puts the files in their places: all of them or none. */
static int place_files(const outputs *named, const mt_buffer *files) {
    mt_file_set set;
    int at = 0;
    errno = 0;
    mt_status status = mt_file_set_begin(named->paths[0], &set);
    if (status != MT_OK) return fail_status(named->paths[0], status);
    for (; at < named->count; at++) {
        status = mt_file_set_add(&set, named->paths[at], files[at].bytes, files[at].length);
        if (status != MT_OK) break;
    }
    if (status == MT_OK) status = mt_file_set_place(&set, &at);
    mt_file_set_free(&set);
    return status == MT_OK ? DONE : fail_status(named->paths[at], status);
}

static int make_files(const solid_work *this, const outputs *named, mt_buffer *files) {
    const cli_options *options = this->options;
    for (int i = 0; i < named->count; i++) {
        mt_status status = make_file(this, options->at[i], &files[i]);
        if (status != MT_OK) return fail_status(named->paths[i], status);
        named->lengths[i] = files[i].length;
    }
    int outcome = place_files(named, files);
    for (int i = 0; options->verbose && outcome == DONE && i < named->count; i++)
        say("%s: T = %g, %zu bytes", named->paths[i], options->at[i], named->lengths[i]);
    return outcome;
}

static int write_meshes(const solid_work *this, const outputs *named) {
    mt_buffer *files = mt_new((size_t)named->count, sizeof *files);
    int outcome = files ? make_files(this, named, files) : fail_status(this->options->output, MT_NO_MEMORY);
    for (int i = 0; files && i < named->count; i++) mt_buffer_free(&files[i]);
    mt_free(files);
    return outcome;
}

static int write_morph(const solid_work *this) {
    const cli_options *options = this->options;
    double duration = options->motion.timing.duration > 0 ? options->motion.timing.duration : DURATION;
    errno = 0;
    mt_status status =
        mt_solid_blend_save_morph(this->blend, duration, options->motion.timing.yoyo, options->output);
    return status == MT_OK ? DONE : fail_status(options->output, status);
}

/* ---- pictures and data --------------------------------------------------------------------------------- */

static mt_status step_mesh(int step, mt_arena *arena, mt_mesh *mesh, void *user) {
    const solid_work *this = user;
    return mt_solid_blend_at(this->blend, this->options->at[step], arena, mesh);
}

static int write_picture(solid_work *this) {
    const cli_options *options = this->options;
    mt_solid_strip strip = {.at = options->at,
                            .step_count = options->at_count,
                            .size = options->size > 0 ? options->size : SIZE,
                            .turn = options->solid.turn,
                            .tilt = options->solid.tilt,
                            .labels = !options->no_labels,
                            .mesh = step_mesh,
                            .user = this};
    errno = 0;
    mt_status status = mt_solid_strip_save(&strip, options->output);
    return status == MT_OK ? DONE : fail_status(options->output, status);
}

/* Into the file, or to stdout where it is not one of data. */
static int write_data(const solid_work *this) {
    const cli_options *options = this->options;
    mt_buffer text;
    int outcome = DONE;
    const char *path = this->kind == DATA ? options->output : NULL;
    mt_status status = mt_solid_blend_json(this->blend, options->fonts[0], options->fonts[1], &text);
    errno = 0;
    if (status == MT_OK && path) status = mt_file_write(path, text.bytes, text.length);
    if (status != MT_OK)
        outcome = fail_status(path ? path : "stdout", status);
    else if (!path)
        fwrite(text.bytes, 1, text.length, stdout); /* main looks whether stdout took it all */
    mt_buffer_free(&text);
    return outcome;
}

/* ---- the command --------------------------------------------------------------------------------------- */

static int write_output(solid_work *this, const outputs *named) {
    int outcome = DONE;
    if (this->options->verbose) tell(this);
    if (this->kind == MORPH) outcome = write_morph(this);
    if (this->kind == MESHES) outcome = write_meshes(this, named);
    if (this->kind == PICTURE) outcome = write_picture(this);
    if (outcome == DONE && (this->kind == MORPH || this->kind == MESHES)) tell_overlaps(this);
    if (outcome == DONE && (this->kind == DATA || this->options->json)) outcome = write_data(this);
    return outcome;
}

static int check_outputs(const solid_work *this, const outputs *named) {
    int outcome = DONE;
    if (this->kind != MESHES) return this->options->output ? output_check(this->options->output) : DONE;
    for (int i = 0; i < named->count && outcome == DONE; i++) {
        outcome = output_check(named->paths[i]);
        if (outcome == DONE) outcome = sources_spare(this->options, named->paths[i]);
    }
    return outcome;
}

static int run(cli_options *options) {
    solid_work this = {.options = options};
    outputs named = {0};
    int outcome = check(&this);
    if (outcome == DONE && this.kind == MESHES) outcome = options_spread(options, 1);
    if (outcome == DONE && this.kind == PICTURE) outcome = options_spread(options, STEPS);
    if (outcome == DONE && this.kind == MESHES) {
        mt_status status = outputs_name(options, &named);
        if (status != MT_OK) outcome = fail_status(options->output, status);
    }
    if (outcome == DONE) outcome = check_outputs(&this, &named);
    if (outcome == DONE) outcome = make_blend(&this);
    if (outcome == DONE) outcome = write_output(&this, &named);
    mt_solid_blend_free(this.blend);
    outputs_free(&named);
    return outcome;
}

const cli_command solid_command = {
    .name = "solid",
    .summary = "the solids between two solids, as a morph target, meshes or a picture",
    .synopsis = "SOLID SOLID -o OUT.glb|obj|stl|ply|off|png|svg|pdf [--json] [OPTION...]",
    .text =
        "A SOLID is a closed mesh: .obj, .stl, .ply, .off or .glb; y is up in both.\n"
        "OUT.glb is a mesh that has the second solid as its morph target, and moves. With --at or --steps it "
        "is "
        "the mesh at these places, and so are OUT.obj, .stl, .ply and .off, at T = 0.5 without: OUT-0.25.obj "
        "and so on where there are several. OUT.png, .svg and .pdf draw 9 places side by side, or those of "
        "--at or --steps, with T under each.\n"
        "With --json the components, pieces and links come as data: on stdout, or in OUT when that ends in "
        ".json.",
    .examples = {{"One mesh that moves from the first solid to the second, for a browser or a game:",
                  "morphotype solid block.obj goblet.obj -o goblet.glb"},
                 {"Nine places in a row:", "morphotype solid block.obj goblet.obj --steps 9 -o goblet.png"},
                 {"Meshes to print:",
                  "morphotype solid duck.obj iron.obj --at 0.25,0.5,0.75 -o between.stl"}},
    .reads = "obj stl ply off glb",
    .writes = "glb obj stl ply off png svg pdf json",
    .takes = "oanzlJiuWDy",
    .leaves = "fjTwrmsIHg",
    .fonts_min = 0,
    .fonts_max = 2,
    .run = run,
};
