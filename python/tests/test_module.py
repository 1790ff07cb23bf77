"""The module against the command line, its own promises, and bad input."""

import io
import os
import pathlib
import sys
import tempfile
import threading
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))

from fontTools.pens.areaPen import AreaPen
from fontTools.pens.recordingPen import RecordingPen
from fontTools.ttLib import TTFont

import morphotype
from morphotype._native import ffi
from support import SANS, SERIF, command_line

CHARS = 'type'


class Folder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)


class SameBytes(Folder):
    """What the module gives is what the command line writes."""

    def written(self, *arguments, name='out.ttf'):
        result = command_line(*arguments, '-o', self.folder / name)
        self.assertEqual(result.returncode, 0, result.stderr)
        return (self.folder / name).read_bytes()

    def test_blend(self):
        expected = self.written('blend', SANS, SERIF, '--at', '0.3', '--text', CHARS)
        for a, b in [(SANS, str(SERIF)), (SANS.read_bytes(), bytearray(SERIF.read_bytes()))]:
            self.assertEqual(morphotype.blend(a, b, 0.3, chars=CHARS), expected)

    def test_hints(self):
        """The end of the bar with the top of the stem, which the engine would not put together by itself, so that they make another font."""
        hints = self.folder / 'hints.txt'
        hints.write_text('glyph t\npoint 343,530 340,1188\n')
        expected = self.written('blend', SANS, SERIF, '--text', CHARS, '--hints', hints)
        self.assertEqual(morphotype.blend(SANS, SERIF, chars=CHARS, hints=hints.read_text()), expected)
        self.assertNotEqual(morphotype.blend(SANS, SERIF, chars=CHARS), expected)

    def test_heights_and_places(self):
        (self.folder / 'places.txt').write_text(f'{CHARS[0]} 0.8\n')
        expected = self.written('blend', SANS, SERIF, '--at', '0.3,y=0.6', '--places', self.folder / 'places.txt', '--text', CHARS)
        blend = morphotype.Blend(SANS, SERIF)
        blend.set_chars(CHARS)
        blend.set_heights([0.6])
        blend.set_places({CHARS[0]: 0.8})
        self.assertEqual(blend.font(0.3), expected)
        blend.set_heights(None)
        self.assertNotEqual(blend.font(0.3), expected)
        with self.assertRaises(morphotype.Error):
            blend.set_places({10 ** 6: 0.5})

    def test_a_whole_font_with_names(self):
        expected = self.written('blend', SANS, SERIF, '--family', 'Between', '--style', 'Bold')
        self.assertEqual(morphotype.blend(SANS, SERIF, family='Between', style='Bold'), expected)

    def test_variable(self):
        expected = self.written('variable', SANS, SERIF, '--text', CHARS, '--axis', 'wght=400..900')
        made = morphotype.variable(SANS, SERIF, chars=CHARS, axis=('wght', 400, 900))
        self.assertEqual(made, expected)

    def test_report(self):
        expected = self.written('report', SANS, SERIF, '--text', CHARS, name='out.json')
        report = morphotype.report(str(SANS), str(SERIF), chars=CHARS)
        self.assertEqual(report, morphotype.Report.from_json(expected))
        self.assertEqual({glyph.char for glyph in report.glyphs}, set(CHARS))
        self.assertEqual(len(report.flagged), report.summary['flagged'])

    def test_files(self):
        expected = self.written('strip', SANS, SERIF, '--text', 'ty', '--at', '0,1', '--size', '40', name='a.svg')
        blend = morphotype.Blend(SANS, SERIF)
        blend.save_strip(self.folder / 'b.svg', 'ty', at=[0, 1], size=40)
        self.assertEqual((self.folder / 'b.svg').read_bytes(), expected)
        expected = self.written('specimen', SANS, SERIF, '--text', 'ty', name='a.html')
        variable = morphotype.Variable(SANS, SERIF)
        variable.set_chars('ty')
        variable.save_specimen(self.folder / 'b.html', 'ty')
        self.assertEqual((self.folder / 'b.html').read_bytes(), expected)

    def test_ttfont_at_both_ends(self):
        a, b = TTFont(SANS), TTFont(SERIF)
        made = morphotype.blend(a, b, chars=CHARS, as_ttfont=True)
        self.assertIsInstance(made, TTFont)
        self.assertEqual(sorted(made.getBestCmap()), sorted(map(ord, set(CHARS))))
        again = morphotype.blend(made, b, chars=CHARS, as_ttfont=True)
        self.assertEqual(again['maxp'].numGlyphs, made['maxp'].numGlyphs)


