/* The pipe is a socket, so that writing to a command that has ended is an error and no signal. */
#include "motion/movie.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <stdio.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/file.h"
#include "base/temporaries.h"

extern char **environ;

typedef struct mt_movie_pipe {
    int socket;
    pid_t command;
} mt_movie_pipe;

/* ---- the command --------------------------------------------------------------------------------------- */

/* No signal is blocked or ignored in the command, whatever is in this program. */
static int clear_signals(posix_spawnattr_t *attributes) {
    sigset_t none, all;
    sigemptyset(&none);
    sigfillset(&all);
    int error = posix_spawnattr_setsigmask(attributes, &none);
    if (!error) error = posix_spawnattr_setsigdefault(attributes, &all);
    short flags = POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF;
    return error ? error : posix_spawnattr_setflags(attributes, flags);
}

/* The command's input, with everything it says thrown away. 0, or an error number. */
static int spawn(int input, char *const *arguments, pid_t *command) {
    posix_spawnattr_t attributes;
    int cleared = posix_spawnattr_init(&attributes);
    if (cleared) return cleared;
    posix_spawn_file_actions_t actions;
    int error = posix_spawn_file_actions_init(&actions);
    if (error) return posix_spawnattr_destroy(&attributes), error;
    error = clear_signals(&attributes);
    if (!error) error = posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
    if (!error) error = posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    if (!error) error = posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    if (!error) error = posix_spawnp(command, arguments[0], &actions, &attributes, arguments, environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    return error;
}

static mt_status start(char *const *arguments, mt_movie_pipe *pipe, mt_movie_fault *fault) {
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) return MT_CANNOT_WRITE;
    int error = spawn(ends[1], arguments, &pipe->command);
    close(ends[1]);
    if (!error) {
        pipe->socket = ends[0];
        return MT_OK;
    }
    close(ends[0]);
    if (error == ENOENT) *fault = MT_MOVIE_MISSING;
    errno = error;
    return MT_CANNOT_WRITE;
}

/* Ends the input and waits; whether the command was content. */
static bool finish(mt_movie_pipe *pipe) {
    int outcome;
    close(pipe->socket);
    while (waitpid(pipe->command, &outcome, 0) < 0)
        if (errno != EINTR) return false;
    return WIFEXITED(outcome) && WEXITSTATUS(outcome) == 0;
}

/* ---- frames -------------------------------------------------------------------------------------------- */

static mt_status send_all(int socket, const uint8_t *bytes, size_t length) {
    while (length) {
        ssize_t sent = send(socket, bytes, length, MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR) continue;
        if (sent < 0) return MT_CANNOT_WRITE;
        bytes += sent;
        length -= (size_t)sent;
    }
    return MT_OK;
}

static mt_status take(const mt_drawn_frame *frame, void *user) {
    const mt_movie_pipe *pipe = user;
    mt_arena arena = {0};
    size_t length = (size_t)frame->width * (size_t)frame->height * (size_t)mt_raster_channels(frame);
    const uint8_t *pixels = mt_raster_pixels(frame, &arena);
    mt_status status = pixels ? MT_OK : MT_NO_MEMORY;
    for (int i = 0; status == MT_OK && i < frame->length; i++)
        status = send_all(pipe->socket, pixels, length);
    mt_arena_release(&arena);
    return status;
}

static mt_status play(const mt_motion *motion, char *const *arguments, mt_movie_fault *fault) {
    mt_movie_pipe pipe;
    int plays = motion->request.timing.plays;
    mt_status status = mt_raster_check(motion, plays > 1 ? plays : 1);
    if (status == MT_OK) status = start(arguments, &pipe, fault);
    if (status != MT_OK) return status;
    do status = mt_raster_play(motion, take, &pipe);
    while (status == MT_OK && --plays > 0);
    bool content = finish(&pipe);
    if (status == MT_NO_MEMORY || status == MT_TOO_LARGE || (status == MT_OK && content)) return status;
    *fault = MT_MOVIE_FAILED;
    return MT_CANNOT_WRITE;
}

static mt_status make(const mt_motion *motion, mt_movie_kind kind, const char *file, mt_movie_fault *fault) {
    char size[32], rate[16];
    bool clear = !motion->request.has_background;
    snprintf(size, sizeof size, "%dx%d", motion->page.width, motion->page.height);
    snprintf(rate, sizeof rate, "%d", motion->request.timing.fps);
    char *arguments[] = {"ffmpeg",
                         "-y",
                         "-nostdin",
                         "-f",
                         "rawvideo",
                         "-pix_fmt",
                         clear ? "rgba" : "rgb24",
                         "-s",
                         size,
                         "-r",
                         rate,
                         "-i",
                         "pipe:0",
                         "-an",
                         "-pix_fmt",
                         clear ? "yuva420p" : "yuv420p",
                         "-f",
                         kind == MT_MOVIE_MP4 ? "mp4" : "webm",
                         (char *)(uintptr_t)file,
                         NULL};
    return play(motion, arguments, fault);
}

mt_status mt_movie_save(const mt_motion *motion, mt_movie_kind kind, const char *path,
                        mt_movie_fault *fault) {
    bool odd = motion->page.width % 2 || motion->page.height % 2;
    *fault = MT_MOVIE_FINE;
    if (odd || (kind == MT_MOVIE_MP4 && !motion->request.has_background)) return MT_BAD_PARAMETER;
    if (mt_file_check(path) != MT_OK) return MT_CANNOT_WRITE;
    /* ffmpeg takes a name with a colon for an address, unless it begins like this. */
    enum { FILE_PREFIX = 5 };
    char *file = mt_new(FILE_PREFIX + strlen(path) + MT_BESIDE_ROOM, 1);
    if (!file) return MT_NO_MEMORY;
    memcpy(file, "file:", FILE_PREFIX);
    char *name = file + FILE_PREFIX;
    int made = mt_file_beside(path, mt_file_create, 0666, name);
    mt_status status = MT_CANNOT_WRITE;
    if (made >= 0) {
        close(made);
        status = make(motion, kind, file, fault);
        if (status == MT_OK && rename(name, path) != 0) status = MT_CANNOT_WRITE;
        int why = errno;
        if (status != MT_OK) unlink(name);
        mt_temporary_end(name);
        errno = why;
    }
    mt_free(file);
    return status;
}
