"""Writes the C of the module morphotype._native: what Python calls of morphotype.h, by cffi.

    build_ffi.py HEADER OUTPUT.c

The declarations are those of HEADER itself, of the functions in CALLED and of what these need, so that they cannot differ.
"""

import pathlib
import re
import sys

import cffi

CALLED = """
mt_version mt_status_text mt_bytes_free mt_params_default
mt_font_open mt_font_open_memory mt_font_close mt_font_family mt_font_style mt_font_next_char mt_font_glyph
mt_font_glyph_of_name mt_font_units_per_em mt_font_draw
mt_blend_new mt_blend_free mt_blend_on_glyph_failure mt_blend_on_unblended mt_blend_on_progress mt_blend_stop
mt_blend_set_family mt_blend_set_styles mt_blend_set_heights mt_blend_set_places mt_blend_set_chars mt_blend_set_glyphs mt_blend_set_hints
mt_blend_fonts mt_blend_save_fonts mt_blend_glyph mt_blend_glyph_numbered mt_blend_units_per_em mt_blend_warnings
mt_variable_new mt_variable_free mt_variable_on_glyph_failure mt_variable_on_unblended mt_variable_on_progress
mt_variable_stop mt_variable_set_family mt_variable_set_style mt_variable_set_chars mt_variable_set_glyphs
mt_variable_set_axis mt_variable_set_hints mt_variable_font mt_variable_save mt_variable_warnings
mt_report_new mt_report_free mt_report_bytes mt_report_save mt_strip_save mt_specimen_save
mt_path_new mt_path_free mt_path_move_to mt_path_line_to mt_path_quadratic_to mt_path_cubic_to
mt_moving_new mt_moving_free mt_moving_draw
mt_hint_table_open mt_hint_table_read mt_hint_table_free
""".split()

# What the library calls back, as Python functions of these names.
CALLBACKS = """
extern "Python" {
    void python_move_to(double x, double y, void *user);
    void python_line_to(double x, double y, void *user);
    void python_quadratic_to(double cx, double cy, double x, double y, void *user);
    void python_cubic_to(double c1x, double c1y, double c2x, double c2y, double x, double y, void *user);
    void python_close(void *user);
    void python_progress(int done, int all, void *user);
    void python_glyph_failed(const mt_glyph_note *note, void *user);
    void python_unblended(const mt_glyph_note *note, void *user);
    void python_warning(const char *line, void *user);
}
"""


def types_of(text):
    """All typedefs, without those of function pointers and structs that nobody asks for being different."""
    return re.findall(r'^typedef (?:[^;{]*\{[^}]*\}[^;]*|[^;{]*);', text, flags=re.M)


def functions_of(text):
    functions = {}
    for declaration in re.findall(r'^MT_API ([^;]*);', text, flags=re.M):
        functions[re.search(r'\b(mt_\w+)\(', declaration)[1]] = declaration + ';'
    return functions


def declarations(header):
    text = re.sub(r'/\*.*?\*/', '', header, flags=re.S)
    functions = functions_of(text)
    return '\n'.join([*types_of(text), *(functions[name] for name in CALLED), CALLBACKS])


def main():
    header, output = sys.argv[1:]
    ffi = cffi.FFI()
    ffi.cdef(declarations(pathlib.Path(header).read_text(encoding='utf-8')))
    ffi.set_source('morphotype._native', '#include <morphotype.h>')
    ffi.emit_c_code(output)


if __name__ == '__main__':
    main()
