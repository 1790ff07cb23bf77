/* libwoff2 behind woff2.h. No exception leaves it. */
#include <fcntl.h>
#include <mutex>
#include <new>
#include <stdexcept>
#include <unistd.h>
#include <woff2/encode.h>

extern "C" {
#include "base/memory.h"
#include "save/woff2.h"
}

namespace {

/* Sends what is written to stderr nowhere as long as it lives: libwoff2, as Debian builds it, reports there on its work.
 * Where that cannot be had, the reports are. */
class Silence {
  public:
    Silence() : lock(turn()), kept(fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1)) {
        int nowhere = kept < 0 ? -1 : open("/dev/null", O_WRONLY | O_CLOEXEC);
        if (nowhere < 0) return;
        dup2(nowhere, STDERR_FILENO);
        close(nowhere);
    }
    ~Silence() {
        if (kept < 0) return;
        dup2(kept, STDERR_FILENO);
        close(kept);
    }
    Silence(const Silence &) = delete;
    Silence &operator=(const Silence &) = delete;

  private:
    /* The whole process has one stderr: one thread at a time puts it aside and back. */
    static std::mutex &turn() {
        static std::mutex mutex;
        return mutex;
    }
    std::lock_guard<std::mutex> lock;
    int kept;
};

/* Into `room` bytes, of which *length are used. */
mt_status pack(const uint8_t *font, size_t font_length, uint8_t *room, size_t *length) try {
    Silence silence;
    return woff2::ConvertTTFToWOFF2(font, font_length, room, length) ? MT_OK : MT_TOO_LARGE;
} catch (const std::bad_alloc &) {
    return MT_NO_MEMORY;
} catch (const std::length_error &) {
    return MT_TOO_LARGE;
}

} // namespace

extern "C" mt_status mt_woff2_pack(const uint8_t *font, size_t length, uint8_t **bytes, size_t *packed) {
    size_t used = woff2::MaxWOFF2CompressedSize(font, length);
    uint8_t *room = static_cast<uint8_t *>(mt_new(used, 1));
    if (!room) return MT_NO_MEMORY;
    mt_status status = pack(font, length, room, &used);
    if (status != MT_OK) {
        mt_free(room);
        return status;
    }
    void *fitting = mt_grow(room, used, 1);
    *bytes = fitting ? static_cast<uint8_t *>(fitting) : room;
    *packed = used;
    return MT_OK;
}
