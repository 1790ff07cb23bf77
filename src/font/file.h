/* Files read whole, and files that appear whole or not at all. */
#ifndef MT_FILE_H
#define MT_FILE_H

#include "morphotype.h"

/* Reads the whole file at `path` into bytes for mt_free; at most `limit` of them. Reads regular files and
 * pipes only. MT_NO_FILE (errno says why; EISDIR for a directory), MT_TOO_LARGE, MT_NO_MEMORY. */
mt_status mt_file_read(const char *path, size_t limit, uint8_t **bytes, size_t *length);

/* Writes beside `path`, then renames over it. Only a regular file is ever replaced: a directory or a device
 * is left alone. MT_CANNOT_WRITE (errno says why), MT_NO_MEMORY; nothing is left behind on failure. */
mt_status mt_file_write(const char *path, const void *bytes, size_t length);

#endif
