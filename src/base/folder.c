#include "base/folder.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/file.h"
#include "base/memory.h"
#include "base/place.h"
#include "base/temporaries.h"
#include "base/tree.h"

char *mt_folder_path_in(const char *directory, const char *name) {
    size_t room = strlen(directory) + strlen(name) + 2;
    char *path = mt_new(room, 1);
    if (path) snprintf(path, room, "%s/%s", directory, name);
    return path;
}

/* ---- filling ---------------------------------------------------------------------------------------------- */

mt_status mt_folder_check(const char *path, const char *mark) {
    struct stat about;
    if (lstat(path, &about) != 0) return errno == ENOENT ? MT_OK : MT_CANNOT_WRITE;
    char *inside = mt_folder_path_in(path, mark);
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
    char *path = mt_folder_path_in(folder->temporary, name);
    if (!path) return MT_NO_MEMORY;
    bool made = mkdir(path, 0777) == 0; /* the umask takes its part */
    mt_free(path);
    return made ? MT_OK : MT_CANNOT_WRITE;
}

mt_status mt_folder_add_file(mt_folder *folder, const char *name, const void *bytes, size_t length) {
    char *path = mt_folder_path_in(folder->temporary, name);
    if (!path) return MT_NO_MEMORY;
    int file = mt_file_create(path, 0666);
    mt_free(path);
    if (file < 0 || !mt_file_fill(file, bytes, length, false)) return MT_CANNOT_WRITE;
    folder->length += length;
    return MT_OK;
}

/* ---- placing ---------------------------------------------------------------------------------------------- */

/* The folder has its place. */
static void forget(mt_folder *folder) {
    mt_temporary_end(folder->temporary);
    mt_free(folder->temporary);
    folder->temporary = NULL;
}

mt_status mt_folder_place(mt_folder *folder, const char *mark) {
    bool stood;
    mt_status status = mt_folder_check(folder->path, mark);
    if (status != MT_OK) return status;
    if (!mt_place_flush_folder(folder->temporary)) return MT_CANNOT_WRITE;
    if (!mt_place_swap(folder->temporary, folder->path, &stood)) return MT_CANNOT_WRITE;
    if (stood) mt_tree_remove(folder->temporary);
    forget(folder);
    return MT_OK;
}

void mt_folder_free(mt_folder *folder) {
    if (folder->temporary) mt_tree_remove(folder->temporary);
    if (folder->temporary) forget(folder);
    mt_free(folder->path);
    *folder = (mt_folder){0};
}
