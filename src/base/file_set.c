/* What is new changes places with what stands there, one after the other; where that goes wrong, all change back. What stood there is
 * where the new one was, then, and goes with the set. */
#include "base/file_set.h"

#include <errno.h>
#include <stdio.h>

#include "base/file.h"
#include "base/memory.h"
#include "base/place.h"
#include "base/temporaries.h"

typedef struct mt_set_entry {
    char *path;     /* its place */
    char *fresh;    /* where it is until then */
    bool is_folder; /* of its own; files are in the set's */
    bool stood;     /* something was at the place */
} mt_set_entry;

enum { NAME_ROOM = 32 };

mt_status mt_file_set_begin(const char *path, mt_file_set *set) {
    mt_folder folder;
    char *place = mt_place_of(path);
    mt_status status = place ? mt_folder_begin(place, &folder) : MT_NO_MEMORY;
    mt_free(place);
    if (status == MT_OK) *set = (mt_file_set){.folder = folder};
    return status;
}

/* ---- entries --------------------------------------------------------------------------------------------- */

/* A new entry, not counted yet; NULL when out of memory. */
static mt_set_entry *new_entry(mt_file_set *set) {
    mt_set_entry *grown = mt_grow_list(set->entries, set->count, &set->room, sizeof *grown);
    if (!grown) return NULL;
    set->entries = grown;
    grown[set->count] = (mt_set_entry){0};
    return &grown[set->count];
}

static void free_entry(const mt_set_entry *entry) {
    if (entry->is_folder) {
        mt_folder_free(&(mt_folder){.path = entry->path, .temporary = entry->fresh});
        return;
    }
    mt_free(entry->path);
    mt_free(entry->fresh);
}

static mt_status write_entry(mt_set_entry *entry, const void *bytes, size_t length) {
    int file = mt_file_create(entry->fresh, 0666);
    if (file < 0) return MT_CANNOT_WRITE;
    mt_place_keep_mode(entry->path, file);
    return mt_file_fill(file, bytes, length, true) ? MT_OK : MT_CANNOT_WRITE;
}

mt_status mt_file_set_add(mt_file_set *set, const char *path, const void *bytes, size_t length) {
    if (mt_file_check(path) != MT_OK) return MT_CANNOT_WRITE;
    mt_set_entry *entry = new_entry(set);
    if (!entry) return MT_NO_MEMORY;
    char name[NAME_ROOM];
    snprintf(name, sizeof name, "new-%d", set->count);
    entry->path = mt_place_of(path);
    entry->fresh = mt_folder_path_in(set->folder.temporary, name);
    mt_status status = entry->path && entry->fresh ? write_entry(entry, bytes, length) : MT_NO_MEMORY;
    if (status != MT_OK) {
        int why = errno;
        free_entry(entry);
        errno = why;
        return status;
    }
    set->folder.length += length;
    set->count++;
    return MT_OK;
}

mt_status mt_file_set_add_folder(mt_file_set *set, mt_folder *folder, const char *mark) {
    mt_status status = mt_folder_check(folder->path, mark);
    if (status == MT_OK && !mt_place_flush_folder(folder->temporary)) status = MT_CANNOT_WRITE;
    mt_set_entry *entry = status == MT_OK ? new_entry(set) : NULL;
    if (status != MT_OK) return status;
    if (!entry) return MT_NO_MEMORY;
    *entry = (mt_set_entry){.path = folder->path, .fresh = folder->temporary, .is_folder = true};
    *folder = (mt_folder){.length = folder->length};
    set->count++;
    return MT_OK;
}

/* ---- placing --------------------------------------------------------------------------------------------- */

static mt_status swap_all(const mt_file_set *set, int *failed) {
    for (int i = 0; i < set->count; i++) {
        mt_set_entry *entry = &set->entries[i];
        if (mt_place_swap(entry->fresh, entry->path, &entry->stood)) continue;
        *failed = i;
        while (i-- > 0)
            mt_place_swap_back(set->entries[i].fresh, set->entries[i].path, set->entries[i].stood);
        return MT_CANNOT_WRITE;
    }
    return MT_OK;
}

mt_status mt_file_set_place(mt_file_set *set, int *failed) {
    mt_temporaries_hold();
    mt_status status = swap_all(set, failed);
    mt_temporaries_let_go();
    return status;
}

void mt_file_set_free(mt_file_set *set) {
    int why = errno;
    for (int i = 0; i < set->count; i++) free_entry(&set->entries[i]);
    mt_free(set->entries);
    mt_folder_free(&set->folder);
    *set = (mt_file_set){0};
    errno = why;
}
