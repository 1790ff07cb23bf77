#include "option_table.h"

#include "options.h"

#include <string.h>

/* The letters that every command takes, unless it leaves them. */
#define COMMON "fjqvhVMTwrmsRIHgZ"

const option_row option_rows[] = {
    {'o', true, "output", "FILE", NULL, "the file to write; - for stdout, with --format"},
    {'Z', false, "format", "EXT", NULL, "what -o - writes: an extension that OUT may have"},
    {'a', false, "at", "T[,y=T][,T...]", NULL,
     "places from 0 (the first) to 1 (the second), heights at y; of blend, from -1 to 2"},
    {'@', false, "places", "FILE", NULL,
     "characters and glyphs with a place of their own: a line has them, and T or T,y=T"},
    {'n', false, "steps", "N", NULL, "N evenly spaced places, both ends among them (2 ... 1000)"},
    {'t', false, "text", "TEXT", NULL, "the text, UTF-8, with glyphs as /NAME; again for another line"},
    {'c', false, "chars", "FILE", NULL,
     "characters, code points, ranges U+4E00-4E2F, glyphs /NAME; # comments"},
    {'z', false, "size", "SIZE", NULL, "pixels (points in SVG and PDF) an em, a cell of a sheet, or a solid"},
    {'p', false, "rows", "N", NULL, "rows on a page; without it, as many as A4's proportions take"},
    {'l', false, "no-labels", NULL, NULL, "leave out the T under each step"},
    {'F', false, "family", "NAME", NULL, "the new font's family name"},
    {'Y', false, "style", "NAME[,NAME...]", NULL,
     "the new font's style, such as SemiBold Italic; one for each T"},
    {'G', false, "glyphs", "both|first", NULL,
     "those of both fonts, or all of the first's, unblended where need be"},
    {'Q', false, "curves", "cubic|quadratic", NULL, "of a UFO's or designspace's outlines; cubic without it"},
    {'E', false, "alternates", NULL, NULL,
     "keep forms that text asks for (small capitals ...) of --text, --chars"},
    {'L', false, "no-layout", NULL, NULL,
     "characters alone: no substitutions, kerning or marks of either font"},
    {'X', false, "axis", "TAG[=FROM..TO]", NULL,
     "the axis, from the first font to the last; without numbers each at its own weight, width or slant"},
    {'x', false, "stops", "V,V[,V...]", NULL, "where on the axis each font stands, in the order given"},
    {'A', false, "avar", "V:P[,V:P...]", NULL, "at V on the axis the font stands at P, both from 0 to 100"},
    {'J', false, "json", NULL, NULL, "data: on stdout, or into FILE when that ends in .json"},
    {'D', false, "duration", "SECONDS", NULL,
     "of a play, without what it holds; a second from one to the next"},
    {'U', false, "fps", "N", NULL, "frames a second (1 ... 240); without it, 30"},
    {'e', false, "ease", "EASE", "linear ease ease-in ease-out ease-in-out",
     "ease-in-out, another name of CSS, or cubic-bezier(X1,Y1,X2,Y2)"},
    {'O', false, "ease-over", "each|whole", NULL,
     "ease from each to the next, or from the first to the last"},
    {'d', false, "hold", "SECONDS", NULL, "that each key frame stays (0 ... 60)"},
    {'N', false, "loop", "N|forever", NULL, "how often it plays; forever without it"},
    {'y', false, "yoyo", NULL, NULL, "back again the way it came"},
    {'C', false, "canvas", "WxH", NULL, "of so many pixels, with the drawing in its middle"},
    {'k', false, "color", "COLOR[,COLOR...]", NULL,
     "of the drawing, or from the first to the last, or of each"},
    {'b', false, "background", "COLOR|none", NULL, "white without it"},
    {'K', false, "css", NULL, NULL, "SVG that moves by CSS, not by SMIL"},
    {'i', false, "depth", "X", NULL, "how far pieces may leave their hulls, of the diagonal (0.001 ... 0.5)"},
    {'u', false, "about", "x|y|z|X,Y,Z", NULL, "the axis of --rotate; y without it"},
    {'W', false, "view", "TURN,TILT", NULL, "from where pictures look, degrees; -30,25 without it"},
    {'B', false, "fail-on", "REASON[,REASON...]|N", "failed components holes strays clots ink",
     "exit with 1 if a glyph is flagged for one of these, or if N or more are flagged"},
    {'S', false, "strict", NULL, NULL, "a glyph that cannot be blended is an error, not a line on stderr"},
    {'M', false, "method", "joint|paper", NULL, "align boundaries where it goes, or map pieces throughout"},
    {'T', false, "tolerance", "E", NULL, "flattening error bound, 1/1000 em (0.05 ... 10)"},
    {'f', false, "fit", "E", NULL, "curve fitting error bound, 1/1000 em (0.05 ... 10)"},
    {'w', false, "weights", "W1,W2,W3", NULL, "place, area and box in matching components; sum 1"},
    {'r', false, "rounds", "N", NULL, "of the relaxation (0 ... 1000)"},
    {'m', false, "threshold", "X", NULL, "matches weaker than X times the best count as none (0 ... 1)"},
    {'s', false, "one-scale", NULL, NULL,
     "match pieces with one scale for both axes, as the paper prints it"},
    {'R', false, "rotate", "DEGREES|auto", NULL, "turn while blending; auto finds the angle of each glyph"},
    {'I', false, "slant", "DEGREES|auto", NULL,
     "by how much the second font leans more than the first; auto measures it"},
    {'P', false, "pairs", "FILE", NULL,
     "glyphs that go together, by name or code point, one a font on a line"},
    {'H', false, "hints", "FILE", NULL, "which parts and places of both fonts' glyphs go together"},
    {'g', false, "effort", "X", NULL,
     "work and memory that a glyph may take, times the usual (0.01 ... 100)"},
    {'0', false, "cache", "DIR", NULL,
     "take glyphs from this directory that were made before, and keep those made"},
    {'1', false, "cache-size", "GB", NULL, "what DIR may take (0.01 ... 10000); without it, 4"},
    {'j', true, "jobs", "N", NULL, "threads (1 ... 1024); without it, one a core"},
    {'q', true, "quiet", NULL, NULL, "say nothing but errors"},
    {'v', true, "verbose", NULL, NULL, "say what is done, and of each glyph by itself"},
    {'h', true, "help", NULL, NULL, "show this"},
    {'V', true, "version", NULL, NULL, "show the version"},
    {0},
};

_Static_assert(sizeof option_rows / sizeof *option_rows <= OPTION_ROOM, "getopt's tables have this room");

bool option_is_common(const option_row *row) {
    return strchr(COMMON, row->letter) != NULL;
}

bool option_is_taken(const option_row *row, const cli_command *command) {
    bool left = command->leaves && strchr(command->leaves, row->letter);
    return (option_is_common(row) && !left) || strchr(command->takes, row->letter);
}
