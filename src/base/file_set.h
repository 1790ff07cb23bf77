/* Several files that appear all together or not at all. */
#pragma once

#include "base/folder.h"

/* Files in the making, in a hidden folder beside the first of their places. */
typedef struct mt_file_set {
    mt_folder folder;
    int count, room;
    char **paths; /* the place of each */
} mt_file_set;

/* Begins a set; `path` is in the directory of its files. MT_CANNOT_WRITE (errno says why), MT_NO_MEMORY. */
mt_status mt_file_set_begin(const char *path, mt_file_set *set);
/* Adds a file; nothing stands at its place, or a regular file. MT_CANNOT_WRITE (errno says why), MT_NO_MEMORY. */
mt_status mt_file_set_add(mt_file_set *set, const char *path, const void *bytes, size_t length);
/* Moves all files to their places, instead of those that stand there. MT_CANNOT_WRITE (errno says why): what stood there still does. */
mt_status mt_file_set_place(mt_file_set *set);
/* Removes what has no place. */
void mt_file_set_free(mt_file_set *set);
