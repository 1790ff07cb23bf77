"""MATH of a blend: at both ends what each font has, half-way their mean, and along a variable font's axis what the blends have; the
formulas that Chromium sets with it grow their parentheses."""

import base64
import html
import subprocess

import browser
import cli
import harfbuzz
from fontTools import ttLib
from fontTools.misc.roundTools import otRound
from fontTools.ttLib.tables.DefaultTable import DefaultTable
from fontTools.varLib.varStore import VarStoreInstancer

TEX = cli.DEBIAN.parent / 'texmf/fonts/opentype/public'
LATIN_MODERN = TEX / 'lm-math/latinmodern-math.otf'
PAGELLA = TEX / 'tex-gyre-math/texgyrepagella-math.otf'
NEEDS = {'Chromium': browser.PROGRAMS}

UP, RIGHT = harfbuzz.Font.UP, harfbuzz.Font.RIGHT
LETTERS = '𝑓𝑥ΓA1'
GROW_UP, GROW_RIGHT = '(){[√∫|', '→\u0302\u23DE'
TEXT = LETTERS + '+⎝' + GROW_UP + GROW_RIGHT
PERCENTS = 0, 1, 55
AXIS_HEIGHT = 5
HEIGHTS = 2, 3 # constants without variations, with the percentages
SAID = 'morphotype: colour, bitmap and math tables are left out: MATH of '


class Source:
    """A font, and what HarfBuzz reads of its MATH, by characters and by names."""

    def __init__(self, path, place=None):
        self.tables = ttLib.TTFont(path)
        self.order, self.cmap = self.tables.getGlyphOrder(), self.tables.getBestCmap()
        self.hb = harfbuzz.Font(path, place)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.hb.__exit__()

    def glyph(self, character):
        return self.tables.getGlyphID(self.cmap[ord(character)])

    def italics(self, character):
        return self.hb.italics(self.glyph(character))

    def accent(self, character):
        return self.hb.accent(self.glyph(character))

    def variants(self, character, direction):
        """The measures of the glyph itself and of the larger ones, one after the other."""
        return [measure for _, measure in self.hb.variants(self.glyph(character), direction)]

    def parts(self, character, direction):
        return [part[1:] for part in self.hb.assembly(self.glyph(character), direction)[0]]

    def growing(self):
        """The characters that grow, and which way."""
        return [(character, direction) for text, direction in ((GROW_UP, UP), (GROW_RIGHT, RIGHT)) for character in text]


class Blended(cli.Test):
    PLACES = 0, 0.5, 1

    def setUp(self):
        super().setUp()
        self.made('blend', LATIN_MODERN, PAGELLA, '--text', TEXT, '-q', '-o', 'x.ttf', '--at', ','.join(map(str, self.PLACES)))

    def blend(self, place):
        return self.path(f'x-{place:g}.ttf')

    def assert_mixed(self, got, first, second, place, what):
        self.assertLessEqual(abs(got - ((1 - place) * first + place * second)), 0.5, (what, place))


