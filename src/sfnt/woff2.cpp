/* libwoff2 behind woff2.h. No exception leaves it. */
#include <fcntl.h>
#include <mutex>
#include <new>
#include <stdexcept>
#include <string>
#include <unistd.h>
#include <woff2/decode.h>
#include <woff2/encode.h>

extern "C" {
#include "base/memory.h"
#include "sfnt/sfnt.h"
#include "sfnt/woff2.h"
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

/* ---- reading --------------------------------------------------------------------------------------------- */

enum { HEADER = 48, TOTAL_SIZE = 16, TABLE_COUNT = 12, GLYF = 10, LOCA = 11, OTHER_TAG = 63, PLAIN_GLYF = 3 };

/* A number of the directory (WOFF 2.0, "UIntBase128"): seven bits a byte, the last one without the highest. */
bool read_number(const uint8_t *bytes, size_t length, size_t *at, uint64_t *number) {
    *number = 0;
    for (int i = 0; i < 5 && *at < length; i++) {
        uint8_t byte = bytes[(*at)++];
        *number = *number << 7 | (byte & 0x7F);
        if (!(byte & 0x80)) return true;
    }
    return false;
}

/* Adds the size that an entry of the directory declares, before or after its transformation, whichever is larger. */
bool add_entry(const uint8_t *bytes, size_t length, size_t *at, uint64_t *size) {
    if (*at >= length) return false;
    unsigned flags = bytes[(*at)++], tag = flags & 0x3F, version = flags >> 6;
    uint64_t plain, transformed = 0;
    bool changed = tag == GLYF || tag == LOCA ? version != PLAIN_GLYF : version != 0;
    if (tag == OTHER_TAG) *at += 4;
    if (!read_number(bytes, length, at, &plain)) return false;
    if (changed && !read_number(bytes, length, at, &transformed)) return false;
    *size += plain > transformed ? plain : transformed;
    return true;
}

/* What the header and the directory declare, whichever is larger. False for what is cut short. */
bool declared_size(const uint8_t *bytes, size_t length, uint64_t *size) {
    if (length < HEADER) return false;
    uint64_t tables = 0, whole = mt_read_u32(bytes + TOTAL_SIZE);
    size_t at = HEADER;
    for (unsigned i = 0; i < mt_read_u16(bytes + TABLE_COUNT); i++)
        if (!add_entry(bytes, length, &at, &tables)) return false;
    *size = tables > whole ? tables : whole;
    return true;
}

mt_status unpack(const uint8_t *bytes, size_t length, std::string &font) try {
    Silence silence;
    woff2::WOFF2StringOut out(&font);
    out.SetMaxSize(MT_WOFF2_FONT_MAX);
    return woff2::ConvertWOFF2ToTTF(bytes, length, &out) ? MT_OK : MT_NOT_A_FONT;
} catch (const std::bad_alloc &) {
    return MT_NO_MEMORY;
} catch (const std::length_error &) {
    return MT_TOO_LARGE;
}

} // namespace

extern "C" bool mt_woff2_is(const uint8_t *bytes, size_t length) {
    return length >= 4 && mt_read_u32(bytes) == MT_TAG('w', 'O', 'F', '2');
}

extern "C" mt_status mt_woff2_unpack(const uint8_t *bytes, size_t length, uint8_t **font,
                                     size_t *font_length) {
    uint64_t size;
    std::string made;
    if (!declared_size(bytes, length, &size)) return MT_NOT_A_FONT;
    if (size > MT_WOFF2_FONT_MAX) return MT_TOO_LARGE;
    mt_status status = unpack(bytes, length, made);
    if (status != MT_OK) return status;
    uint8_t *kept = static_cast<uint8_t *>(mt_new(made.size() + 1, 1));
    if (!kept) return MT_NO_MEMORY;
    made.copy(reinterpret_cast<char *>(kept), made.size());
    *font = kept;
    *font_length = made.size();
    return MT_OK;
}

/* ---- writing --------------------------------------------------------------------------------------------- */

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
