"""Which glyphs a blend has: --glyphs, the forms that substitutions make of the characters, and their names."""

import subprocess

import cli
from fontTools import ttLib

SANS = cli.DEBIAN / 'truetype/dejavu/DejaVuSans.ttf'
ROMAN = cli.DEBIAN / 'opentype/urw-base35/C059-Roman.otf'
ARABIC = 'سلام fil affix'


def systems(font):
    """The language systems of GSUB and the features of each."""
    table = font['GSUB'].table
    tags = [record.FeatureTag for record in table.FeatureList.FeatureRecord]
    found = {}
    for script in table.ScriptList.ScriptRecord:
        languages = [(record.LangSysTag, record.LangSys) for record in script.Script.LangSysRecord]
        for name, system in [('dflt', script.Script.DefaultLangSys)] + languages:
            found[script.ScriptTag, name] = {tags[i] for i in system.FeatureIndex} if system else set()
    return found


def expand(font):
    """Reads all of the font."""
    for tag in font.keys():
        if tag != 'GlyphOrder':
            font[tag].ensureDecompiled() if hasattr(font[tag], 'ensureDecompiled') else font[tag]
    for glyph in font.getGlyphOrder():
        font['glyf'][glyph].expand(font['glyf'])


class Forms(cli.Test):
    """Substitutions of the first font, of what both fonts have."""

    def setUp(self):
        super().setUp()
        self.made('blend', SANS, cli.SANS_BOLD, '--text', ARABIC, '-o', 'x.ttf')
        self.font = ttLib.TTFont(self.path('x.ttf'), lazy=False)

    def test_accepted(self):
        expand(self.font)
        subprocess.run(['ots-sanitize', self.path('x.ttf')], check=True, stdout=subprocess.DEVNULL)

    def test_forms(self):
        self.assertLessEqual({'fi', 'fl', 'uniFB00', 'uniFB03', 'uniFEB3', 'uniFEB4', 'uniFEE2', 'uniFEFB'},
                             set(self.font.getGlyphOrder()))
        self.assertLess(len(self.font.getGlyphOrder()), 60)

    def test_systems_are_kept(self):
        new, old = systems(self.font), systems(ttLib.TTFont(SANS))
        for name in (('arab', 'dflt'), ('latn', 'dflt')):
            self.assertTrue(new[name])
            self.assertLessEqual(new[name], old[name])
        self.assertLessEqual({'init', 'medi', 'fina', 'rlig'}, new['arab', 'dflt'])

    def test_order_and_names(self):
        order = ttLib.TTFont(SANS).getGlyphOrder()
        self.assertEqual(self.font['post'].formatType, 2)
        names = self.font.getGlyphOrder()
        self.assertEqual(names, sorted(names, key=order.index))

    def test_classes(self):
        classes, old = (font['GDEF'].table.GlyphClassDef.classDefs for font in (self.font, ttLib.TTFont(SANS)))
        self.assertTrue(classes)
        self.assertEqual({name: old[name] for name in classes}, classes)


