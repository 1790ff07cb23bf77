"""Unified Font Objects, read with fontTools' ufoLib, which checks them, and built into fonts again."""

import os
import pathlib
import subprocess

import cli
import harfbuzz
from fontTools import fontBuilder, ttLib
from fontTools.pens.basePen import decomposeQuadraticSegment
from fontTools.pens.recordingPen import DecomposingRecordingPen, RecordingPointPen
from fontTools.pens.ttGlyphPen import TTGlyphPointPen
from fontTools.ufoLib import UFOReader
from fontTools.ufoLib.filenames import userNameToFileName
from fontTools.ufoLib.kerning import lookupKerningValue

SAMPLE = os.environ['UFO_SAMPLE']
FONTS = (cli.SANS_BOLD, cli.SERIF)


class Part:
    """What ufoLib fills with attributes."""


class Ufo:
    """A UFO as ufoLib reads it, all its checks made."""

    def __init__(self, path):
        reader = UFOReader(path, validate=True)
        assert reader.formatVersionTuple == (3, 0)
        self.info = Part()
        reader.readInfo(self.info)
        self.groups, self.kerning, self.lib = reader.readGroups(), reader.readKerning(), reader.readLib()
        self.order = self.lib['public.glyphOrder']
        self.glyphs = reader.getGlyphSet(validateRead=True, validateWrite=True)
        self.files = self.glyphs.contents
        self.parts, self.outlines = {}, {}
        assert sorted(self.order) == sorted(self.glyphs.keys()), 'the order names other glyphs'
        for name in self.order:
            pen, self.parts[name] = TTGlyphPointPen(self.glyphs), Part()
            self.glyphs.readGlyph(name, self.parts[name], pen)
            self.outlines[name] = pen.glyph()

    def build(self):
        """The font that these sources make, from nothing but them."""
        made = fontBuilder.FontBuilder(self.info.unitsPerEm)
        made.setupGlyphOrder(self.order)
        made.setupCharacterMap({code: name for name in self.order
                                for code in getattr(self.parts[name], 'unicodes', ())})
        made.setupGlyf(self.outlines)
        made.setupHorizontalMetrics({name: (self.parts[name].width, made.font['glyf'][name].xMin if
                                            made.font['glyf'][name].numberOfContours else 0) for name in self.order})
        made.setupHorizontalHeader(ascent=self.info.openTypeHheaAscender, descent=self.info.openTypeHheaDescender)
        made.setupPost()
        return made.font


def points_of(font, name):
    """Contours of a glyph, references resolved: the coordinates and whether each is on the curve, contour by contour."""
    coordinates, ends, flags = font['glyf'][name].getCoordinates(font['glyf'])
    return [(x, y, flag & 1) for (x, y), flag in zip(coordinates, flags)], list(ends)


class Test(cli.Test):
    """Knows the directories too, and that nothing is left of a failure."""

    def files(self):
        made = {path: None for path in self.directory.rglob('*') if path.is_dir()}
        return made | super().files()

    def blend(self, output, *arguments, fonts=FONTS):
        curves = () if '--curves' in arguments else ('--curves', 'quadratic')
        self.assertEqual(self.made('blend', *fonts, '-q', '-o', output, *arguments, *curves), [])
        return self.path(output)


