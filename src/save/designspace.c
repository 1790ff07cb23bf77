/* designspace documents, version 4.1 (fontTools, "Designspace Document Specification"). */
#include "save/designspace.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/file.h"
#include "base/memory.h"
#include "base/xml.h"
#include "blend/family.h"
#include "save/ufo.h"

#define EXTENSION ".designspace"
#define FOLDER "-masters"
#define FIRST_MASTER "Morph-0.ufo" /* every such folder has it */

struct mt_master {
    double value; /* on the axis, in design coordinates */
    char file[32];
    char *family, *style;
};

/* ---- names ----------------------------------------------------------------------------------------------- */

char *mt_designspace_folder(const char *path) {
    size_t stem = strlen(path) - strlen(EXTENSION), room = stem + sizeof FOLDER;
    char *folder = mt_new(room, 1);
    if (folder) snprintf(folder, room, "%.*s%s", (int)stem, path, FOLDER);
    return folder;
}

static const char *last_part(const char *path) {
    const char *slash = strrchr(path, '/');
    return slash ? slash + 1 : path;
}

mt_status mt_designspace_check(const char *path) {
    char *folder = mt_designspace_folder(path);
    if (!folder) return MT_NO_MEMORY;
    mt_status status = mt_file_check(path);
    if (status == MT_OK) status = mt_folder_check(folder, FIRST_MASTER "/" MT_UFO_MARK);
    mt_free(folder);
    return status;
}

/* ---- masters --------------------------------------------------------------------------------------------- */

mt_status mt_designspace_begin(const char *path, const mt_variable *variable, mt_designspace *designspace) {
    mt_designspace made = {.path = mt_copy_text(path), .variable = variable};
    char *folder = mt_designspace_folder(path);
    mt_status status = made.path && folder ? mt_folder_begin(folder, &made.folder) : MT_NO_MEMORY;
    mt_free(folder);
    if (status != MT_OK) {
        mt_free(made.path);
        return status;
    }
    made.folder_name = last_part(made.folder.path);
    *designspace = made;
    return MT_OK;
}

static mt_status add_master(mt_designspace *designspace, const mt_font_data *data, int place,
                            struct mt_master **added) {
    struct mt_master *grown =
        mt_grow_list(designspace->masters, designspace->count, &designspace->room, sizeof *grown);
    if (!grown) return MT_NO_MEMORY;
    designspace->masters = grown;
    struct mt_master *master = &designspace->masters[designspace->count++];
    *master = (struct mt_master){.value = mt_axis_value_of(&designspace->variable->axis, place),
                                 .family = mt_copy_text(data->family),
                                 .style = mt_copy_text(data->style)};
    snprintf(master->file, sizeof master->file, "Morph-%.6g.ufo", master->value);
    *added = master;
    return master->family && master->style ? MT_OK : MT_NO_MEMORY;
}

mt_status mt_designspace_add(mt_designspace *designspace, const mt_font_data *data, int place) {
    struct mt_master *master;
    mt_status status = add_master(designspace, data, place, &master);
    if (status == MT_OK) status = mt_folder_add_folder(&designspace->folder, master->file);
    if (status != MT_OK) return status;
    size_t room = strlen(designspace->folder.temporary) + sizeof master->file + 2;
    mt_folder inner = {.temporary = mt_new(room, 1)};
    if (!inner.temporary) return MT_NO_MEMORY;
    snprintf(inner.temporary, room, "%s/%s", designspace->folder.temporary, master->file);
    status = mt_ufo_write(data, &inner, &designspace->unsaid);
    designspace->length += inner.length;
    mt_free(inner.temporary);
    return status;
}

/* ---- the document ---------------------------------------------------------------------------------------- */

/* An attribute, so exact that it reads back as the same number. */
static void write_real(const char *name, double value, mt_xml *xml) {
    char text[32];
    snprintf(text, sizeof text, "%.17g", value);
    mt_xml_attribute(xml, name, text);
}

/* In design coordinates, which are users' where nothing is mapped: where the map leads to. */
static void write_location(const mt_designspace *designspace, const char *axis, double place, mt_xml *xml) {
    mt_xml_open(xml, "location");
    mt_xml_open(xml, "dimension");
    mt_xml_attribute(xml, "name", axis);
    write_real("xvalue", mt_axis_user(&designspace->variable->axis, place), xml);
    mt_xml_close(xml);
    mt_xml_close(xml);
}

/* By what users set, ascending. */
static void write_map(const mt_axis *axis, const mt_axis_map *map, mt_xml *xml) {
    for (int i = 0; i < map->count; i++) {
        const mt_map_point *point = &map->points[mt_axis_goes_down(axis) ? map->count - 1 - i : i];
        mt_xml_open(xml, "map");
        write_real("input", mt_axis_user(axis, point->value), xml);
        write_real("output", mt_axis_user(axis, point->place), xml);
        mt_xml_close(xml);
    }
}