class Outlines(unittest.TestCase):
    def test_a_font_draws_as_fonttools_does(self):
        for path in (SANS, SERIF):
            font, other = morphotype.Font(path), TTFont(path)
            glyphs, names = other.getGlyphSet(), other.getBestCmap()
            self.assertEqual(font.units_per_em, other['head'].unitsPerEm)
            for char in font.chars():
                mine, theirs = AreaPen(), AreaPen()
                advance = font.draw(char, mine)
                glyphs[names[ord(char)]].draw(theirs)
                self.assertAlmostEqual(mine.value, theirs.value, delta=0.01 + 1e-6 * abs(theirs.value))
                self.assertEqual(advance, glyphs[names[ord(char)]].width)

    def test_a_blend_draws_what_its_font_has(self):
        blend = morphotype.Blend(SANS, SERIF)
        blend.set_chars('g')
        font = TTFont(io.BytesIO(blend.font(0.5)))
        mine, theirs = AreaPen(), AreaPen()
        advance = blend.draw('g', mine, 0.5)
        font.getGlyphSet()[font.getBestCmap()[ord('g')]].draw(theirs)
        self.assertAlmostEqual(abs(mine.value / theirs.value), 1, delta=0.01)
        self.assertAlmostEqual(advance, font['hmtx'][font.getBestCmap()[ord('g')]][0], delta=1)
        self.assertEqual(blend.units_per_em, font['head'].unitsPerEm)

    def test_a_glyph_has_a_character_a_number_and_a_name(self):
        blend, font = morphotype.Blend(SANS, SERIF), morphotype.Font(SANS)
        by_char, by_number, by_name = RecordingPen(), RecordingPen(), RecordingPen()
        blend.draw('g', by_char)
        blend.draw(font.glyph_number('g'), by_number)
        blend.draw('/uni0067', by_name)
        self.assertEqual(by_char.value, by_number.value)
        self.assertEqual(by_char.value, by_name.value)
        self.assertTrue(any(name == 'qCurveTo' for name, _ in by_char.value))
        self.assertEqual(by_char.value[-1], ('closePath', ()))

    def test_outlines_move_without_a_font(self):
        square, wide = morphotype.Outline(100), morphotype.Outline(100)
        for outline, width in ((square, 40), (wide, 80)):
            for i, point in enumerate([(0, 0), (width, 0), (width, 40), (0, 40)]):
                (outline.lineTo if i else outline.moveTo)(point)
            outline.closePath()
        morph = morphotype.Morph(square, wide)
        for at, area in ((0, 1600), (0.5, 2400), (1, 3200)):
            pen = AreaPen()
            morph.draw(at, pen)
            self.assertAlmostEqual(abs(pen.value), area, delta=5)

    def test_a_closed_spline_without_a_point_on_it(self):
        circle = morphotype.Outline(100)
        circle.qCurveTo((0, 0), (100, 0), (100, 100), (0, 100), None)
        circle.closePath()
        pen = AreaPen()
        morphotype.Morph(circle, circle).draw(0.5, pen)
        self.assertAlmostEqual(abs(pen.value), 100 * 100 * 5 / 6, delta=20)

    def test_what_a_pen_raises_comes_through(self):
        class Broken(RecordingPen):
            def qCurveTo(self, *points):
                raise ZeroDivisionError

        with self.assertRaises(ZeroDivisionError):
            morphotype.Blend(SANS, SERIF).draw('g', Broken())
        with self.assertRaises(ZeroDivisionError):
            morphotype.Font(SANS).draw('g', Broken())


class Stopping(Folder):
    def test_progress_grows_to_all(self):
        calls = []
        morphotype.blend(SANS, SERIF, chars=CHARS, progress=lambda done, total: calls.append((done, total)))
        self.assertEqual([done for done, _ in calls], list(range(1, len(calls) + 1)))
        self.assertEqual(calls[-1][0], calls[-1][1])

    def test_false_stops(self):
        calls = []

        def progress(done, total):
            calls.append(done)
            return done < 3

        with self.assertRaises(morphotype.Error) as caught:
            morphotype.blend(SANS, SERIF, progress=progress, params=morphotype.Params(threads=1))
        self.assertEqual(caught.exception.status, morphotype.Status.STOPPED)
        self.assertEqual(calls, [1, 2, 3])

    def test_what_progress_raises_comes_through_and_the_blend_goes_on(self):
        def progress(done, total):
            raise KeyboardInterrupt

        blend = morphotype.Blend(SANS, SERIF)
        blend.set_chars(CHARS)
        expected = blend.font()
        with self.assertRaises(KeyboardInterrupt):
            blend.font(progress=progress)
        self.assertEqual(blend.font(), expected)

    def test_another_thread_stops(self):
        variable = morphotype.Variable(SANS, SERIF)
        started = threading.Event()

        def stop():
            started.wait()
            variable.stop()

        thread = threading.Thread(target=stop)
        thread.start()

        def progress(done, total):
            started.set()
            thread.join()

        with self.assertRaises(morphotype.Error) as caught:
            variable.save(self.folder / 'x.ttf', progress=progress)
        self.assertEqual(caught.exception.status, morphotype.Status.STOPPED)
        self.assertEqual(list(self.folder.iterdir()), [])
        with self.assertRaises(morphotype.Error):
            variable.font()
        variable.resume()
        variable.set_chars('t')
        variable.font()

    def test_a_handle_serves_one_call_at_a_time(self):
        blend, errors = morphotype.Blend(SANS, SERIF), []
        blend.set_chars(CHARS)

        def progress(done, total):
            try:
                blend.font()
            except RuntimeError as error:
                errors.append(error)

        blend.font(progress=progress)
        self.assertTrue(errors)
        blend.font()


