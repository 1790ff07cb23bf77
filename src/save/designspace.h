/* A variable font as its masters: a designspace document, and beside it a folder with a UFO for each. */
#pragma once

#include "base/file_set.h"
#include "blend/row.h"
#include "write/font_data.h"

/* In the making: nothing is in its place yet. */
typedef struct mt_designspace {
    char *path; /* of the document, NAME.designspace; the folder is NAME-masters */
    const char *folder_name;
    mt_folder folder;
    int count, room;
    struct mt_master *masters;
    const mt_variable *variable;
    size_t length; /* of all files, bytes */
    int unsaid;    /* the most of one master, as mt_ufo_write has it */
} mt_designspace;

/* Where the folder of the masters goes: NAME-masters for NAME.designspace; from mt_new, NULL when out of memory. */
char *mt_designspace_folder(const char *path);

/* Whether both may stand there: mt_file_check, mt_folder_check. */
mt_status mt_designspace_check(const char *path);

/* Keeps using the variable font: its axis, map and named places. */
mt_status mt_designspace_begin(const char *path, const mt_variable *variable, mt_designspace *designspace);
/* Adds the master at a place of the axis (axis_data.h); the first is at its start, and the last at its end. As mt_ufo_write. */
mt_status mt_designspace_add(mt_designspace *designspace, const mt_font_data *master, int place);
/* Adds both to what is to be placed. MT_CANNOT_WRITE (errno says why), MT_NO_MEMORY. */
mt_status mt_designspace_end(mt_designspace *designspace, mt_file_set *set);
void mt_designspace_free(mt_designspace *designspace);
