/* What is read is not written over: neither the fonts and drawings nor the files of characters, pairs and hints. */
#pragma once

#include "options.h"

/* Whether `path` leads to no source of this run: to no file that is read, under whatever name or link, and to no directory that
 * one of them is in. DONE or, said, COULD_NOT. */
int sources_spare(const cli_options *options, const char *path);

/* The same of the files NAME-1.png and so on that stand beside NAME.png, up to NAME-`count`.png, all with as many digits as that has;
 * with a count of 0, of all numbers. */
int sources_spare_numbered(const cli_options *options, const char *path, int count);