class Places(Blended):
    """HarfBuzz reads both sources and the blends."""

    def each(self):
        """Both sources, and each blend with its place."""
        with Source(LATIN_MODERN) as a, Source(PAGELLA) as b:
            for place in self.PLACES:
                with Source(self.blend(place)) as x:
                    yield a, b, x, place

    def test_constants(self):
        differing = 0
        for a, b, x, place in self.each():
            for i, values in enumerate(zip(a.hb.constants(), b.hb.constants(), x.hb.constants())):
                self.assert_mixed(values[2], values[0], values[1], place, i)
                differing += values[0] != values[1]
            for direction in UP, RIGHT:
                self.assert_mixed(x.hb.overlap(direction), a.hb.overlap(direction), b.hb.overlap(direction), place, 'overlap')
        self.assertGreater(differing, 60)

    def test_corrections(self):
        corrected = 0
        for a, b, x, place in self.each():
            for character in LETTERS + '∫':
                self.assert_mixed(x.italics(character), a.italics(character), b.italics(character), place, character)
                self.assertLessEqual(abs(x.accent(character) - (1 - place) * a.accent(character) - place * b.accent(character)), 1)
                corrected += x.italics(character) > 0
            for character in TEXT:
                self.assertEqual(x.hb.extended(x.glyph(character)), a.hb.extended(a.glyph(character)), character)
        self.assertGreater(corrected, 6)

    def test_larger_glyphs(self):
        """As many as in the first font; those beyond the second font's stay as they are in the first."""
        for a, b, x, place in self.each():
            for character, direction in a.growing():
                first, second, got = (font.variants(character, direction) for font in (a, b, x))
                self.assertEqual(len(got), len(first))
                mixed = [(1 - place) * m + place * n for m, n in zip(first, second)] + first[len(second):]
                for measure, expected in zip(got, sorted(mixed)):
                    self.assertLessEqual(abs(measure - expected), 0.5, (character, place))

    def test_measures_are_those_of_the_glyphs(self):
        """Within what they are off in the sources, and the rounding of the outlines."""
        for place in self.PLACES:
            with Source(self.blend(place)) as x:
                for character in '(){[√':
                    for glyph, measure in x.hb.variants(x.glyph(character), UP):
                        drawn = x.tables['glyf'][x.order[glyph]]
                        self.assertLessEqual(abs(drawn.yMax - drawn.yMin - measure), 4, (x.order[glyph], place))

    def test_assemblies(self):
        parts = 0
        for a, b, x, place in self.each():
            for character, direction in a.growing():
                first, second, got = (font.parts(character, direction) for font in (a, b, x))
                self.assertEqual(len(got), len(first))
                if len(first) != len(second):
                    continue
                for one, other, part in zip(first, second, got):
                    self.assertEqual(part[3], one[3])
                    for k in range(3):
                        self.assert_mixed(part[k], one[k], other[k], place, character)
                    parts += 1
        self.assertGreater(parts, 40)

    def test_glyphs_are_kept_and_paired(self):
        """The second font's larger parentheses stand at T = 1 for the first font's; what stays is told."""
        said = self.made('blend', LATIN_MODERN, PAGELLA, '--text', '(', '-o', 'x.ttf', '--at', '1')
        stays = [line for line in said if 'not stay' in line or 'stays as in' in line]
        self.assertEqual(len(stays), 1, said)
        self.assertTrue(stays[0].endswith(': /parenleft.v7'), stays)
        with Source(PAGELLA) as b, Source(self.path('x.ttf')) as x:
            self.assertEqual(len(x.order), 1 + 8 + 3)
            for (glyph, _), (other, _) in list(zip(x.hb.variants(x.glyph('('), UP), b.hb.variants(b.glyph('('), UP))):
                drawn, wanted = x.tables['glyf'][x.order[glyph]], b.tables.getGlyphSet()[b.order[other]]
                self.assertLessEqual(abs(x.tables['hmtx'][x.order[glyph]][0] - wanted.width), 1)
                self.assertGreater(drawn.numberOfContours, 0)

    def test_pairs_without_names(self):
        """Larger glyphs go by their order, parts by their places, where the second font's glyphs have no names."""
        nameless = ttLib.TTFont(self.blend(1))
        nameless['post'].formatType = 3
        nameless.save(self.path('b.ttf'))
        said = self.made('blend', self.blend(0), self.path('b.ttf'), '--text', '()', '-o', 'y.ttf', '--at', '1')
        self.assertFalse([line for line in said if ' as in ' in line], said)
        with Source(self.blend(1)) as b, Source(self.path('y.ttf')) as y:
            for read in Source.variants, Source.parts:
                self.assertEqual(read(y, '(', UP), read(b, '(', UP))

    def test_the_sanitizer_and_fonttools_accept_it(self):
        for place in self.PLACES:
            subprocess.run(['ots-sanitize', self.blend(place)], check=True, stdout=subprocess.DEVNULL)
            self.assertEqual(ttLib.TTFont(self.blend(place))['MATH'].table.Version, 0x00010000)


