"""UFOs and masters as editors' tools take them: fontmake makes fonts of them that set text as blends do."""

import os
import pathlib
import re
import shutil
import subprocess
import unittest

import cli
import harfbuzz
from fontTools import fontBuilder, ttLib
from fontTools.designspaceLib import DesignSpaceDocument
from fontTools.feaLib import builder
from fontTools.pens.ttGlyphPen import TTGlyphPen
from fontTools.varLib import interpolatable

TRUETYPE = pathlib.Path('/usr/share/fonts/truetype')
OPENTYPE = pathlib.Path('/usr/share/fonts/opentype')
DEJAVU = TRUETYPE / 'dejavu/DejaVuSans.ttf'
PLACES = ('0', '0.25', '0.5', '0.75', '1')
MARKS = '\u0300\u0301\u0302\u0323'


def shape(path, word, place=None):
    with harfbuzz.Font(path, place) as font:
        return font.shape(word)


class Sources(cli.Test):
    """Two fonts, the characters and the words that are compared."""

    FONTS, CHARACTERS, WORDS = None, '', ()
    UFO_FORMATS = ('ttf', 'otf')
    IN_CONTEXT = () # words kerned by a context: fontmake gives the features of static instances as the first master has them

    def setUp(self):
        super().setUp()
        if not all(pathlib.Path(font).exists() for font in self.FONTS) or not shutil.which('fontmake'):
            if 'MORPHOTYPE_FONTS_REQUIRED' in os.environ:
                self.fail('fonts or fontmake are missing')
            self.skipTest('fonts or fontmake are missing')
        self.write('chars', self.CHARACTERS)

    def make(self, command, output, *arguments):
        self.assertEqual(self.made(command, *self.FONTS, '--chars', 'chars', '-q', '-o', output, *arguments), [])

    def fontmake(self, *arguments):
        made = subprocess.run(['fontmake', *arguments], cwd=self.directory, capture_output=True, text=True)
        self.assertEqual(made.returncode, 0, made.stderr[-2000:])

    def compare(self, ours, theirs, place=None, most=1, without=()):
        """The same glyphs for all words but those of `without`, each number of them within `most` units."""
        moved = 0
        for word in (word for word in self.WORDS if word not in without):
            expected, got = shape(self.path(ours), word), shape(self.path(theirs), word, place)
            self.assertEqual([glyph for glyph, *_ in expected], [glyph for glyph, *_ in got], word)
            for one, other in zip(expected, got):
                for number, again in zip(one[1:], other[1:]):
                    self.assertLessEqual(abs(number - again), most, f'{theirs} {place} {word}: {expected} {got}')
                moved += any(one[2:])
        return moved

    def check_ufo(self):
        self.make('blend', 'x.ttf', '--at', '0.4')
        self.make('blend', 'x.ufo', '--at', '0.4')
        self.fontmake('-u', 'x.ufo', '-o', *self.UFO_FORMATS, '--output-dir', 'made')
        made = sorted(self.directory.joinpath('made').iterdir())
        self.assertEqual(len(made), len(self.UFO_FORMATS))
        return [self.compare('x.ttf', file) for file in made]

    def check_masters(self):
        """Both numbers that an advance or an offset is made of are rounded in instances, so that 2 units may be between."""
        self.make('variable', 'v.designspace')
        document = DesignSpaceDocument.fromfile(self.path('v.designspace'))
        self.assertFalse(interpolatable.main([source.path for source in document.sources]))
        self.make('blend', 'x.ttf', '--at', ','.join(PLACES))
        self.fontmake('-m', 'v.designspace', '-o', 'variable', '--output-path', 'variable.ttf')
        self.fontmake('-m', 'v.designspace', '-i', '-o', 'ttf', '--output-dir', 'instances-made')
        instances = {re.search(r'(\d+)\.ttf', file.name)[1]: file
                     for file in self.directory.joinpath('instances-made').iterdir()}
        for place in PLACES:
            value = round(100 * float(place))
            self.compare(f'x-{place}.ttf', 'variable.ttf', value, most=1 if place in '01' else 2)
            self.compare(f'x-{place}.ttf', instances[str(value)], most=2, without=self.IN_CONTEXT)


