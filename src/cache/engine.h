/* Which engine this is. */
#pragma once

/* The digest of all sources that a morph comes from, in hexadecimal: made with the build (cache/engine.py), so that another engine has another
 * one, and a cache never gives what another engine made. */
extern const char mt_engine[];
