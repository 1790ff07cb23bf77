/* Blended fonts saved in the format of their file's extension: .ttf, .woff2 or .ufo. */
#pragma once

#include "blend/making.h"
#include "write/font_data.h"

typedef enum mt_font_format {
    MT_FONT_TTF,
    MT_FONT_WOFF2,
    MT_FONT_UFO,         /* a directory */
    MT_FONT_DESIGNSPACE, /* a file and a directory; of variable fonts */
} mt_font_format;

/* By the extension, whatever its capitals; false for any other. */
bool mt_font_format_of(const char *path, mt_font_format *format);

/* Whether a font may be saved at `path`, as far as what stands there tells: a file is replaced, a directory only where
 * it is a UFO and a UFO is to be saved. MT_UNKNOWN_FORMAT, MT_CANNOT_WRITE (errno says why), MT_NO_MEMORY. */
mt_status mt_save_check(const char *path);

typedef struct mt_saving {
    const double *t; /* NULL for variable fonts */
    int count;
    const char *const *paths; /* one for each T or variable font */
    mt_status (*made)(
        void *user); /* called when all fonts are made and none is in its place, unless NULL; its status
                                    * other than MT_OK ends the saving */
    void *user;
    size_t *lengths; /* filled in with the bytes that each file or directory has, unless NULL */
    int *
        unsaid; /* raised to the rules, lookups and features that the features.fea of one UFO cannot say, unless NULL */
} mt_saving;

/* The bytes of a font as WOFF2, for mt_bytes_free, in the way that keeps what `data`, of which they were written, asks for.
 * MT_TOO_LARGE, MT_NO_MEMORY. */
mt_status mt_font_pack(const mt_font_data *data, const uint8_t *font, size_t length, uint8_t **packed,
                       size_t *packed_length);

/* Saves them all or none: when one cannot be put in its place, those that were go again. `failed`, unless NULL, says
 * which could not be written or is too large; -1 for other errors. What mt_blend_fonts gives, and MT_UNKNOWN_FORMAT,
 * MT_CANNOT_WRITE (errno says why). */
mt_status mt_blend_save_when(mt_blend *blend, const mt_saving *saving, int *failed);
/* The same of variable fonts, one for each path. Each has a sink that takes its glyphs besides, unless that is NULL; or `also` is. */
mt_status mt_variables_save_when(mt_variable *const *variables, const mt_sink *const *also,
                                 const mt_saving *saving, int *failed);