class Sources(Test):
    """What designers get is what the font has."""

    def make(self, characters):
        self.write('chars', characters)
        self.blend('x.ttf', '--chars', 'chars')
        self.blend('x.ufo', '--chars', 'chars')
        self.font, self.ufo = ttLib.TTFont(self.path('x.ttf')), Ufo(self.path('x.ufo'))

    def test_built_again_it_has_the_same_outlines(self):
        self.make('U+0020-007E U+00A8 U+00B4 é Ä Æ Ж Ω')
        built = self.ufo.build()
        built.save(self.path('built.ttf'))
        built = ttLib.TTFont(self.path('built.ttf'))
        self.assertEqual(len(built.getGlyphOrder()), len(self.font.getGlyphOrder()))
        drawn = 0
        for ours, theirs in zip(self.font.getGlyphOrder(), built.getGlyphOrder()):
            points, ends = points_of(self.font, ours)
            again, ends_again = points_of(built, theirs)
            self.assertEqual(ends, ends_again, ours)
            self.assertEqual([on for _, _, on in points], [on for _, _, on in again], ours)
            self.assertEqual([(p, q) for p, q in zip(points, again) if max(abs(p[0] - q[0]), abs(p[1] - q[1])) > 1], [])
            self.assertEqual(self.font['hmtx'][ours][0], built['hmtx'][theirs][0])
            drawn += len(ends) > 0
        self.assertGreater(drawn, 90)
        self.assertGreater(sum(glyph.isComposite() for glyph in self.ufo.outlines.values()), 0)
        number = {name: i for i, name in enumerate(self.font.getGlyphOrder())}
        again = {name: i for i, name in enumerate(built.getGlyphOrder())}
        self.assertEqual({code: number[name] for code, name in self.font.getBestCmap().items()},
                         {code: again[name] for code, name in built.getBestCmap().items()})

    def test_kerning_is_what_the_font_gives(self):
        """Each pair as GPOS has it, by HarfBuzz, and as the groups and pairs have it, by ufoLib's rules."""
        letters = 'AVTWLPoaevy.,-ГТАую'
        self.make(letters)
        name = {code: glyph for glyph in self.ufo.order for code in getattr(self.ufo.parts[glyph], 'unicodes', ())}
        advances, kerned = self.font['hmtx'].metrics, 0
        for left in letters:
            for right in letters:
                given = lookupKerningValue((name[ord(left)], name[ord(right)]), self.ufo.kerning, self.ufo.groups)
                shaped = harfbuzz.shape(self.path('x.ttf'), left + right)
                self.assertEqual(shaped[0][1] - advances[self.font.getBestCmap()[ord(left)]][0], given, left + right)
                kerned += given != 0
        self.assertGreater(kerned, 20)

    def test_points_without_a_corner_are_smooth(self):
        self.make('OE')
        smooth = {}
        for character in 'OE':
            pen = RecordingPointPen()
            self.ufo.glyphs.readGlyph(character, Part(), pen)
            points = [values for call, values, _ in pen.value if call == 'addPoint']
            smooth[character] = sum(is_smooth for _, _, is_smooth, *_ in points)
            self.assertFalse(any(is_smooth and kind is None for _, kind, is_smooth, *_ in points))
        self.assertGreaterEqual(smooth['O'], 8)
        self.assertEqual(smooth['E'], 0)

    def test_information_is_the_fonts(self):
        self.make('Rag')
        info, os2, hhea, names = self.ufo.info, self.font['OS/2'], self.font['hhea'], self.font['name']
        for ours, theirs in ((info.unitsPerEm, self.font['head'].unitsPerEm),
                             (info.openTypeHheaAscender, hhea.ascent), (info.openTypeHheaDescender, hhea.descent),
                             (info.openTypeHheaLineGap, hhea.lineGap),
                             (info.openTypeOS2TypoAscender, os2.sTypoAscender), (info.ascender, os2.sTypoAscender),
                             (info.openTypeOS2TypoDescender, os2.sTypoDescender), (info.descender, os2.sTypoDescender),
                             (info.openTypeOS2TypoLineGap, os2.sTypoLineGap),
                             (info.openTypeOS2WinAscent, os2.usWinAscent), (info.openTypeOS2WinDescent, os2.usWinDescent),
                             (info.xHeight, os2.sxHeight), (info.capHeight, os2.sCapHeight),
                             (info.openTypeOS2WeightClass, os2.usWeightClass), (info.openTypeOS2WidthClass, os2.usWidthClass),
                             (info.openTypeOS2SubscriptYSize, os2.ySubscriptYSize),
                             (info.openTypeOS2SuperscriptYOffset, os2.ySuperscriptYOffset),
                             (info.openTypeOS2StrikeoutSize, os2.yStrikeoutSize),
                             (info.openTypeOS2StrikeoutPosition, os2.yStrikeoutPosition),
                             (info.italicAngle, self.font['post'].italicAngle),
                             (info.postscriptUnderlinePosition, self.font['post'].underlinePosition),
                             (info.postscriptUnderlineThickness, self.font['post'].underlineThickness),
                             (info.copyright, names.getDebugName(0)), (info.familyName, names.getDebugName(16)),
                             (info.styleName, names.getDebugName(17)), (info.styleMapFamilyName, names.getDebugName(1)),
                             (info.styleMapStyleName, names.getDebugName(2).lower()),
                             (info.openTypeNameUniqueID, names.getDebugName(3)),
                             (info.postscriptFullName, names.getDebugName(4)),
                             (info.openTypeNameVersion, names.getDebugName(5)),
                             (info.postscriptFontName, names.getDebugName(6)),
                             (info.openTypeNameLicense, names.getDebugName(13))):
            self.assertEqual(ours, theirs)
        self.assertEqual((info.versionMajor, info.versionMinor), (1, 0))

    def test_same_files_for_any_number_of_threads(self):
        self.write('chars', 'U+0041-0055 é Ä')
        folders = []
        for name, jobs in (('1', 1), ('2', 2), ('again', 2), ('5', 5)):
            path = self.blend(name + '.ufo', '--chars', 'chars', '-j', jobs)
            folders.append({file.relative_to(path): file.read_bytes() for file in path.rglob('*') if file.is_file()})
        self.assertGreater(len(folders[0]), 25)
        for folder in folders[1:]:
            self.assertEqual(folders[0], folder)


