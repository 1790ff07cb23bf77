/* A file, or a directory with all that is in it. */
#pragma once

/* Removes it. A link to a directory goes, and what it leads to stays. Leaves errno as it was. */
void mt_tree_remove(const char *path);
