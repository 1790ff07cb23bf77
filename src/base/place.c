/* Two names are exchanged by renameat2 (Linux 3.15), so that a run that is killed leaves the old or the new at a place; where a file system
 * cannot, by three renames. */
#define _GNU_SOURCE /* renameat2, syncfs */
#include "base/place.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/memory.h"

/* ---- links --------------------------------------------------------------------------------------------- */

/* Where the link at `path` leads to, from there; NULL for what is no link, or when out of memory. */
static char *read_link(const char *path) {
    char to[PATH_MAX];
    ssize_t length = readlink(path, to, sizeof to - 1);
    if (length <= 0 || length == sizeof to - 1) return NULL;
    to[length] = '\0';
    const char *slash = strrchr(path, '/');
    size_t directory = *to != '/' && slash ? (size_t)(slash + 1 - path) : 0;
    char *joined = mt_new(directory + (size_t)length + 1, 1);
    if (joined) snprintf(joined, directory + (size_t)length + 1, "%.*s%s", (int)directory, path, to);
    return joined;
}

char *mt_place_of(const char *path) {
    enum { LINKS_MOST = 40 }; /* as the system's own limit */
    char *place = mt_copy_text(path);
    for (int i = 0; place && i < LINKS_MOST; i++) {
        char *next = read_link(place);
        if (!next) break;
        mt_free(place);
        place = next;
    }
    return place;
}

/* ---- rights, and the disk -------------------------------------------------------------------------------- */

void mt_place_keep_mode(const char *path, int file) {
    struct stat about;
    if (stat(path, &about) == 0 && S_ISREG(about.st_mode)) (void)!fchmod(file, about.st_mode & 0777);
}

/* Pipes and some file systems cannot be flushed, and need not be. */
static bool is_flushed(int result) {
    return result == 0 || errno == EINVAL || errno == EROFS || errno == ENOSYS || errno == EOPNOTSUPP;
}

bool mt_place_flush_file(int file) {
    return is_flushed(fsync(file));
}

bool mt_place_flush_folder(const char *path) {
    int folder = open(path, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (folder < 0) return false;
    bool flushed = is_flushed(syncfs(folder));
    int why = errno;
    close(folder);
    errno = why;
    return flushed;
}

/* ---- names ----------------------------------------------------------------------------------------------- */

/* The same in three steps, of which the first two are taken back where the next fails. */
static bool exchange_in_steps(const char *fresh, const char *path) {
    size_t room = strlen(fresh) + sizeof "-old";
    char *aside = mt_new(room, 1);
    if (!aside) return false;
    snprintf(aside, room, "%s-old", fresh);
    bool stepped = rename(path, aside) == 0, done = stepped && rename(fresh, path) == 0;
    int why = errno;
    if (stepped && !done) rename(aside, path);
    if (done && rename(aside, fresh) != 0) {
        why = errno;
        rename(path, fresh);
        rename(aside, path);
        done = false;
    }
    mt_free(aside);
    errno = why;
    return done;
}

/* Fails with errno, ENOSYS where there is no such call: in a browser. */
static bool exchange_at_once(const char *fresh, const char *path) {
#ifdef RENAME_EXCHANGE
    return renameat2(AT_FDCWD, fresh, AT_FDCWD, path, RENAME_EXCHANGE) == 0;
#else
    (void)fresh, (void)path;
    errno = ENOSYS;
    return false;
#endif
}

static bool exchange(const char *fresh, const char *path) {
    if (exchange_at_once(fresh, path)) return true;
    bool cannot = errno == EINVAL || errno == ENOSYS || errno == EOPNOTSUPP;
    return cannot && exchange_in_steps(fresh, path);
}

bool mt_place_swap(const char *fresh, const char *path, bool *stood) {
    struct stat about;
    *stood = lstat(path, &about) == 0;
    return *stood ? exchange(fresh, path) : rename(fresh, path) == 0;
}

void mt_place_swap_back(const char *fresh, const char *path, bool stood) {
    int why = errno;
    if (stood)
        exchange(fresh, path);
    else
        rename(path, fresh);
    errno = why;
}
