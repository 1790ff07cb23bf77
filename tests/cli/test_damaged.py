"""Damaged fonts: a clean exit, and what is written is taken by the OpenType sanitizer. MT_DAMAGED tries more of them."""

import os
import struct
import subprocess

import cli
import damaged_fonts
from fontTools.feaLib.builder import addOpenTypeFeaturesFromString
from fontTools.ttLib import TTFont

FONTS = int(os.environ.get('MT_DAMAGED', 24))
CORPUS = cli.SOURCE / 'tests/fuzz/corpus/fonts'


class Damaged(cli.Test):
    def blend(self, name, font, *options):
        """Blends the bytes of a font with one that is whole; its exit code."""
        self.path(name).write_bytes(font)
        self.path('x.ttf').unlink(missing_ok=True)
        result = self.run_program('blend', name, cli.SERIF, '--text', 'aein', '-j', '1', '--effort', '0.1', '-o', 'x.ttf',
                                  *options)
        self.assertIn(result.returncode, (0, 1), result.stderr.decode())
        self.assertEqual(self.path('x.ttf').exists(), result.returncode == 0)
        if result.returncode == 0:
            subprocess.run(['ots-sanitize', self.path('x.ttf')], check=True, stdout=subprocess.DEVNULL)
        return result.returncode

    def changed(self, font, table, find):
        """The font with a number of 16 bits in a table changed: find(table) gives (at, number)."""
        offset, length = next(t[1:] for t in damaged_fonts.tables_of(font) if t[0] == table)
        at, number = find(font[offset:offset + length])
        return font[:offset + at] + struct.pack('>H', number) + font[offset + at + 2:]

    def test_class_that_there_is_not(self):
        def first_class(gdef):
            classes, = struct.unpack('>H', gdef[4:6])
            self.assertEqual(struct.unpack('>H', gdef[classes:classes + 2]), (1,))
            return classes + 6, 10
        font = self.changed((CORPUS / 'layout.ttf').read_bytes(), 'GDEF', first_class)
        self.assertEqual(self.blend('class.ttf', font, '--at', '0'), 0)

    def test_languages_out_of_order(self):
        font = TTFont(CORPUS / 'plain.ttf')
        addOpenTypeFeaturesFromString(font, """
            languagesystem DFLT dflt; languagesystem latn dflt;
            feature liga { script latn; language DEU; sub a e by i; language TRK; sub a e by n; } liga;
        """)
        font.save(self.path('languages.ttf'))
        def first_language(gsub):
            at = gsub.index(b'DEU ')
            self.assertLess(at, gsub.index(b'TRK '))
            return at, ord('Z') << 8 | ord('Z')
        font = self.changed(self.path('languages.ttf').read_bytes(), 'GSUB', first_language)
        self.assertEqual(self.blend('order.ttf', font), 0)
        self.assertIn('GSUB', TTFont(self.path('x.ttf')))

    def test_by_a_seed(self):
        paths = [cli.SANS_BOLD, *sorted(path for path in CORPUS.iterdir() if path.suffix in ('.ttf', '.otf', '.ttc'))]
        for name, font in damaged_fonts.fonts(paths, FONTS, 1):
            with self.subTest(name=name):
                self.blend(name, font)


if __name__ == '__main__':
    cli.main()
