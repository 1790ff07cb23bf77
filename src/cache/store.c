/* Files of the cache. A look at a folder costs O(n log n) for its n entries, and comes with the first entry that is written there and then
 * with each eighth of what the folder may have; who only reads looks at none. */
#include "cache/store.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/file.h"
#include "base/temporaries.h"

enum {
    FOLDERS = 256,
    NAME = 2 * (MT_DIGEST_BYTES - 1), /* characters of an entry's name */
    BLOCK = 4096,                     /* bytes that a file takes come in these */
    LOOKS = 8,                        /* at a folder, before as much is written as it may have */
    ENTRY_MOST = 1 << 28,             /* bytes */
};

/* At the beginning of an entry; the last character is the version of its format (cache/prepared.c). */
static const char magic[8] = {'m', 'o', 'r', 'p', 'h', 'p', 'r', '1'};

enum { HEAD = sizeof magic + 2 * MT_DIGEST_BYTES };

struct mt_store {
    char *directory;
    uint64_t share;            /* bytes of one folder */
    uint64_t written[FOLDERS]; /* since the last look, under the lock; UINT64_MAX before the first */
    pthread_mutex_t lock;
};

/* ---- opening ------------------------------------------------------------------------------------------------- */

static bool make_directory(const char *path) {
    struct stat about;
    if (mkdir(path, 0777) == 0) return true;
    if (errno != EEXIST) return false;
    bool there = stat(path, &about) == 0 && S_ISDIR(about.st_mode);
    if (!there) errno = ENOTDIR;
    return there;
}

mt_status mt_store_open(const char *directory, uint64_t most, mt_store **store) {
    if (!make_directory(directory)) return MT_CANNOT_WRITE;
    mt_store *made = mt_new(1, sizeof *made);
    char *path = mt_copy_text(directory);
    if (!made || !path) {
        mt_free(made);
        mt_free(path);
        return MT_NO_MEMORY;
    }
    made->directory = path;
    made->share = most / FOLDERS;
    for (int i = 0; i < FOLDERS; i++) made->written[i] = UINT64_MAX;
    pthread_mutex_init(&made->lock, NULL);
    *store = made;
    return MT_OK;
}

void mt_store_close(mt_store *store) {
    if (!store) return;
    pthread_mutex_destroy(&store->lock);
    mt_free(store->directory);
    mt_free(store);
}

/* The path of an entry, from mt_new; without its name, the folder's with a slash at the end. NULL when out of memory. */
static char *path_of(const mt_store *store, const mt_digest *key, bool named) {
    size_t room = strlen(store->directory) + sizeof "/ab/" + NAME;
    char *path = mt_new(room, 1);
    if (!path) return NULL;
    int used = snprintf(path, room, "%s/%02x/", store->directory, key->bytes[0]);
    for (int i = 1; named && i < MT_DIGEST_BYTES; i++)
        used += snprintf(path + used, room - (size_t)used, "%02x", key->bytes[i]);
    return path;
}

/* ---- reading ------------------------------------------------------------------------------------------------- */

static mt_digest digest_of(const uint8_t *bytes, size_t length) {
    mt_hashing hashing = mt_hashing_begin();
    mt_hashing_add(&hashing, bytes, length);
    return mt_hashing_end(&hashing);
}

static bool is_sound(const uint8_t *entry, size_t length, const mt_digest *key) {
    if (length < HEAD || memcmp(entry, magic, sizeof magic) != 0) return false;
    const uint8_t *known = entry + sizeof magic, *digest = known + MT_DIGEST_BYTES;
    mt_digest found = digest_of(entry + HEAD, length - HEAD);
    return memcmp(known, key->bytes, MT_DIGEST_BYTES) == 0 &&
           memcmp(digest, found.bytes, MT_DIGEST_BYTES) == 0;
}

/* The whole of a regular file; NULL where that cannot be had. */
static uint8_t *read_file(int file, mt_arena *arena, size_t *length) {
    struct stat about;
    if (fstat(file, &about) != 0 || !S_ISREG(about.st_mode) || about.st_size > ENTRY_MOST) return NULL;
    uint8_t *bytes = mt_arena_new(arena, (size_t)about.st_size, 1);
    size_t done = 0;
    while (bytes && done < (size_t)about.st_size) {
        ssize_t got = read(file, bytes + done, (size_t)about.st_size - done);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return NULL;
        done += (size_t)got;
    }
    *length = done;
    return bytes;
}

bool mt_store_read(mt_store *store, const mt_digest *key, mt_arena *arena, const uint8_t **bytes,
                   size_t *length) {
    char *path = path_of(store, key, true);
    int file = path ? open(path, O_RDONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK) : -1;
    mt_free(path);
    if (file < 0) return false;
    size_t all = 0;
    const uint8_t *entry = read_file(file, arena, &all);
    bool sound = entry && is_sound(entry, all, key);
    if (sound) futimens(file, NULL); /* it is the last that was used */
    close(file);
    if (!sound) return false;
    *bytes = entry + HEAD;
    *length = all - HEAD;
    return true;
}

