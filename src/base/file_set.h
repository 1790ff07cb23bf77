/* Several files and folders that appear all together or not at all. */
#pragma once

#include "base/folder.h"

typedef struct mt_file_set {
    mt_folder folder; /* hidden, beside the first of their places: files are in it until then */
    int count, room;
    struct mt_set_entry *entries;
} mt_file_set;

/* Begins a set; `path` is the first file's. MT_CANNOT_WRITE (errno says why), MT_NO_MEMORY. */
mt_status mt_file_set_begin(const char *path, mt_file_set *set);
/* Adds a file; nothing stands at its place, or a regular file, whose rights it has. On the disk from then on. MT_CANNOT_WRITE (errno says
 * why), MT_NO_MEMORY. */
mt_status mt_file_set_add(mt_file_set *set, const char *path, const void *bytes, size_t length);
/* Adds a folder in the making, which the set owns from then on; nothing stands at its place, or one with that mark. The same. */
mt_status mt_file_set_add_folder(mt_file_set *set, mt_folder *folder, const char *mark);
/* Moves all to their places, instead of what stands there. MT_CANNOT_WRITE (errno says why): what stood there still does, and *failed
 * is the number of the one that could not be moved. */
mt_status mt_file_set_place(mt_file_set *set, int *failed);
/* Removes what has no place. */
void mt_file_set_free(mt_file_set *set);
