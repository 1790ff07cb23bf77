/* Directories that appear whole or not at all. */
#pragma once

#include "morphotype.h"

/* A directory in the making, beside its place and under another name. */
typedef struct mt_folder {
    char *path;      /* its place */
    char *temporary; /* where it is until then; NULL where nothing is any more */
    size_t length;   /* of all files in it, bytes */
} mt_folder;

/* Whether a folder may stand at `path`: nothing does, or a directory that holds a file named `mark`, as all folders of
 * that kind do. MT_CANNOT_WRITE (errno says why), MT_NO_MEMORY. */
mt_status mt_folder_check(const char *path, const char *mark);

/* DIRECTORY/NAME, from mt_new; NULL when out of memory. */
char *mt_folder_path_in(const char *directory, const char *name);

/* Makes an empty one; then folders and files in it, by their paths within it. MT_CANNOT_WRITE (errno says why),
 * MT_NO_MEMORY. */
mt_status mt_folder_begin(const char *path, mt_folder *folder);
mt_status mt_folder_add_folder(mt_folder *folder, const char *name);
mt_status mt_folder_add_file(mt_folder *folder, const char *name, const void *bytes, size_t length);

/* Moves the folder to its place, in place of the one with that mark that stands there. MT_CANNOT_WRITE (errno says
 * why), MT_NO_MEMORY: what stood there still does. */
mt_status mt_folder_place(mt_folder *folder, const char *mark);

/* Removes the folder with all that is in it, unless it has its place. */
void mt_folder_free(mt_folder *folder);