class BadInput(Folder):
    def assert_fails(self, call, *arguments):
        """The error's words are those of the command line."""
        with self.assertRaises(morphotype.Error) as caught:
            call()
        result = command_line(*arguments, '-o', self.folder / 'out.ttf')
        self.assertEqual(result.returncode, 1)
        self.assertEqual(result.stderr, f'morphotype: {caught.exception}\n')
        return caught.exception

    def test_files_that_are_no_fonts(self):
        pdf = self.folder / 'a.pdf'
        pdf.write_bytes(b'%PDF-1.4')
        error = self.assert_fails(lambda: morphotype.blend(pdf, SERIF), 'blend', pdf, SERIF)
        self.assertEqual(error.status, morphotype.Status.NOT_A_FONT)
        missing = self.folder / 'missing.ttf'
        error = self.assert_fails(lambda: morphotype.blend(SANS, missing), 'blend', SANS, missing)
        self.assertEqual(error.status, morphotype.Status.NO_FILE)
        self.assert_fails(lambda: morphotype.blend(f'{SANS}#7', SERIF), 'blend', f'{SANS}#7', SERIF)
        with self.assertRaisesRegex(morphotype.Error, 'not a font, or a damaged one'):
            morphotype.blend(b'', SERIF)

    def test_outputs_that_cannot_be_written(self):
        blend = morphotype.Blend(SANS, SERIF)
        blend.set_chars('t')
        for path, status in ((self.folder / 'x.doc', morphotype.Status.UNKNOWN_FORMAT),
                             (self.folder / 'none' / 'x.ttf', morphotype.Status.CANNOT_WRITE)):
            with self.assertRaisesRegex(morphotype.Error, path.name) as caught:
                blend.save(path)
            self.assertEqual(caught.exception.status, status)

    def test_wrong_types(self):
        for call in (
            lambda: morphotype.blend(1, SERIF),
            lambda: morphotype.blend(SANS, None),
            lambda: morphotype.blend(SANS, SERIF, 'half'),
            lambda: morphotype.blend(SANS, SERIF, chars=7),
            lambda: morphotype.blend(SANS, SERIF, params=3),
            lambda: morphotype.blend(SANS, SERIF, progress=3),
            lambda: morphotype.blend(SANS, SERIF, chars='t', params=morphotype.Params(tolerance='x')),
            lambda: morphotype.Font(SANS, 1),
            lambda: morphotype.Morph(1, 2),
        ):
            with self.assertRaises(TypeError):
                call()

    def test_values_out_of_range(self):
        for call in (
            lambda: morphotype.blend(SANS, SERIF, 2.5, chars='t'),
            lambda: morphotype.blend(SANS, SERIF, params=morphotype.Params(tolerance=0)),
            lambda: morphotype.Variable(SANS),
            lambda: morphotype.variable(SANS, SERIF, axis=('x', 0, 1)),
            lambda: morphotype.Outline(0),
        ):
            with self.assertRaises(morphotype.Error) as caught:
                call()
            self.assertEqual(caught.exception.status, morphotype.Status.BAD_PARAMETER)
        with self.assertRaises(ValueError):
            morphotype.blend(SANS, SERIF, glyphs='all')

    def test_hints_name_their_line(self):
        with self.assertRaisesRegex(morphotype.Error, '^hints:2: ') as caught:
            morphotype.blend(SANS, SERIF, hints='# one\nnonsense\n')
        self.assertEqual(caught.exception.status, morphotype.Status.BAD_HINTS)

    def test_the_glyph_that_is_the_reason(self):
        blend = morphotype.Blend(SANS, SERIF)
        with self.assertRaises(morphotype.Error) as caught:
            blend.draw('☃', RecordingPen())
        self.assertEqual(caught.exception.status, morphotype.Status.NO_GLYPH)
        self.assertEqual(caught.exception.glyph.char, '☃')
        params = morphotype.Params(effort=0.01)
        with self.assertRaises(morphotype.Error) as caught:
            morphotype.blend(SANS, SERIF, params=params, strict=True)
        self.assertEqual(caught.exception.status, morphotype.Status.TOO_COSTLY)
        self.assertIsNotNone(caught.exception.glyph)


class Names(unittest.TestCase):
    def test_statuses_are_the_library_s(self):
        library = {name[3:]: value for value, name in ffi.typeof('mt_status').elements.items()}
        self.assertEqual(library, {status.name: int(status) for status in morphotype.Status})

    def test_the_version_is_the_program_s(self):
        self.assertIn(morphotype.__version__, command_line('--version').stdout)


if __name__ == '__main__':
    unittest.main()
