#include "morphotype.h"

const char *mt_version(void) {
    return MORPHOTYPE_VERSION;
}

const char *mt_status_text(mt_status status) {
    switch (status) {
    case MT_OK: return "done";
    case MT_NO_MEMORY: return "out of memory";
    case MT_NO_FILE: return "the file is missing or cannot be read";
    case MT_NOT_A_FONT: return "not a font, or a damaged one";
    case MT_NO_FACE: return "no such face in the file";
    case MT_NO_AXIS: return "no such axis in the font";
    case MT_BAD_AXIS: return "an axis setting is malformed or out of range";
    case MT_NO_OUTLINES: return "the font has no outlines";
    case MT_NO_CHARMAP: return "the font maps no Unicode characters";
    case MT_NO_GLYPH: return "the font has no glyph for the character";
    case MT_BAD_GLYPH: return "the outline cannot be read";
    case MT_NO_COUNTERPART: return "one font draws the character, the other leaves it blank";
    case MT_TOO_LARGE: return "too large: a coordinate or a count is over the limit";
    case MT_BAD_GEOMETRY: return "the outline could not be cut into convex pieces";
    case MT_NOTHING_SHARED: return "the two fonts have no character in common";
    case MT_BAD_PARAMETER: return "a parameter is out of range";
    case MT_CANNOT_WRITE: return "the file cannot be written";
    case MT_UNKNOWN_FORMAT: return "the file's extension is of no format that can be written";
    case MT_BAD_HINTS: return "the hints file is malformed";
    case MT_NO_FEATURE: return "no such feature among the font's substitutions";
    case MT_BAD_FEATURE: return "features are written TAG or TAG=N, with commas between, each once";
    case MT_ENDLESS_LOOKUPS:
        return "its lookups call each other in a circle, or make a text longer without end";
    case MT_BLANK: return "there is no ink";
    case MT_BAD_MESH: return "not a mesh, or a damaged one";
    case MT_NOT_SOLID: return "the mesh is not the surface of a solid";
    case MT_BAD_DRAWING: return "not an SVG drawing, or a damaged one";
    case MT_STOPPED: return "stopped";
    case MT_TOO_COSTLY: return "it would take more work or memory than a glyph may";
    }
    return "unknown status";
}