class Deltas:
    """MATH's values in a variable font at a place (0 … 1) of its axis, as fontTools reads them: HarfBuzz 6 leaves them at the default."""

    def __init__(self, path, place):
        self.font = ttLib.TTFont(path)
        self.store = VarStoreInstancer(self.font['GDEF'].table.VarStore, self.font['fvar'].axes, {'MORF': place}) # normalized
        self.math = self.font['MATH'].table

    def value(self, record):
        device = record.DeviceTable
        delta = self.store[device.StartSize << 16 | device.EndSize] if device else 0 # the outer and the inner index
        return record.Value + otRound(delta)

    def constants(self):
        values = [getattr(self.math.MathConstants, converter.name) for converter in self.math.MathConstants.getConverters()]
        return [self.value(value) if hasattr(value, 'Value') else value for value in values]

    def of_glyphs(self, table, coverage, records):
        if not table:
            return {}
        return {glyph: self.value(record) for glyph, record in zip(getattr(table, coverage).glyphs, getattr(table, records))}

    def italics(self):
        return self.of_glyphs(self.math.MathGlyphInfo.MathItalicsCorrectionInfo, 'Coverage', 'ItalicsCorrection')

    def accents(self):
        return self.of_glyphs(self.math.MathGlyphInfo.MathTopAccentAttachment, 'TopAccentCoverage', 'TopAccentAttachment')


class Varying(Blended):
    PLACES = 0, 0.25, 0.5, 1

    def test_values_are_those_of_the_blends(self):
        self.made('variable', LATIN_MODERN, PAGELLA, '--text', TEXT, '-q', '-o', 'v.ttf')
        subprocess.run(['ots-sanitize', self.path('v.ttf')], check=True, stdout=subprocess.DEVNULL)
        moved = 0
        for place in self.PLACES:
            within = 0 if place in (0, 1) else 1
            varied = Deltas(self.path('v.ttf'), place)
            with Source(self.blend(place)) as x, Source(self.blend(0)) as first:
                for i, (got, wanted, fixed) in enumerate(zip(varied.constants(), x.hb.constants(), first.hb.constants())):
                    plain = i in PERCENTS + HEIGHTS
                    self.assertLessEqual(abs(got - (fixed if plain else wanted)), 0 if plain else within, (i, place))
                    moved += got != fixed
                for values, read in (varied.italics(), x.hb.italics), (varied.accents(), x.hb.accent):
                    self.assertGreater(len(values), 4)
                    for name, got in values.items():
                        if name in x.order: # not what stays as it is in the variable font alone
                            self.assertLessEqual(abs(got - read(x.order.index(name))), within, (name, place))
        self.assertGreater(moved, 60)

    def test_parts_join_at_every_place(self):
        """Parts that are of other lengths in the second font stay as in the first; a character that leads to one does not."""
        self.made('variable', LATIN_MODERN, PAGELLA, '--text', TEXT, '-q', '-o', 'v.ttf')
        with Source(self.path('v.ttf')) as v:
            gvar, parts = v.tables['gvar'].variations, v.hb.assembly(v.glyph('('), UP)[0]
            self.assertEqual(len(parts), 3)
            for glyph, *_ in parts:
                self.assertEqual(gvar.get(v.order[glyph], []), [])
            self.assertNotIn(v.glyph('⎝'), [glyph for glyph, *_ in parts])
            self.assertNotEqual(gvar[v.order[v.glyph('⎝')]], [])

    def test_parts_of_one_length_vary(self):
        """Of a font and one that differs from it in width alone."""
        narrow = ttLib.TTFont(self.blend(0))
        for name in 'uni239B', 'uni239C', 'uni239D':
            glyph = narrow['glyf'][name]
            glyph.coordinates.scale((0.5, 1))
            glyph.recalcBounds(narrow['glyf'])
        narrow.save(self.path('narrow.ttf'))
        self.made('variable', self.blend(0), self.path('narrow.ttf'), '-q', '-o', 'v.ttf')
        with Source(self.path('v.ttf')) as v:
            for glyph, *_ in v.hb.assembly(v.glyph('('), UP)[0]:
                self.assertNotEqual(v.tables['gvar'].variations.get(v.order[glyph], []), [])


