"""Text shaped by HarfBuzz, whose library the program itself needs."""

import ctypes
import os

LIBRARY = ctypes.CDLL('libharfbuzz.so.0')


class Info(ctypes.Structure):
    """hb_glyph_info_t"""
    _fields_ = [('glyph', ctypes.c_uint32), ('mask', ctypes.c_uint32), ('cluster', ctypes.c_uint32),
                ('private', ctypes.c_uint32 * 2)]


class Variation(ctypes.Structure):
    """hb_variation_t"""
    _fields_ = [('axis', ctypes.c_uint32), ('value', ctypes.c_float)]


class Position(ctypes.Structure):
    """hb_glyph_position_t"""
    _fields_ = [('x_advance', ctypes.c_int32), ('y_advance', ctypes.c_int32), ('x_offset', ctypes.c_int32),
                ('y_offset', ctypes.c_int32), ('private', ctypes.c_uint32)]


def function(name, result, *arguments):
    found = getattr(LIBRARY, name)
    found.restype, found.argtypes = result, arguments
    return found


class Variant(ctypes.Structure):
    """hb_ot_math_glyph_variant_t"""
    _fields_ = [('glyph', ctypes.c_uint32), ('advance', ctypes.c_int32)]


class Part(ctypes.Structure):
    """hb_ot_math_glyph_part_t"""
    _fields_ = [('glyph', ctypes.c_uint32), ('start', ctypes.c_int32), ('end', ctypes.c_int32), ('full', ctypes.c_int32),
                ('flags', ctypes.c_int)]


POINTER, LENGTH = ctypes.c_void_p, ctypes.POINTER(ctypes.c_uint)
blob_create = function('hb_blob_create_from_file', POINTER, ctypes.c_char_p)
blob_destroy = function('hb_blob_destroy', None, POINTER)
face_create = function('hb_face_create', POINTER, POINTER, ctypes.c_uint)
face_destroy = function('hb_face_destroy', None, POINTER)
font_create = function('hb_font_create', POINTER, POINTER)
font_destroy = function('hb_font_destroy', None, POINTER)
buffer_create = function('hb_buffer_create', POINTER)
buffer_destroy = function('hb_buffer_destroy', None, POINTER)
buffer_add = function('hb_buffer_add_utf8', None, POINTER, ctypes.c_char_p, ctypes.c_int, ctypes.c_uint, ctypes.c_int)
buffer_guess = function('hb_buffer_guess_segment_properties', None, POINTER)
buffer_infos = function('hb_buffer_get_glyph_infos', ctypes.POINTER(Info), POINTER, LENGTH)
buffer_positions = function('hb_buffer_get_glyph_positions', ctypes.POINTER(Position), POINTER, LENGTH)
set_variations = function('hb_font_set_variations', None, POINTER, ctypes.POINTER(Variation), ctypes.c_uint)
vertical_origin = function('hb_font_get_glyph_v_origin', ctypes.c_int, POINTER, ctypes.c_uint32,
                           ctypes.POINTER(ctypes.c_int32), ctypes.POINTER(ctypes.c_int32))
vertical_advance = function('hb_font_get_glyph_v_advance', ctypes.c_int32, POINTER, ctypes.c_uint32)
math_has_data = function('hb_ot_math_has_data', ctypes.c_int, POINTER)
math_constant = function('hb_ot_math_get_constant', ctypes.c_int32, POINTER, ctypes.c_int)
math_italics = function('hb_ot_math_get_glyph_italics_correction', ctypes.c_int32, POINTER, ctypes.c_uint32)
math_accent = function('hb_ot_math_get_glyph_top_accent_attachment', ctypes.c_int32, POINTER, ctypes.c_uint32)
math_extended = function('hb_ot_math_is_glyph_extended_shape', ctypes.c_int, POINTER, ctypes.c_uint32)
math_kern = function('hb_ot_math_get_glyph_kerning', ctypes.c_int32, POINTER, ctypes.c_uint32, ctypes.c_int, ctypes.c_int32)
math_overlap = function('hb_ot_math_get_min_connector_overlap', ctypes.c_int32, POINTER, ctypes.c_int)
math_variants = function('hb_ot_math_get_glyph_variants', ctypes.c_uint, POINTER, ctypes.c_uint32, ctypes.c_int, ctypes.c_uint,
                         LENGTH, ctypes.POINTER(Variant))
