/* A library to be loaded before the C library (LD_PRELOAD): one call of the program fails, as on a disk that is full or without memory.
 *
 *     FAILING_KIND   "files": write, open for writing, mkdir, fsync, syncfs, rename, renameat2; "new": C++'s operator new
 *     FAILING_CALL   which of them fails, from 1; 0: none
 *     FAILING_COUNT  a file that is given the number of such calls, at the end */
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace {

long calls;
bool telling; /* the count is being written */

bool is_kind(const char *kind) {
    const char *wanted = getenv("FAILING_KIND");
    return wanted && !strcmp(wanted, kind);
}

/* Whether this call of that kind is to fail. */
bool fails(const char *kind) {
    static const bool files = is_kind("files"), news = is_kind("new");
    static const char *const which = getenv("FAILING_CALL");
    static const long call = which ? atol(which) : 0;
    if (telling || !(kind[0] == 'f' ? files : news)) return false;
    return __atomic_add_fetch(&calls, 1, __ATOMIC_SEQ_CST) == call;
}

bool no_room() {
    if (!fails("files")) return false;
    errno = ENOSPC;
    return true;
}

template <typename function> function next(const char *name) {
    return reinterpret_cast<function>(dlsym(RTLD_NEXT, name));
}

__attribute__((destructor)) void tell_count() {
    telling = true;
    FILE *file = getenv("FAILING_COUNT") ? fopen(getenv("FAILING_COUNT"), "w") : nullptr;
    if (file) {
        fprintf(file, "%ld", calls);
        fclose(file);
    }
}

} // namespace

extern "C" {

ssize_t write(int file, const void *bytes, size_t count) {
    if (file > 2 && no_room()) return -1;
    return next<ssize_t (*)(int, const void *, size_t)>("write")(file, bytes, count);
}

int open(const char *path, int flags, ...) {
    va_list rest;
    va_start(rest, flags);
    mode_t mode = flags & O_CREAT ? va_arg(rest, mode_t) : 0;
    va_end(rest);
    if (flags & O_CREAT && no_room()) return -1;
    return next<int (*)(const char *, int, ...)>("open")(path, flags, mode);
}

int mkdir(const char *path, mode_t mode) {
    return no_room() ? -1 : next<int (*)(const char *, mode_t)>("mkdir")(path, mode);
}

int fsync(int file) {
    return no_room() ? -1 : next<int (*)(int)>("fsync")(file);
}

int syncfs(int file) noexcept {
    return no_room() ? -1 : next<int (*)(int)>("syncfs")(file);
}

int rename(const char *from, const char *to) noexcept {
    return no_room() ? -1 : next<int (*)(const char *, const char *)>("rename")(from, to);
}

int renameat2(int from_in, const char *from, int to_in, const char *to, unsigned flags) noexcept {
    if (no_room()) return -1;
    return next<int (*)(int, const char *, int, const char *, unsigned)>("renameat2")(from_in, from, to_in,
                                                                                      to, flags);
}

} // extern "C"

void *operator new(std::size_t size) {
    void *memory = fails("new") ? nullptr : malloc(size ? size : 1);
    if (!memory) throw std::bad_alloc();
    return memory;
}