class Sources(Blended):
    PLACES = (0,)

    def setUp(self):
        super().setUp()
        self.path('x.ttf').rename(self.path('x-0.ttf'))

    def with_table(self, name, data):
        font = ttLib.TTFont(self.blend(0))
        table = DefaultTable('MATH')
        table.data = bytes(data)
        font['MATH'] = table
        font.save(self.path(name))
        return self.path(name)

    def table(self):
        return bytearray(ttLib.TTFont(self.blend(0)).getTableData('MATH'))

    def damaged(self):
        """Tables that are cut short, or lead out of themselves."""
        whole = self.table()
        for length in 1, 9, 40, 300, len(whole) - 3:
            yield whole[:length]
        for at, value in ((0, 2), (4, 0xFFFF), (6, 0xFFF0), (8, len(whole))): # version, offsets of the three tables
            yield whole[:at] + value.to_bytes(2, 'big') + whole[at + 2:]
        variants = int.from_bytes(whole[8:10], 'big')
        for at in 2, 6, 8, 10: # the coverage, both counts, the first construction
            yield whole[:variants + at] + b'\xff\xfe' + whole[variants + at + 2:]

    def test_a_damaged_table_is_left_out(self):
        for data in self.damaged():
            font = self.with_table('a.ttf', data)
            said = self.made('blend', font, PAGELLA, '--text', '(A', '-o', 'y.ttf')
            self.assertIn(f'{SAID}{font}; MATH of {PAGELLA}; MATH of {font} is damaged', said)
            self.assertNotIn('MATH', ttLib.TTFont(self.path('y.ttf')))

    def test_a_damaged_table_of_the_second_font(self):
        font = self.with_table('b.ttf', self.table()[:300])
        said = self.made('blend', self.blend(0), font, '-o', 'y.ttf', '--at', '1')
        self.assertIn(f'{SAID}{font}; MATH of {font} is damaged', said)
        with Source(self.blend(0)) as a, Source(self.path('y.ttf')) as y:
            self.assertEqual(a.hb.constants(), y.hb.constants())

    def test_only_the_first_has_one(self):
        self.made('blend', self.blend(0), cli.SANS_BOLD, '-q', '-o', 'y.ttf', '--at', '0.5')
        with Source(self.blend(0)) as a, Source(self.path('y.ttf')) as y:
            scale = y.tables['head'].unitsPerEm / a.tables['head'].unitsPerEm
            self.assertGreater(scale, 1)
            for i, (got, own) in enumerate(zip(y.hb.constants(), a.hb.constants())):
                self.assertLessEqual(abs(got - own * (1 if i in PERCENTS else scale)), 0.5, i)
            self.assertLessEqual(abs(y.italics('Γ') - scale * a.italics('Γ')), 0.5)

    def test_only_the_second_has_one(self):
        said = self.made('blend', cli.SANS_BOLD, PAGELLA, '--text', '(A', '-o', 'y.ttf')
        self.assertIn(f'{SAID}{PAGELLA}', said)
        self.assertNotIn('MATH', ttLib.TTFont(self.path('y.ttf')))

    def test_both_have_one(self):
        said = self.made('blend', self.blend(0), PAGELLA, '--text', '(A', '-o', 'y.ttf')
        self.assertFalse([line for line in said if 'MATH' in line], said)


