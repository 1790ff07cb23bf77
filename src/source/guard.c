/* FreeType's memory, and the way out when there is none.
 *
 * FreeType 2.12 does not survive every failed allocation: its clean-up after one reads arrays that it could
 * not make (ft_var_done_item_variation_store, for one), and where it can it goes on without an optional
 * table, so that the font comes out different. Therefore it is never told of a failure. Its blocks hang in a
 * list; when a request fails, control leaves FreeType for the guard, which gives the whole list back. That is
 * safe because a handle's FreeType is its own and, reading from memory, holds nothing but memory. */
#include "source/handle.h"

#include <stdalign.h>

struct mt_kept {
    mt_kept *previous, *next;
    alignas(max_align_t) unsigned char bytes[];
};

static mt_kept *header_of(void *block) {
    return (mt_kept *)((unsigned char *)block - offsetof(mt_kept, bytes));
}

/* Points the neighbours at a block that is new or has moved. */
static void hang(mt_font *font, mt_kept *kept) {
    if (kept->next) kept->next->previous = kept;
    if (kept->previous)
        kept->previous->next = kept;
    else
        font->kept = kept;
}

static void *resize(mt_font *font, mt_kept *kept, long size) {
    mt_kept links = kept ? (mt_kept){kept->previous, kept->next} : (mt_kept){NULL, font->kept};
    mt_kept *resized = mt_grow(kept, offsetof(mt_kept, bytes) + (size_t)size, 1);
    if (!resized) longjmp(font->escape, 1);
    resized->previous = links.previous;
    resized->next = links.next;
    hang(font, resized);
    return resized->bytes;
}

/* ---- FreeType's callbacks ------------------------------------------------------------------------------ */

static void *allocate(FT_Memory memory, long size) {
    return resize(memory->user, NULL, size);
}

static void *reallocate(FT_Memory memory, long old_size, long size, void *block) {
    (void)old_size;
    return resize(memory->user, header_of(block), size);
}

static void release(FT_Memory memory, void *block) {
    mt_font *font = memory->user;
    mt_kept *kept = header_of(block);
    if (kept->next) kept->next->previous = kept->previous;
    if (kept->previous)
        kept->previous->next = kept->next;
    else
        font->kept = kept->next;
    mt_free(kept);
}

/* ---- the guard ----------------------------------------------------------------------------------------- */

mt_status mt_font_start(mt_font *font) {
    font->memory = (struct FT_MemoryRec_){font, allocate, release, reallocate};
    if (FT_New_Library(&font->memory, &font->library) != 0) return MT_NO_MEMORY;
    FT_Add_Default_Modules(font->library);
    return MT_OK;
}

void mt_font_discard(mt_font *font) {
    for (mt_kept *kept = font->kept, *next; kept; kept = next) {
        next = kept->next;
        mt_free(kept);
    }
    font->kept = NULL;
    font->library = NULL;
    font->face = NULL;
}

mt_status mt_font_guard(mt_font *font, mt_status (*work)(mt_font *font, void *user), void *user) {
    if (setjmp(font->escape) == 0) return work(font, user);
    mt_font_discard(font);
    return MT_NO_MEMORY;
}
