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

    def with_features(self, text):
        font = TTFont(CORPUS / 'plain.ttf')
        addOpenTypeFeaturesFromString(font, text)
        font.save(self.path('features.ttf'))
        return self.path('features.ttf').read_bytes()

    def sanitized(self, font):
        """The GSUB of a blend of it."""
        self.assertEqual(self.blend('font.ttf', font), 0)
        return TTFont(self.path('x.ttf'))['GSUB'].table

    def test_script_without_a_default(self):
        font = self.with_features("""
            languagesystem DFLT dflt; languagesystem latn dflt; languagesystem latn DEU; feature liga { sub a e by i; } liga;""")
        def first_script(gsub):
            scripts, = struct.unpack('>H', gsub[4:6])
            self.assertEqual(gsub[scripts + 2:scripts + 6], b'DFLT')
            return scripts + struct.unpack('>H', gsub[scripts + 6:scripts + 8])[0], 0
        gsub = self.sanitized(self.changed(font, 'GSUB', first_script))
        self.assertEqual([record.ScriptTag for record in gsub.ScriptList.ScriptRecord], ['latn'])

    def test_mark_set_that_there_is_not(self):
        """The second of two, for lookups of GSUB and of GPOS."""
        font = self.with_features("""
            feature liga { lookup one { lookupflag UseMarkFilteringSet [n]; sub a e by i; } one;
                           lookup two { lookupflag UseMarkFilteringSet [i]; sub e a by n; } two; } liga;
            feature kern { lookupflag UseMarkFilteringSet [i]; pos a e 100; } kern;""")
        def count_of_sets(gdef):
            sets, = struct.unpack('>H', gdef[12:14])
            self.assertEqual(struct.unpack('>H', gdef[sets + 2:sets + 4]), (2,))
            return sets + 2, 1
        self.assertEqual(self.blend('sets.ttf', self.changed(font, 'GDEF', count_of_sets)), 0)
        gpos = TTFont(self.path('x.ttf'))['GPOS'].table
        self.assertEqual({lookup.LookupFlag for lookup in gpos.LookupList.Lookup}, {0})

    def test_call_beyond_the_input(self):
        font = self.with_features("""lookup one { sub a by i; } one; lookup two { sub e by n; } two;
            feature calt { sub a' lookup one e' lookup two; } calt;""")
        calls = struct.pack('>HHHH', 0, 0, 1, 1)
        def first_call(gsub):
            self.assertEqual(gsub.count(calls), 1)
            return gsub.index(calls), 0xFFFF
        gsub = self.sanitized(self.changed(font, 'GSUB', first_call))
        rule, = (table.ExtSubTable for lookup in gsub.LookupList.Lookup for table in lookup.SubTable
                 if table.ExtensionLookupType == 5)
        self.assertEqual([(call.SequenceIndex, call.LookupListIndex) for call in rule.SubstLookupRecord], [(1, 1)])

    def test_by_a_seed(self):
        paths = [cli.SANS_BOLD, *sorted(path for path in CORPUS.iterdir() if path.suffix in ('.ttf', '.otf', '.ttc'))]
        for name, font in damaged_fonts.fonts(paths, FONTS, 1):
            with self.subTest(name=name):
                self.blend(name, font)


if __name__ == '__main__':
    cli.main()