/* In user coordinates. */
static void write_axis(const mt_designspace *designspace, const char *name, mt_xml *xml) {
    const mt_axis *axis = &designspace->variable->axis;
    const char tag[] = {(char)(axis->tag >> 24), (char)(axis->tag >> 16 & 0xFF),
                        (char)(axis->tag >> 8 & 0xFF), (char)(axis->tag & 0xFF), '\0'};
    mt_xml_open(xml, "axes");
    mt_xml_open(xml, "axis");
    mt_xml_attribute(xml, "tag", tag);
    mt_xml_attribute(xml, "name", name);
    write_real("minimum", fmin(axis->from, axis->to), xml);
    write_real("maximum", fmax(axis->from, axis->to), xml);
    write_real("default", axis->home, xml);
    write_map(axis, &designspace->variable->map, xml);
    mt_xml_close(xml);
    mt_xml_close(xml);
}

/* An attribute for a file in a folder; where there is no memory for its name, the document ends with that. */
static void write_file_name(const char *folder, const char *file, mt_xml *xml) {
    size_t room = strlen(folder) + strlen(file) + 2;
    char *path = mt_new(room, 1);
    if (path) snprintf(path, room, "%s/%s", folder, file);
    if (path)
        mt_xml_attribute(xml, "filename", path);
    else
        xml->failed = true;
    mt_free(path);
}

static void write_source(const mt_designspace *designspace, const char *axis, const struct mt_master *master,
                         mt_xml *xml) {
    mt_xml_open(xml, "source");
    write_file_name(designspace->folder_name, master->file, xml);
    mt_xml_attribute(xml, "name", master->style);
    mt_xml_attribute(xml, "familyname", master->family);
    mt_xml_attribute(xml, "stylename", master->style);
    write_location(designspace, axis, master->value, xml);
    mt_xml_close(xml);
}

/* Letters and digits of ASCII, and what is beyond it, stay in a file's name. */
static char in_file_name(char byte) {
    bool plain = (byte >= 'a' && byte <= 'z') || (byte >= 'A' && byte <= 'Z') ||
                 (byte >= '0' && byte <= '9') || byte == '.' || (unsigned char)byte >= 0x80;
    return plain ? byte : '-';
}

/* Where programs that make instances put this one: instances/Family-Style.ufo, beside the document. */
static void write_instance_file(const char *family, const char *style, mt_xml *xml) {
    size_t room = strlen(family) + strlen(style) + sizeof "-.ufo";
    char *file = mt_new(room, 1);
    xml->failed = xml->failed || !file;
    if (!file) return;
    int stem = snprintf(file, room, "%s-%s", family, style);
    for (int i = 0; i < stem; i++) file[i] = in_file_name(file[i]);
    memcpy(file + stem, ".ufo", sizeof ".ufo");
    write_file_name("instances", file, xml);
    mt_free(file);
}

static void write_instance(const mt_designspace *designspace, const char *axis, const mt_named_place *place,
                           mt_xml *xml) {
    double along = mt_axis_along(&designspace->variable->axis, place->value);
    mt_xml_open(xml, "instance");
    write_instance_file(designspace->masters[0].family, place->name, xml);
    mt_xml_attribute(xml, "familyname", designspace->masters[0].family);
    mt_xml_attribute(xml, "stylename", place->name);
    mt_xml_attribute(xml, "name", place->name);
    write_location(designspace, axis, mt_axis_map_place(&designspace->variable->map, along), xml);
    mt_xml_close(xml);
}

static void write_document(const mt_designspace *designspace, const mt_axis_data *names, mt_xml *xml) {
    mt_xml_open(xml, "designspace");
    mt_xml_attribute(xml, "format", "4.1");
    write_axis(designspace, names->name, xml);
    mt_xml_open(xml, "sources");
    for (int i = 0; i < designspace->count; i++)
        write_source(designspace, names->name, &designspace->masters[i], xml);
    mt_xml_close(xml);
    mt_xml_open(xml, "instances");
    for (int i = 0; i < names->named_count; i++)
        write_instance(designspace, names->name, &names->named[i], xml);
    mt_xml_close(xml);
    mt_xml_close(xml);
}

/* ---- the end --------------------------------------------------------------------------------------------- */

mt_status mt_designspace_end(mt_designspace *designspace, mt_file_set *set) {
    const char *text;
    size_t length;
    mt_arena arena = {0};
    mt_axis_data names = {.axis = designspace->variable->axis};
    const double ends[] = {names.axis.from, names.axis.to};
    mt_xml xml = mt_xml_begin();
    mt_status status = mt_variable_name_places(designspace->variable, ends, 2, &arena, &names);
    if (status == MT_OK) write_document(designspace, &names, &xml);
    if (status == MT_OK) status = mt_xml_end(&xml, &text, &length);
    if (status == MT_OK)
        status = mt_file_set_add_folder(set, &designspace->folder, FIRST_MASTER "/" MT_UFO_MARK);
    if (status == MT_OK) status = mt_file_set_add(set, designspace->path, text, length);
    mt_xml_free(&xml);
    mt_arena_release(&arena);
    if (status == MT_OK) designspace->length += length;
    return status;
}

void mt_designspace_free(mt_designspace *designspace) {
    int why = errno;
    for (int i = 0; i < designspace->count; i++) {
        mt_free(designspace->masters[i].family);
        mt_free(designspace->masters[i].style);
    }
    mt_free(designspace->masters);
    mt_free(designspace->path);
    mt_folder_free(&designspace->folder);
    *designspace = (mt_designspace){0};
    errno = why;
}
