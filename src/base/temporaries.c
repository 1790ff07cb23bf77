/* Names are those that mt_file_beside gives (file.h): .morphotype-PID-NUMBER. */
#include "base/temporaries.h"

#include <dirent.h>
#include <errno.h>
#include <limits.h>
#include <pthread.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/tree.h"

#define PREFIX ".morphotype-"

enum { TEMPORARIES_MOST = 64, PATH_ROOM = 1024 };

/* State of the process, as its files are; "" is free. */
static char paths[TEMPORARIES_MOST][PATH_ROOM];
static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;

static void replace(const char *path, const char *by) {
    if (strlen(path) >= PATH_ROOM || strlen(by) >= PATH_ROOM) return;
    pthread_mutex_lock(&lock);
    for (int i = 0; i < TEMPORARIES_MOST; i++) {
        if (strcmp(paths[i], path) != 0) continue;
        strcpy(paths[i], by);
        break;
    }
    pthread_mutex_unlock(&lock);
}

void mt_temporary_begin(const char *path) {
    replace("", path);
}

void mt_temporary_end(const char *path) {
    replace(path, "");
}

void mt_temporaries_hold(void) {
    pthread_mutex_lock(&lock);
}

void mt_temporaries_let_go(void) {
    pthread_mutex_unlock(&lock);
}

/* Other threads may still add to a folder: until it is gone. */
static void remove_for_good(const char *path) {
    enum { TRIES = 100 };
    struct stat about;
    for (int i = 0; i < TRIES && lstat(path, &about) == 0; i++) mt_tree_remove(path);
}

void mt_temporaries_remove(void) {
    pthread_mutex_lock(&lock);
    for (int i = 0; i < TEMPORARIES_MOST; i++)
        if (*paths[i]) remove_for_good(paths[i]);
}

/* Whether a name is of a process that is there no more. */
static bool is_of_dead(const char *name) {
    if (strncmp(name, PREFIX, sizeof PREFIX - 1) != 0) return false;
    char *end;
    long process = strtol(name + sizeof PREFIX - 1, &end, 10);
    return *end == '-' && process > 0 && process <= INT_MAX && kill((pid_t)process, 0) != 0 && errno == ESRCH;
}

static void clear_directory(DIR *directory, const char *path, size_t length) {
    char found[PATH_MAX];
    for (const struct dirent *entry; (entry = readdir(directory));) {
        struct stat about;
        if (!is_of_dead(entry->d_name)) continue;
        if (snprintf(found, sizeof found, "%.*s%s", (int)length, path, entry->d_name) >= (int)sizeof found)
            continue;
        if (lstat(found, &about) == 0 && about.st_uid == geteuid()) mt_tree_remove(found);
    }
}

void mt_temporaries_clear(const char *path) {
    char name[PATH_MAX];
    const char *slash = strrchr(path, '/');
    size_t length = slash ? (size_t)(slash + 1 - path) : 0;
    if (length >= sizeof name) return;
    snprintf(name, sizeof name, "%.*s", (int)length, path);
    DIR *directory = opendir(length ? name : ".");
    if (!directory) return;
    clear_directory(directory, path, length);
    closedir(directory);
}
