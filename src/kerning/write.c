#include "kerning/write.h"

#include "kerning/write_list.h"
#include "kerning/write_matrix.h"

mt_status mt_pairs_write(const mt_mixed_pairs *mixed, mt_var_store *store, mt_arena *arena,
                         mt_bytes **subtables, int *count) {
    mt_pair_writer writer = {.mixed = mixed, .store = store, .arena = arena};
    mt_status status = mt_pair_write_list(&writer);
    if (status == MT_OK) status = mt_pair_write_matrix(&writer);
    if (status != MT_OK) return status;
    *subtables = writer.subtables.list;
    *count = writer.subtables.count;
    return MT_OK;
}