class Chromium(Blended):
    """Formulas in MathML (https://www.w3.org/TR/mathml-core/, "Layout of operators")."""

    SIZE = 24
    HEIGHTS = 0.8, 1.6, 2.3, 4, 6 # of what stands between the parentheses, em

    def setUp(self):
        super().setUp()
        plain = ttLib.TTFont(self.blend(0.5))
        del plain['MATH']
        plain.save(self.path('plain.ttf'))
        self.browser = browser.Browser(self.directory, 1600, 1200)
        self.addCleanup(self.browser.close)

    def face(self, path):
        data = base64.b64encode(path.read_bytes()).decode()
        return f'@font-face {{ font-family: Formulas; src: url(data:font/ttf;base64,{data}) }}'

    def page(self, path, inner):
        """Formulas of a fraction or a space between parentheses, each set with the font alone."""
        formulas = ''.join(f'<p><math displaystyle="true"><mrow><mo>(</mo>{text}<mo>)</mo></mrow></math></p>' for text in inner)
        page = self.write('page.html', f'''<!DOCTYPE html><html><head><meta charset="utf-8"><title>{html.escape(path.name)}</title>
            <style>{self.face(path)} body {{ margin: 0; background: #fff; color: #000 }}
            p {{ margin: 20px; display: inline-block; padding: 20px }}
            math {{ font-family: Formulas; font-size: {self.SIZE}px }}</style></head><body>{formulas}</body></html>''')
        self.browser.open(page.as_uri())
        self.assertEqual(self.browser.run(f'return document.fonts.load("{self.SIZE}px Formulas", "(").then(faces => faces.length)'), 1)
        return self.browser.run('''return [...document.querySelectorAll("p")].map(
            p => [...p.querySelectorAll("mo")].map(mo => mo.getBoundingClientRect().height))''')

    def spaces(self, path):
        """As far up as down from the font's axis, to which operators keep."""
        with Source(path) as font:
            axis = font.hb.constants()[AXIS_HEIGHT] / font.tables['head'].unitsPerEm
        return [f'<mspace width="1em" height="{height / 2 + axis}em" depth="{height / 2 - axis}em"/>' for height in self.HEIGHTS]

    def drawn(self, count):
        """The heights of the ink of each formula."""
        heights = []
        for i in range(1, count + 1):
            path = self.write('x.png', self.browser.screenshot(f'p:nth-of-type({i})'))
            *_, top, bottom = cli.Image(path).box()
            heights.append(bottom - top)
        return heights

    def test_parentheses_grow(self):
        """By the larger glyphs, and beyond them by parts; without MATH they do not."""
        for path in LATIN_MODERN, self.blend(0), self.blend(0.5), self.blend(1):
            boxes = self.page(path, self.spaces(path))
            with Source(path) as font:
                scale = self.SIZE / font.tables['head'].unitsPerEm
                measures = [measure * scale for measure in font.variants('(', UP)]
            inked = self.drawn(len(boxes))
            for wanted, (left, right), ink in zip(self.HEIGHTS, boxes, inked):
                self.assertEqual(left, right)
                self.assertLessEqual(abs(ink - left), 4, (path, wanted))
                if measures[-1] > wanted * self.SIZE:
                    nearest = next(measure for measure in measures if measure >= wanted * self.SIZE)
                    self.assertLessEqual(abs(left - nearest), 2, (path, wanted))
                else:
                    self.assertGreaterEqual(left, wanted * self.SIZE - 2)
            self.assertEqual(sorted({left for left, _ in boxes}), [left for left, _ in boxes])
        plain = self.page(self.path('plain.ttf'), self.spaces(self.blend(0.5)))
        self.assertEqual(len({left for left, _ in plain}), 1)

    def test_a_tall_fraction(self):
        """Its numerator is a fraction again: the parentheses are about as tall as in the first font."""
        inner = '<mn>1</mn>', '<mfrac><mn>1</mn><mi>A</mi></mfrac>', '<mfrac><mfrac><mn>1</mn><mi>A</mi></mfrac><mfrac><mn>1</mn><mi>A</mi></mfrac></mfrac>'
        first, half = (self.page(path, inner) for path in (LATIN_MODERN, self.blend(0.5)))
        for boxes in first, half:
            self.assertGreater(boxes[1][0], 1.3 * boxes[0][0])
            self.assertGreater(boxes[2][0], boxes[1][0])
        for one, other in zip(first, half):
            self.assertLess(abs(one[0] / other[0] - 1), 0.25)
        plain = self.page(self.path('plain.ttf'), inner)
        self.assertEqual(len({left for left, _ in plain}), 1)


if __name__ == '__main__':
    import sys
    cli.main(NEEDS.get(sys.argv[-1], ['ots-sanitize']))