math_assembly = function('hb_ot_math_get_glyph_assembly', ctypes.c_uint, POINTER, ctypes.c_uint32, ctypes.c_int, ctypes.c_uint,
                         LENGTH, ctypes.POINTER(Part), ctypes.POINTER(ctypes.c_int32))
font_face = function('hb_font_get_face', POINTER, POINTER)
shape_buffer = function('hb_shape', None, POINTER, POINTER, POINTER, ctypes.c_uint)


class Font:
    """A font file, at a place of its axis MORF where one is given."""

    def __init__(self, path, place=None):
        blob = blob_create(os.fsencode(path))
        face = face_create(blob, 0)
        self.font = font_create(face)
        face_destroy(face)
        blob_destroy(blob)
        if place is not None:
            axis = int.from_bytes(b'MORF', 'big')
            set_variations(self.font, ctypes.byref(Variation(axis, place)), 1)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        font_destroy(self.font)

    def shape(self, text):
        """The glyphs of a line of text, left to right, as (number, advance, x offset, y offset) in font units."""
        line = buffer_create()
        buffer_add(line, text.encode(), -1, 0, -1)
        buffer_guess(line)
        shape_buffer(self.font, line, None, 0)
        count = ctypes.c_uint()
        infos, positions = buffer_infos(line, ctypes.byref(count)), buffer_positions(line, ctypes.byref(count))
        shaped = [(infos[i].glyph, positions[i].x_advance, positions[i].x_offset, positions[i].y_offset)
                  for i in range(count.value)]
        buffer_destroy(line)
        return shaped

    def vertical(self, glyph):
        """How far down the next glyph is, and how high over the baseline this one hangs."""
        x, y = ctypes.c_int32(), ctypes.c_int32()
        vertical_origin(self.font, glyph, ctypes.byref(x), ctypes.byref(y))
        return -vertical_advance(self.font, glyph), y.value

    # ---- MATH, in font units ----

    CONSTANTS, CORNERS, MOST = 56, 4, 64
    RIGHT, UP = 4, 7 # hb_direction_t: how a glyph grows

    def has_math(self):
        return bool(math_has_data(font_face(self.font)))

    def constants(self):
        return [math_constant(self.font, i) for i in range(self.CONSTANTS)]

    def italics(self, glyph):
        return math_italics(self.font, glyph)

    def accent(self, glyph):
        return math_accent(self.font, glyph)

    def extended(self, glyph):
        return bool(math_extended(font_face(self.font), glyph))

    def kerns(self, glyph, height):
        return [math_kern(self.font, glyph, corner, height) for corner in range(self.CORNERS)]

    def overlap(self, direction):
        return math_overlap(self.font, direction)

    def variants(self, glyph, direction):
        """The larger glyphs as (number, measure)."""
        count, list_ = ctypes.c_uint(self.MOST), (Variant * self.MOST)()
        math_variants(self.font, glyph, direction, 0, ctypes.byref(count), list_)
        return [(list_[i].glyph, list_[i].advance) for i in range(count.value)]

    def assembly(self, glyph, direction):
        """The parts as (number, start, end, full, flags), and the correction of the whole."""
        count, list_, italics = ctypes.c_uint(self.MOST), (Part * self.MOST)(), ctypes.c_int32()
        math_assembly(self.font, glyph, direction, 0, ctypes.byref(count), list_, ctypes.byref(italics))
        return [(p.glyph, p.start, p.end, p.full, p.flags) for p in list_[:count.value]], italics.value


def shape(path, text):
    """As Font.shape."""
    with Font(path) as font:
        return font.shape(text)