class Latin(Sources):
    FONTS = (DEJAVU, TRUETYPE / 'dejavu/DejaVuSerif.ttf')
    CHARACTERS = 'AVTWLPoaeyfilcnéàüẤ.,-' + MARKS
    WORDS = ('AVATA', 'WoToLT', 'ffi', 'fl', 'fi', 'P,', 'e\u0301', 'o\u0323\u0302', 'A\u0302\u0301V', 'T\u0323o')

    def test_a_ufo_sets_text_as_its_blend(self):
        self.check_ufo()

    def test_masters_and_instances_do(self):
        self.check_masters()


class Cff(Sources):
    FONTS = (OPENTYPE / 'urw-base35/NimbusRoman-Regular.otf', DEJAVU)
    CHARACTERS = 'AVTWLPoaeyfilcnéà.,-'
    WORDS = ('AVATA', 'WoTo', 'fi', 'fl', 'P,', 'Ta', 'éàV')

    def test_a_ufo_sets_text_as_its_blend(self):
        self.check_ufo()

    def test_masters_and_instances_do(self):
        self.check_masters()


class Thai(Sources):
    FONTS = (TRUETYPE / 'tlwg/Garuda.ttf', TRUETYPE / 'tlwg/Norasi.ttf')
    CHARACTERS = 'กขคญฐตนปพฟมรลวสหอะาำิีึืฺุู็่้๊๋์'
    WORDS = ('ที่นี่'.replace('ท', 'ต'), 'น้ำ', 'ปั่น'.replace('ั', 'ิ'), 'ญู', 'ก็', 'กู้', 'พี่', 'ปู่', 'ฐุ')

    def test_a_ufo_sets_text_as_its_blend(self):
        self.assertGreater(min(self.check_ufo()), 8)

    def test_masters_and_instances_do(self):
        self.check_masters()


class Arabic(Sources):
    FONTS = (TRUETYPE / 'noto/NotoNaskhArabic-Regular.ttf', TRUETYPE / 'noto/NotoSansArabic-Regular.ttf')
    CHARACTERS = 'ابتثجحدرسشصعفقكلمنهويىةءأإآؤئلا' + '\u064b\u064d\u064e\u064f\u0650\u0651\u0652'
    WORDS = ('سلام', 'بَيْت', 'مُحَمَّد', 'كِتاب', 'الإسلام', 'شَمْسً', 'رؤية', 'لا', 'لأ', 'ورد', 'ثُمَّ', 'قلبٍ')
    IN_CONTEXT = ('ورد',)

    def test_a_ufo_sets_text_as_its_blend(self):
        self.assertGreater(min(self.check_ufo()), 8)

    def test_masters_and_instances_do(self):
        self.check_masters()


class Editor(Sources):
    FONTS, CHARACTERS = Latin.FONTS, Latin.CHARACTERS

    def test_fontforge_opens_it_and_makes_a_font(self):
        if not shutil.which('fontforge'):
            self.skipTest('fontforge is missing')
        self.make('blend', 'x.ufo')
        self.write('open.py', "import fontforge\nfont = fontforge.open('x.ufo')\nfont.generate('x.otf')\n")
        made = subprocess.run(['fontforge', '-lang=py', '-script', 'open.py'], cwd=self.directory,
                              capture_output=True, text=True)
        self.assertEqual(made.returncode, 0, made.stderr)
        self.assertNotRegex(made.stderr.casefold(), 'error|warning|unrecognized|unexpected|traceback')
        font = ttLib.TTFont(self.path('x.otf'))
        self.assertIn('GSUB', font)
        self.assertEqual(len(shape(self.path('x.otf'), 'fi')), 1)


