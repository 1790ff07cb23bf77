/* A file that stands at a place steps aside, into the folder, before the new one is moved there; where that goes wrong, all go back. */
#include "base/file_set.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/file.h"
#include "base/memory.h"

enum { NAME_ROOM = 32 };

/* "new-7" or "old-7". */
static void name_of(int number, bool is_new, char name[NAME_ROOM]) {
    snprintf(name, NAME_ROOM, "%s-%d", is_new ? "new" : "old", number);
}

mt_status mt_file_set_begin(const char *path, mt_file_set *set) {
    mt_folder folder;
    mt_status status = mt_folder_begin(path, &folder);
    if (status == MT_OK) *set = (mt_file_set){.folder = folder};
    return status;
}

mt_status mt_file_set_add(mt_file_set *set, const char *path, const void *bytes, size_t length) {
    char name[NAME_ROOM];
    if (mt_file_check(path) != MT_OK) return MT_CANNOT_WRITE;
    char **grown = mt_grow_list(set->paths, set->count, &set->room, sizeof *grown);
    if (!grown) return MT_NO_MEMORY;
    set->paths = grown;
    char *copy = mt_copy_text(path);
    if (!copy) return MT_NO_MEMORY;
    name_of(set->count, true, name);
    mt_status status = mt_folder_add_file(&set->folder, name, bytes, length);
    if (status == MT_OK)
        grown[set->count++] = copy;
    else
        mt_free(copy);
    return status;
}

/* ---- placing --------------------------------------------------------------------------------------------- */

/* Where files are in the folder; both have room for the longest name. */
typedef struct mt_placing_paths {
    char *fresh, *old;
} mt_placing_paths;

static void set_paths(const mt_file_set *set, int number, const mt_placing_paths *paths) {
    char name[NAME_ROOM];
    name_of(number, true, name);
    sprintf(paths->fresh, "%s/%s", set->folder.temporary, name);
    name_of(number, false, name);
    sprintf(paths->old, "%s/%s", set->folder.temporary, name);
}

/* Back as it was: the new file in the folder, the old one at its place. */
static void take_back(const mt_file_set *set, int number, const mt_placing_paths *paths) {
    set_paths(set, number, paths);
    rename(set->paths[number], paths->fresh);
    rename(paths->old, set->paths[number]);
}

static bool place(const mt_file_set *set, int number, const mt_placing_paths *paths) {
    struct stat about;
    set_paths(set, number, paths);
    bool stands = lstat(set->paths[number], &about) == 0;
    if (stands && rename(set->paths[number], paths->old) != 0) return false;
    if (rename(paths->fresh, set->paths[number]) == 0) return true;
    int why = errno;
    if (stands) rename(paths->old, set->paths[number]);
    errno = why;
    return false;
}

mt_status mt_file_set_place(mt_file_set *set) {
    size_t room = strlen(set->folder.temporary) + NAME_ROOM + 1;
    const mt_placing_paths paths = {mt_new(room, 1), mt_new(room, 1)};
    mt_status status = paths.fresh && paths.old ? MT_OK : MT_NO_MEMORY;
    for (int i = 0; status == MT_OK && i < set->count; i++) {
        if (place(set, i, &paths)) continue;
        int why = errno;
        while (i > 0) take_back(set, --i, &paths);
        errno = why;
        status = MT_CANNOT_WRITE;
    }
    mt_free(paths.fresh);
    mt_free(paths.old);
    return status;
}

void mt_file_set_free(mt_file_set *set) {
    for (int i = 0; i < set->count; i++) mt_free(set->paths[i]);
    mt_free(set->paths);
    mt_folder_free(&set->folder);
    *set = (mt_file_set){0};
}
