/* The contents of a mesh's file, after a byte that chooses the format, to the surface of a solid. */
#include "fuzz.h"

#include <stdlib.h>
#include <string.h>

#include "mesh/read.h"

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t length) {
    if (length < 2) return 0;
    mt_arena arena = {0};
    mt_mesh mesh, again;
    mt_mesh_fault fault = {0};
    uint8_t *copy = malloc(length - 1);
    fuzz_require(copy);
    memcpy(copy, bytes + 1, length - 1);
    mt_arena_bound(&arena, &(mt_allowance){INT64_MAX, (size_t)256 << 20, NULL});
    mt_mesh_format format = (mt_mesh_format)(bytes[0] % (MT_MESH_GLB + 1));
    if (mt_mesh_parse(copy, length - 1, format, &arena, &mesh, &fault) == MT_OK)
        fuzz_require(mt_mesh_check(&mesh, &arena, &again, &fault) == MT_OK);
    free(copy);
    mt_arena_release(&arena);
    return 0;
}
