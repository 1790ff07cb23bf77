#include "base/folder.h"

#include <errno.h>
#include <fcntl.h>
#include <ftw.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/file.h"
#include "base/memory.h"

/* DIRECTORY/NAME, from mt_new. */
static char *path_in(const char *directory, const char *name) {
    size_t room = strlen(directory) + strlen(name) + 2;
    char *path = mt_new(room, 1);
    if (path) snprintf(path, room, "%s/%s", directory, name);
    return path;
}

/* ---- removing --------------------------------------------------------------------------------------------- */

static int remove_entry(const char *path, const struct stat *about, int kind, struct FTW *place) {
    (void)about;
    (void)kind;
    (void)place;
    return remove(path);
}

/* A link to a directory goes, and what it leads to stays. Leaves errno as it was. */
void mt_folder_remove(const char *path) {
    enum { OPEN_AT_ONCE = 16 };
    int why = errno;
    nftw(path, remove_entry, OPEN_AT_ONCE, FTW_DEPTH | FTW_PHYS);
    errno = why;
}

/* ---- filling ---------------------------------------------------------------------------------------------- */

mt_status mt_folder_check(const char *path, const char *mark) {
    struct stat about;
    if (lstat(path, &about) != 0) return errno == ENOENT ? MT_OK : MT_CANNOT_WRITE;
    char *inside = path_in(path, mark);
    if (!inside) return MT_NO_MEMORY;
    bool marked = stat(inside, &about) == 0 && S_ISREG(about.st_mode);
    mt_free(inside);
    errno = EEXIST;
    return marked ? MT_OK : MT_CANNOT_WRITE;
}

mt_status mt_folder_begin(const char *path, mt_folder *folder) {
    mt_folder made = {.path = mt_copy_text(path), .temporary = mt_new(strlen(path) + MT_BESIDE_ROOM, 1)};
    mt_status status = made.path && made.temporary ? MT_OK : MT_NO_MEMORY;
    if (status == MT_OK && mt_file_beside(path, mkdir, 0777, made.temporary) < 0) status = MT_CANNOT_WRITE;
    if (status != MT_OK) {
        mt_free(made.path);
        mt_free(made.temporary);
        return status;
    }
    *folder = made;
    return MT_OK;
}

mt_status mt_folder_add_folder(mt_folder *folder, const char *name) {
    char *path = path_in(folder->temporary, name);
    if (!path) return MT_NO_MEMORY;
    bool made = mkdir(path, 0777) == 0; /* the umask takes its part */
    mt_free(path);
    return made ? MT_OK : MT_CANNOT_WRITE;
}

mt_status mt_folder_add_file(mt_folder *folder, const char *name, const void *bytes, size_t length) {
    char *path = path_in(folder->temporary, name);
    if (!path) return MT_NO_MEMORY;
    int file = open(path, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    mt_free(path);
    if (file < 0 || !mt_file_fill(file, bytes, length)) return MT_CANNOT_WRITE;
    folder->length += length;
    return MT_OK;
}

/* ---- placing ---------------------------------------------------------------------------------------------- */

/* One directory cannot be renamed over another: the old one steps aside, into a directory of its own, and back again if
 * the new one cannot be moved. */
static bool exchange(const mt_folder *folder, const char *aside, const char *old) {
    if (rename(folder->path, old) != 0) {
        mt_folder_remove(aside);
        return false;
    }
    bool placed = rename(folder->temporary, folder->path) == 0;
    int why = errno;
    bool needless = placed || rename(old, folder->path) == 0;
    errno = why;
    if (needless) mt_folder_remove(aside);
    return placed;
}

static mt_status replace(const mt_folder *folder) {
    char *aside = mt_new(strlen(folder->path) + MT_BESIDE_ROOM, 1), *old = NULL;
    if (!aside) return MT_NO_MEMORY;
    mt_status status = mt_file_beside(folder->path, mkdir, 0777, aside) < 0 ? MT_CANNOT_WRITE : MT_OK;
    if (status == MT_OK && !(old = path_in(aside, "old"))) {
        mt_folder_remove(aside);
        status = MT_NO_MEMORY;
    }
    if (status == MT_OK && !exchange(folder, aside, old)) status = MT_CANNOT_WRITE;
    mt_free(old);
    mt_free(aside);
    return status;
}

mt_status mt_folder_place(mt_folder *folder, const char *mark) {
    struct stat about;
    mt_status status = mt_folder_check(folder->path, mark);
    if (status != MT_OK) return status;
    if (lstat(folder->path, &about) == 0)
        status = replace(folder);
    else if (rename(folder->temporary, folder->path) != 0)
        status = MT_CANNOT_WRITE;
    if (status != MT_OK) return status;
    mt_free(folder->temporary);
    folder->temporary = NULL;
    return MT_OK;
}

void mt_folder_free(mt_folder *folder) {
    if (folder->temporary) mt_folder_remove(folder->temporary);
    mt_free(folder->temporary);
    mt_free(folder->path);
    *folder = (mt_folder){0};
}
