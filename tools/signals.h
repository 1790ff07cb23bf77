/* The program told to end while it works: what it has begun beside its outputs goes first. */
#pragma once

/* Watches for SIGINT, SIGTERM and SIGHUP, unless the caller has them ignored; a file that may grow no further (SIGXFSZ) is one that cannot be
 * written. Before any thread is started. */
void signals_watch(void);