/* ---- bounding ------------------------------------------------------------------------------------------------ */

typedef struct entry_file {
    char name[NAME + 1];
    struct timespec used;
    uint64_t size;
} entry_file;

typedef struct entry_files {
    entry_file *list;
    int count, room;
    uint64_t size; /* of all */
} entry_files;

static uint64_t size_on_disk(uint64_t length) {
    return (length + BLOCK - 1) / BLOCK * BLOCK;
}

/* Those that were used longest ago first. */
static int compare_use(const void *p, const void *q) {
    const entry_file *x = p, *y = q;
    if (x->used.tv_sec != y->used.tv_sec) return x->used.tv_sec < y->used.tv_sec ? -1 : 1;
    if (x->used.tv_nsec != y->used.tv_nsec) return x->used.tv_nsec < y->used.tv_nsec ? -1 : 1;
    return strcmp(x->name, y->name);
}

static bool list_entries(DIR *folder, entry_files *files) {
    for (const struct dirent *found; (found = readdir(folder));) {
        struct stat about;
        if (strspn(found->d_name, "0123456789abcdef") != NAME || found->d_name[NAME]) continue;
        if (fstatat(dirfd(folder), found->d_name, &about, AT_SYMLINK_NOFOLLOW) != 0) continue;
        entry_file *list = mt_grow_list(files->list, files->count, &files->room, sizeof *list);
        if (!list) return false;
        files->list = list;
        entry_file *entry = &list[files->count++];
        memcpy(entry->name, found->d_name, NAME + 1);
        entry->used = about.st_mtim;
        entry->size = size_on_disk((uint64_t)about.st_size);
        files->size += entry->size;
    }
    return true;
}

/* Down to three quarters, so that it is not to be done again at once. */
static void remove_oldest(DIR *folder, entry_files *files, uint64_t share) {
    if (files->size <= share) return;
    qsort(files->list, (size_t)files->count, sizeof *files->list, compare_use);
    for (int i = 0; i < files->count && files->size > share / 4 * 3; i++) {
        unlinkat(dirfd(folder), files->list[i].name, 0);
        files->size -= files->list[i].size;
    }
}

/* Bounds a folder, and removes what killed processes have left there. */
static void bound_folder(const mt_store *store, const char *path) {
    entry_files files = {0};
    mt_temporaries_clear(path);
    DIR *folder = opendir(path);
    if (!folder) return;
    if (list_entries(folder, &files)) remove_oldest(folder, &files, store->share);
    closedir(folder);
    mt_free(files.list);
}

/* Whether the folder is to be looked at now that so much more is in it. */
static bool is_due(mt_store *store, uint8_t folder, uint64_t more) {
    uint64_t *written = &store->written[folder];
    pthread_mutex_lock(&store->lock);
    bool due = *written == UINT64_MAX || *written + more > store->share / LOOKS;
    *written = due ? 0 : *written + more;
    pthread_mutex_unlock(&store->lock);
    return due;
}

/* ---- writing ------------------------------------------------------------------------------------------------- */

/* Not flushed to the disk: what a crash tears is seen by its digest. */
static bool write_beside(const char *path, const uint8_t *entry, size_t length, char *name) {
    int file = mt_file_beside(path, mt_file_create, 0666, name);
    if (file < 0) return false;
    bool done = mt_file_fill(file, entry, length, false) && rename(name, path) == 0;
    if (!done) unlink(name);
    mt_temporary_end(name);
    return done;
}

static uint8_t *new_entry(const mt_digest *key, const uint8_t *bytes, size_t length) {
    uint8_t *entry = mt_new(HEAD + length, 1);
    if (!entry) return NULL;
    mt_digest digest = digest_of(bytes, length);
    memcpy(entry, magic, sizeof magic);
    memcpy(entry + sizeof magic, key->bytes, MT_DIGEST_BYTES);
    memcpy(entry + sizeof magic + MT_DIGEST_BYTES, digest.bytes, MT_DIGEST_BYTES);
    memcpy(entry + HEAD, bytes, length);
    return entry;
}

bool mt_store_write(mt_store *store, const mt_digest *key, const uint8_t *bytes, size_t length) {
    char *path = path_of(store, key, true), *folder = path_of(store, key, false);
    char *name = path ? mt_new(strlen(path) + MT_BESIDE_ROOM, 1) : NULL;
    uint8_t *entry = new_entry(key, bytes, length);
    bool ready = name && folder && entry && (mkdir(folder, 0777) == 0 || errno == EEXIST);
    bool done = ready && write_beside(path, entry, HEAD + length, name);
    if (done && is_due(store, key->bytes[0], size_on_disk(HEAD + length))) bound_folder(store, folder);
    mt_free(entry);
    mt_free(name);
    mt_free(folder);
    mt_free(path);
    return done;
}