class Curves(Test):
    """--curves"""

    def segments(self, path):
        """Of each glyph by its name, the segments: where each starts, its controls, its end. Quadratics are parted where they imply it."""
        glyphs, found = UFOReader(path).getGlyphSet(), {}
        for name in glyphs.keys():
            pen = DecomposingRecordingPen(glyphs)
            glyphs[name].draw(pen)
            found[name] = list(self.parted(pen.value))
        return found

    @staticmethod
    def parted(calls):
        last = None
        for call, points in calls:
            if call == 'qCurveTo':
                for control, end in decomposeQuadraticSegment(points):
                    yield [last, control, end]
                    last = end
            elif call == 'curveTo':
                yield [last, *points]
            elif call == 'lineTo':
                yield [last, *points]
            last = points[-1] if points else last

    @staticmethod
    def place(segment, t):
        points = segment
        while len(points) > 1:
            points = [tuple(a + (b - a) * t for a, b in zip(p, q)) for p, q in zip(points, points[1:])]
        return points[0]

    def test_cubic_ones_are_where_quadratic_ones_are(self):
        """Within the unit by which places are rounded."""
        cubic, quadratic = (self.segments(self.blend(f'{kind}.ufo', '--text', 'OBagS&8', '--curves', kind))
                            for kind in ('cubic', 'quadratic'))
        self.assertEqual(cubic.keys(), quadratic.keys())
        curved = 0
        for name in cubic:
            ours, theirs = cubic[name], quadratic[name]
            self.assertEqual(len(ours), len(theirs))
            for one, other in zip(ours, theirs):
                self.assertEqual(len(one), {2: 2, 3: 4}[len(other)])
                curved += len(one) == 4
                for t in (0, 0.25, 0.5, 0.75, 1):
                    away = max(abs(a - b) for a, b in zip(self.place(one, t), self.place(other, t)))
                    self.assertLessEqual(away, 1, name)
        self.assertGreater(curved, 40)

    def test_cubic_without_the_option(self):
        self.made('blend', *FONTS, '-q', '-o', 'x.ufo', '--text', 'O')
        self.assertIn('type="curve"', (self.path('x.ufo') / 'glyphs' / 'O_.glif').read_text())
        self.assertNotIn('qcurve', (self.path('x.ufo') / 'glyphs' / 'O_.glif').read_text())

    def test_fontmake_builds_it(self):
        """Without further options, both ways."""
        self.made('blend', *FONTS, '-q', '-o', 'x.ufo', '--text', 'AVATO')
        subprocess.run(['fontmake', '-u', 'x.ufo', '--output-dir', 'made'], cwd=self.directory, check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.made('blend', *FONTS, '-q', '-o', 'x.ttf', '--text', 'AVATO')
        wanted = [advance for _, advance, _, _ in harfbuzz.shape(self.path('x.ttf'), 'AVATAVTO')]
        for kind in ('ttf', 'otf'):
            made = [advance for _, advance, _, _ in harfbuzz.shape(self.path(f'made/x.{kind}'), 'AVATAVTO')]
            self.assertEqual(made, wanted)

    def test_usage(self):
        self.refused(2, 'blend', *FONTS, '--curves', 'round', '-o', 'x.ufo', says=['--curves round', 'cubic'])


class Sample(Test):
    """What the writer can say beyond what these fonts have."""

    def setUp(self):
        super().setUp()
        subprocess.run([SAMPLE, self.path('sample.ufo')], check=True)
        self.ufo = Ufo(self.path('sample.ufo'))

    def test_glyphs_of_a_font_without_names(self):
        self.assertEqual(self.ufo.order, ['.notdef', 'uni0041', 'uni006F', 'uni00E9', 'u1F600', 'glyph00005'])
        self.assertEqual(self.ufo.parts['u1F600'].unicodes, [0x1F600])

    def test_references(self):
        glyph = self.ufo.outlines[self.ufo.order[5]]
        self.assertEqual([(part.glyphName, part.x, part.y) for part in glyph.components],
                         [(self.ufo.order[1], 0, 0), (self.ufo.order[2], 30, -20)])

    def test_contour_without_points_on_the_curve(self):
        circle = self.ufo.outlines[self.ufo.order[2]]
        self.assertEqual(list(circle.flags), [0, 0, 0, 0])
        self.assertEqual(list(circle.coordinates), [(500, 0), (500, 501), (-7, 501), (-7, 0)])

    def test_vertical_metrics(self):
        for i, name in enumerate(self.ufo.order):
            self.assertEqual(self.ufo.parts[name].height, 1000 + i)
            self.assertEqual(self.ufo.parts[name].lib, {'public.verticalOrigin': 880 - i})
        self.assertEqual(self.ufo.info.openTypeVheaVertTypoDescender, -500)

    def test_variation_sequences(self):
        self.assertEqual(self.ufo.lib['public.unicodeVariationSequences'],
                         {'FE00': {'0041': self.ufo.order[5], '006F': self.ufo.order[2]}, 'E0100': {'006F': self.ufo.order[5]}})

    def test_kerning(self):
        _, a, o, e = self.ufo.order[:4]
        self.assertEqual(self.ufo.groups, {f'public.kern1.{a}': [a], f'public.kern1.{o}': [o, e],
                                           f'public.kern2.{o}': [o, e]})
        self.assertEqual(self.ufo.kerning, {(f'public.kern1.{a}', f'public.kern2.{o}'): -80,
                                            (f'public.kern1.{o}', f'public.kern2.{o}'): 7,
                                            (f'public.kern1.{o}', a): -40, (e, o): 11})

    def test_names(self):
        info = self.ufo.info
        self.assertEqual(info.copyright, '© & é < 形')
        self.assertEqual(info.familyName, 'Sample 形 𝔘')
        self.assertEqual((info.versionMajor, info.versionMinor), (1, 250))
        self.assertEqual((info.openTypeNameDesigner, info.trademark), ('D', 'T'))
        self.assertEqual((info.openTypeOS2FamilyClass, info.openTypeOS2Type), ([8, 5], [2]))
        self.assertEqual(info.italicAngle, -9.5)
        self.assertEqual(info.openTypeHeadCreated, '1999/01/24 05:20:00')


class FileNames(Test):
    """Glyph names become file names by the rules of UFO 3."""

    NAMES = ['A', 'a', 'a_', 'A_', '.notdef', '_notdef', '.', '..', '|', '_', 'a|b', 'a_b', 'con', 'CON', 'alt.con.x',
             'com1', 'com0', 'LPT9', 'T_h', 't_h', 'f_f_i.Alt', 'x' * 300, 'x' * 299 + 'y', 'X' * 300, 'a' * 240,
             'a' * 240 + '.glif', '"*+/:<>?[\\]()', 'uni4E00', 'uni4e00', 'a000000000000001', 'clock$', 'aux.', 'nul']

    def test_as_ufolib_has_them(self):
        result = subprocess.run([SAMPLE], input='\n'.join(self.NAMES) + '\n', stdout=subprocess.PIPE, check=True, text=True)
        made, existing = result.stdout.splitlines(), set()
        for name, file in zip(self.NAMES, made, strict=True):
            expected = userNameToFileName(name, existing=existing, suffix='.glif')
            self.assertEqual(file, expected, name)
            self.assertLessEqual(len(file), 255)
            existing.add(expected.lower())
        self.assertEqual(len(existing), len(self.NAMES))


class Places(Test):
    """Where a UFO goes, and what it takes the place of."""

    def test_several_places(self):
        self.blend('x.ufo', '--text', 'Ag', '--at', '0.25,0.5')
        self.assertEqual(sorted(path.name for path in self.directory.iterdir()), ['x-0.25.ufo', 'x-0.5.ufo'])
        widths = [Ufo(self.path(f'x-{t}.ufo')) for t in ('0.25', '0.5')]
        self.assertNotEqual(*(ufo.parts[ufo.order[1]].width for ufo in widths))

    def test_a_ufo_is_replaced(self):
        self.blend('x.ufo', '--text', 'Ag')
        before = self.files()
        self.write('x.ufo/glyphs/stray.glif', 'old')
        self.blend('x.UFO', '--text', 'Ag')
        self.blend('x.ufo', '--text', 'Ag')
        self.assertEqual({path: what for path, what in self.files().items() if 'x.UFO' not in path.parts}, before)

    def refuse(self, path, *arguments, code=1, says=()):
        self.refused(code, 'blend', *FONTS, '--text', 'Ag', '-o', path, *arguments, says=(path, *says))

    def test_nothing_else_is_replaced(self):
        self.path('folder.ufo').mkdir()
        self.write('folder.ufo/work', 'work')
        self.refuse('folder.ufo', says=['cannot be written'])
        self.path('empty.ufo').mkdir()
        self.refuse('empty.ufo', says=['cannot be written'])
        self.write('file.ufo', 'work')
        self.refuse('file.ufo', says=['cannot be written'])
        self.path('folder.woff2').mkdir()
        self.refuse('folder.woff2', says=['cannot be written'])

    def test_directory_that_takes_no_files(self):
        self.refuse('nowhere/x.ufo', says=['cannot be written'])
        closed = self.path('closed')
        closed.mkdir()
        closed.chmod(0o500)
        self.addCleanup(closed.chmod, 0o700)
        if os.access(closed, os.W_OK):
            closed = pathlib.Path('/proc/self') # where root cannot make files either
        self.refuse(f'{closed}/x.ufo', says=['cannot be written'])

    def test_one_of_several_in_the_way(self):
        self.path('x-0.75.ufo').mkdir()
        self.refused(1, 'blend', *FONTS, '--text', 'Ag', '--at', '0.25,0.75', '-o', 'x.ufo', says=['x-0.75.ufo'])

    def test_strict(self):
        cli.cut_font(self.path('blank.ttf'), 'AB', blank='B')
        before = self.files()
        result = self.run_program('blend', cli.SANS_BOLD, 'blank.ttf', '--text', 'AB', '--strict', '-o', 'x.ufo')
        self.assertEqual(result.returncode, 1)
        self.assertEqual(self.files(), before)


if __name__ == '__main__':
    cli.main()
