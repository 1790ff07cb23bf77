/* How what was made gets to its place: flushed, through links, with the rights of what it replaces, and never with nothing there. */
#pragma once

#include "morphotype.h"

/* Where a file at `path` really goes: where links lead to, though nothing need stand there. From mt_new; NULL when out of memory. */
char *mt_place_of(const char *path);

/* Gives an open file the rights of the one that it is to replace, if there is one. */
void mt_place_keep_mode(const char *path, int file);

/* Has what is written to a file, or to anything in a folder, on the disk. False, with errno, where the disk could not take it. */
bool mt_place_flush_file(int file);
bool mt_place_flush_folder(const char *path);

/* Puts a file or folder at a place of the same file system; where something stands there, each comes to where the other was, in one step
 * where the file system can. *stood: something did. False, with errno: nothing has moved. */
bool mt_place_swap(const char *fresh, const char *path, bool *stood);
/* Takes that back. */
void mt_place_swap_back(const char *fresh, const char *path, bool stood);