class First(cli.Test):
    """--glyphs first: what the second font lacks stays as the first has it."""

    def test_one_character(self):
        said = self.made('blend', ROMAN, cli.SERIF, '--glyphs', 'first', '--text', 'm℅', '--at', '0.25,1', '-o', 'x.ttf')
        self.assertIn(f'morphotype: 1 glyph that {cli.SERIF} has not stays as in {ROMAN}: “℅” (U+2105)', said)
        original = ttLib.TTFont(ROMAN)
        for t in ('0.25', '1'):
            font = ttLib.TTFont(self.path(f'x-{t}.ttf'))
            name = font.getBestCmap()[0x2105]
            scale = font['head'].unitsPerEm / original['head'].unitsPerEm
            own = original['hmtx'][original.getBestCmap()[0x2105]][0]
            self.assertAlmostEqual(font['hmtx'][name][0], own * scale, delta=0.5)
            self.assertGreater(font['glyf'][name].numberOfContours, 2)
            self.assertGreater(abs(font['hmtx']['m'][0] - original['hmtx']['m'][0] * scale), 1)

    def test_both_wants_both(self):
        self.refused(1, 'blend', ROMAN, cli.SERIF, '--glyphs', 'both', '--text', 'A℅', '-o', 'x.ttf', says=['U+2105'])

    def test_characters_that_the_first_lacks(self):
        chars = self.write('chars', 'A ℅ U+4E00')
        said = self.made('blend', ROMAN, cli.SERIF, '--glyphs=first', '--chars', chars, '-o', 'x.ttf')
        self.assertEqual(said[0], f'morphotype: 1 character not in {ROMAN}, left out: U+4E00')
        self.assertEqual(set(ttLib.TTFont(self.path('x.ttf')).getBestCmap()), {0x41, 0x2105})
        self.refused(1, 'blend', ROMAN, cli.SERIF, '--glyphs=first', '--chars', self.write('none', 'U+4E00'), '-o', 'y.ttf',
                     says=[ROMAN])

    def test_whole_font(self):
        cli.cut_font(self.path('few.ttf'), 'ABCfilx')
        said = self.made('blend', 'few.ttf', cli.DEMO_SANS, '--glyphs', 'first', '-o', 'x.ttf')
        order = ttLib.TTFont(self.path('few.ttf')).getGlyphOrder()
        self.assertEqual(ttLib.TTFont(self.path('x.ttf')).getGlyphOrder(), order)
        self.assertTrue(any('kept as they are' in line for line in said), said)
        self.assertTrue(any('stay' in line and 'few.ttf' in line for line in said), said)
        self.assertEqual(self.made('blend', 'few.ttf', cli.DEMO_SANS, '--glyphs', 'first', '-q', '-o', 'x.ttf'), [])

    def test_usage(self):
        self.refused(2, 'blend', ROMAN, cli.SERIF, '--glyphs', 'second', '-o', 'x.ttf', says=['--glyphs'])
        self.refused(2, 'strip', ROMAN, cli.SERIF, '--glyphs', 'first', '--text', 'A', '-o', 'x.png', says=['--glyphs'])


class Sequences(cli.Test):
    """Variation sequences: cmap's format 14."""

    SANS, SERIF = (cli.DEBIAN / f'opentype/noto/Noto{name}.ttc' for name in ('SansCJK-Bold', 'SerifCJK-Regular'))

    def test_of_both_fonts(self):
        said = self.made('blend', self.SANS, self.SERIF, '--text', '、辻葛飾一A', '--alternates', '-o', 'x.ttf')
        self.assertEqual(said, [])
        font, original = ttLib.TTFont(self.path('x.ttf')), ttLib.TTFont(self.SANS, fontNumber=0, lazy=True)
        new, old = (next(table for table in source['cmap'].tables if table.format == 14).uvsDict for source in (font, original))
        wanted = {(selector, code): glyph is None for selector, pairs in old.items() for code, glyph in pairs
                  if chr(code) in '、辻葛飾一A'}
        self.assertEqual({(selector, code): glyph is None for selector, pairs in new.items() for code, glyph in pairs}, wanted)
        self.assertEqual(set(wanted.values()), {True, False})
        subprocess.run(['ots-sanitize', self.path('x.ttf')], check=True, stdout=subprocess.DEVNULL)

    def test_of_one_font(self):
        for glyphs, varied in (('both', False), ('first', True)):
            self.made('blend', self.SANS, cli.UKAI, '--text', '葛', '--glyphs', glyphs, '-q', '-o', 'x.ttf')
            tables = ttLib.TTFont(self.path('x.ttf'))['cmap'].tables
            self.assertEqual(any(table.format == 14 for table in tables), varied)
            subprocess.run(['ots-sanitize', self.path('x.ttf')], check=True, stdout=subprocess.DEVNULL)


if __name__ == '__main__':
    cli.main()