class Names(cli.Test):
    """Names that feature files cannot have, or have as words."""

    def font(self, file, features, names):
        made = fontBuilder.FontBuilder(1000)
        made.setupGlyphOrder(['.notdef', *names])
        made.setupCharacterMap({0x41 + i: name for i, name in enumerate(names)})
        pen = TTGlyphPen(None)
        pen.moveTo((0, 0))
        pen.lineTo((0, 500))
        pen.lineTo((500, 500))
        pen.lineTo((500, 0))
        pen.closePath()
        glyph = pen.glyph()
        made.setupGlyf({name: glyph for name in ['.notdef', *names]})
        made.setupHorizontalMetrics({name: (600, 0) for name in ['.notdef', *names]})
        made.setupHorizontalHeader(ascent=800, descent=-200)
        made.setupNameTable({'familyName': 'Odd', 'styleName': file})
        made.setupOS2()
        made.setupPost()
        builder.addOpenTypeFeaturesFromString(made.font, features)
        made.save(self.path(file))

    def test_words_are_told_from_names_and_odd_names_are_changed(self):
        names = ['sub', 'a-b', 'mark', 'x*y', 'plain', 'a_b']
        features = """
            lookup ONE { sub \\sub by \\mark; } ONE;
            feature liga { sub \\mark plain by a_b; } liga;
            feature calt { sub plain \\sub' lookup ONE plain; ignore sub a_b plain'; } calt;
            feature ccmp { sub a_b by plain plain; rsub plain [\\mark]' by a_b; } ccmp;
            feature salt { sub plain from [\\sub \\mark]; } salt;"""
        for file in ('a.ttf', 'b.ttf'):
            self.font(file, features, names)
        for output in ('x.ufo', 'x.ttf'):
            self.assertEqual(self.made('blend', 'a.ttf', 'b.ttf', '-q', '-o', output), [])
        text = self.directory.joinpath('x.ufo', 'features.fea').read_text()
        self.assertIn('\\sub', text)
        lib = self.directory.joinpath('x.ufo', 'lib.plist').read_text()
        self.assertIn('public.postscriptNames', lib)
        self.assertIn('<key>a_b.2</key>', lib)
        self.assertIn('<key>x_y</key>', lib)
        if not shutil.which('fontmake'):
            return
        subprocess.run(['fontmake', '-u', 'x.ufo', '-o', 'ttf', '--output-path', 'made.ttf'], cwd=self.directory,
                       check=True, capture_output=True)
        for word in ('A', 'CE', 'EAE', 'F', 'EC', 'FE', 'BD'):
            self.assertEqual(shape(self.path('made.ttf'), word), shape(self.path('x.ttf'), word), word)

    def test_what_text_has_no_words_for_is_counted(self):
        """A feature's tag with a space in front, as old fonts have it for what is always applied."""
        for file in ('a.ttf', 'b.ttf'):
            self.font(file, 'feature ccmp { sub plain by other; } ccmp;', ['plain', 'other'])
            with ttLib.TTFont(self.path(file), lazy=False) as font:
                font['GSUB'].table.FeatureList.FeatureRecord[0].FeatureTag = ' RQD'
                font.save(self.path(file))
        for command, output in (('blend', 'x.ufo'), ('variable', 'x.designspace')):
            lines = self.made(command, 'a.ttf', 'b.ttf', '-o', output)
            self.assertEqual([line for line in lines if 'features.fea' in line],
                             [f'morphotype: {output}: features.fea has no words for 1 rule, lookup or feature of the layout, '
                              'and leaves it out'])
            self.assertEqual(self.made(command, 'a.ttf', 'b.ttf', '-q', '-o', output), [])
        text = self.directory.joinpath('x.ufo', 'features.fea').read_text()
        self.assertRegex(text.splitlines()[0], '^# Left out, .*: 1 rules, lookups or features$')


if __name__ == '__main__':
    unittest.main()
