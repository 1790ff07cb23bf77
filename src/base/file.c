#include "base/file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/memory.h"
#include "base/place.h"
#include "base/temporaries.h"

/* ---- reading ------------------------------------------------------------------------------------------- */

/* Opens for reading what can be read to an end; -1 and errno otherwise. `expected` is its size, or 0 for a
 * pipe. */
static int open_whole(const char *path, size_t *expected) {
    int file = open(path, O_RDONLY | O_CLOEXEC | O_NOCTTY);
    if (file < 0) return -1;
    struct stat about;
    int why = 0;
    if (fstat(file, &about) != 0)
        why = errno;
    else if (S_ISDIR(about.st_mode))
        why = EISDIR;
    else if (!S_ISREG(about.st_mode) && !S_ISFIFO(about.st_mode))
        why = ENXIO;
    if (why) {
        close(file);
        errno = why;
        return -1;
    }
    *expected = S_ISREG(about.st_mode) && about.st_size > 0 ? (size_t)about.st_size : 0;
    return file;
}

/* Reads up to `size` bytes, fewer only at the end of the file; -1 and errno on an error. */
static ssize_t read_up_to(int file, uint8_t *bytes, size_t size) {
    size_t done = 0;
    while (done < size) {
        ssize_t got = read(file, bytes + done, size - done);
        if (got == 0) break;
        if (got > 0)
            done += (size_t)got;
        else if (errno != EINTR)
            return -1;
    }
    return (ssize_t)done;
}

/* Reads on until the end; one byte of room more than expected shows the end without growing. */
static mt_status read_all(int file, size_t expected, size_t limit, uint8_t **bytes, size_t *length) {
    size_t room = expected ? expected + 1 : 1 << 16, done = 0;
    uint8_t *all = NULL;
    for (;;) {
        uint8_t *grown = mt_grow(all, room, 1);
        ssize_t got = grown ? read_up_to(file, grown + done, room - done) : 0;
        if (grown) all = grown;
        if (grown && got >= 0) done += (size_t)got;
        mt_status status = !grown ? MT_NO_MEMORY : got < 0 ? MT_NO_FILE : done > limit ? MT_TOO_LARGE : MT_OK;
        if (status != MT_OK) {
            mt_free(all);
            return status;
        }
        if (done < room) break;
        room *= 2;
    }
    *bytes = all;
    *length = done;
    return MT_OK;
}

mt_status mt_file_read(const char *path, size_t limit, uint8_t **bytes, size_t *length) {
    size_t expected;
    int file = open_whole(path, &expected);
    if (file < 0) return MT_NO_FILE;
    mt_status status = expected > limit ? MT_TOO_LARGE : read_all(file, expected, limit, bytes, length);
    int why = errno;
    close(file);
    errno = why;
    return status;
}

/* ---- writing ------------------------------------------------------------------------------------------- */

/* Something that is no regular file must not be renamed over. */
mt_status mt_file_check(const char *path) {
    struct stat about;
    if (stat(path, &about) != 0 || S_ISREG(about.st_mode)) return MT_OK;
    errno = S_ISDIR(about.st_mode) ? EISDIR : EEXIST;
    return MT_CANNOT_WRITE;
}

int mt_file_beside(const char *path, int (*make)(const char *name, mode_t mode), mode_t mode, char *name) {
    const char *slash = strrchr(path, '/');
    size_t directory = slash ? (size_t)(slash + 1 - path) : 0;
    memcpy(name, path, directory);
    for (unsigned attempt = 0; attempt < 10000; attempt++) {
        snprintf(name + directory, MT_BESIDE_ROOM, ".morphotype-%ld-%u", (long)getpid(), attempt);
        int made = make(name, mode); /* the umask takes its part */
        if (made >= 0) mt_temporary_begin(name);
        if (made >= 0 || errno != EEXIST) return made;
    }
    return -1;
}

int mt_file_create(const char *name, mode_t mode) {
    return open(name, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
}

static bool write_all(int file, const char *bytes, size_t length) {
    while (length) {
        ssize_t wrote = write(file, bytes, length);
        if (wrote < 0 && errno == EINTR) continue;
        if (wrote < 0) return false;
        bytes += wrote;
        length -= (size_t)wrote;
    }
    return true;
}

bool mt_file_fill(int file, const void *bytes, size_t length, bool flush) {
    bool done = write_all(file, bytes, length) && (!flush || mt_place_flush_file(file));
    int why = errno;
    if (close(file) != 0) return false;
    errno = why;
    return done;
}

/* Writes to a name beside the place, and renames. */
static bool write_beside(const char *place, const void *bytes, size_t length, char *name) {
    int file = mt_file_beside(place, mt_file_create, 0666, name);
    if (file < 0) return false;
    mt_place_keep_mode(place, file);
    bool done = mt_file_fill(file, bytes, length, true) && rename(name, place) == 0;
    int why = errno;
    if (!done) unlink(name);
    mt_temporary_end(name);
    errno = why;
    return done;
}

mt_status mt_file_write(const char *path, const void *bytes, size_t length) {
    if (mt_file_check(path) != MT_OK) return MT_CANNOT_WRITE;
    char *place = mt_place_of(path), *name = place ? mt_new(strlen(place) + MT_BESIDE_ROOM, 1) : NULL;
    bool done = name && write_beside(place, bytes, length, name);
    mt_status status = !name ? MT_NO_MEMORY : done ? MT_OK : MT_CANNOT_WRITE;
    mt_free(name);
    mt_free(place);
    return status;
}
