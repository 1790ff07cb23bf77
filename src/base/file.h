/* Files read whole, and files that appear whole or not at all. */
#pragma once

#include <sys/types.h>

#include "morphotype.h"

/* Reads the whole file at `path` into bytes for mt_free; at most `limit` of them. Reads regular files and
 * pipes only. MT_NO_FILE (errno says why; EISDIR for a directory), MT_TOO_LARGE, MT_NO_MEMORY. */
mt_status mt_file_read(const char *path, size_t limit, uint8_t **bytes, size_t *length);

/* Whether a file may be written at `path`: nothing stands there, or a regular file. MT_CANNOT_WRITE (errno says why). */
mt_status mt_file_check(const char *path);

/* Writes beside `path`, then renames over it, once it is on the disk. Only a regular file is ever replaced, whose rights the new one has;
 * where links lead to it they stay. MT_CANNOT_WRITE (errno says why), MT_NO_MEMORY; nothing is left behind on failure. */
mt_status mt_file_write(const char *path, const void *bytes, size_t length);

/* Makes something in the directory of `path`, by open or mkdir, say, under a short name that no other has, and gives
 * what `make` gave: below 0, with errno, where it could not. `name` has room for the path and MT_BESIDE_ROOM bytes. Until
 * mt_temporary_end (temporaries.h) it is a temporary of the process. */
enum { MT_BESIDE_ROOM = 64 };
int mt_file_beside(const char *path, int (*make)(const char *name, mode_t mode), mode_t mode, char *name);

/* Opens a new file for writing, where none is; below 0, with errno, otherwise. */
int mt_file_create(const char *name, mode_t mode);

/* Writes all bytes to an open file, has them on the disk if `flush`, and closes it; false, with errno, where that went wrong. */
bool mt_file_fill(int file, const void *bytes, size_t length, bool flush);
