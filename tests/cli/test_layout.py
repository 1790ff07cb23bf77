"""morphotype blend: kerning and other positions of the fonts it makes, seen by fontTools and the OpenType sanitizer."""

import subprocess

import cli
from fontTools import ttLib
from fontTools.ttLib.tables import otTables

LETTERS = 'AVTWYLPFavowyr.,-ΑΤαυΓТУАГу'
NIMBUS = cli.DEBIAN / 'opentype/urw-base35/NimbusSans-Regular.otf'
PALATINO = cli.DEBIAN / 'opentype/urw-base35/P052-Roman.otf'


def systems(font):
    """Scripts and languages of GPOS."""
    found = set()
    for record in font['GPOS'].table.ScriptList.ScriptRecord:
        found.update((record.ScriptTag, language.LangSysTag) for language in record.Script.LangSysRecord)
        if record.Script.DefaultLangSys:
            found.add((record.ScriptTag, None))
    return found


def subtables(font, tag):
    """The subtables of the lookups in features of a tag, extensions followed."""
    table = font['GPOS'].table
    indices = {index for record in table.FeatureList.FeatureRecord if record.FeatureTag == tag
               for index in record.Feature.LookupListIndex}
    return [getattr(subtable, 'ExtSubTable', subtable)
            for index in sorted(indices) for subtable in table.LookupList.Lookup[index].SubTable]


class Positions(cli.Test):
    def blend(self, a, b, *arguments):
        self.made('blend', a, b, '--text', LETTERS, '-o', 'x.ttf', *arguments)
        subprocess.run(['ots-sanitize', self.path('x.ttf')], check=True, stdout=subprocess.DEVNULL)
        return ttLib.TTFont(self.path('x.ttf'), lazy=False)

    def kerning(self, font, left, right):
        """The advance that a lookup adds to a pair, by the first of its subtables that applies."""
        cmap = font.getBestCmap()
        left, right = cmap[ord(left)], cmap[ord(right)]
        for subtable in subtables(font, 'kern'):
            if left not in subtable.Coverage.glyphs:
                continue
            if isinstance(subtable, otTables.PairPos) and subtable.Format == 1:
                records = subtable.PairSet[subtable.Coverage.glyphs.index(left)].PairValueRecord
                found = [r.Value1.XAdvance for r in records if r.SecondGlyph == right]
                if found:
                    return found[0]
            else:
                row = subtable.Class1Record[subtable.ClassDef1.classDefs.get(left, 0)]
                return row.Class2Record[subtable.ClassDef2.classDefs.get(right, 0)].Value1.XAdvance
        return 0

    def test_kerning_lies_between(self):
        a, b = ttLib.TTFont(NIMBUS), ttLib.TTFont(PALATINO)
        font = self.blend(NIMBUS, PALATINO, '--at', '0.25')
        scale = font['head'].unitsPerEm / 1000
        for left, right in ('AV', 'To', 'VA', 'P.', 'Ya', 'ТУ', 'AA'):
            wanted = scale * (0.75 * self.kerning(a, left, right) + 0.25 * self.kerning(b, left, right))
            self.assertAlmostEqual(self.kerning(font, left, right), wanted, delta=0.51, msg=left + right)
        self.assertLess(self.kerning(font, 'A', 'V'), 0)

    def test_scripts_and_languages_of_the_first_font_stay(self):
        font = self.blend(cli.SANS_BOLD, cli.SERIF)
        self.assertLessEqual(systems(ttLib.TTFont(cli.SANS_BOLD)), systems(font))

    def test_tables_are_in_order(self):
        """Scripts, languages and features ascend, and every index is one."""
        table = self.blend(cli.SANS_BOLD, cli.SERIF)['GPOS'].table
        scripts = [record.ScriptTag for record in table.ScriptList.ScriptRecord]
        features = [record.FeatureTag for record in table.FeatureList.FeatureRecord]
        self.assertEqual(scripts, sorted(set(scripts)))
        self.assertEqual(features, sorted(features))
        for record in table.ScriptList.ScriptRecord:
            languages = [language.LangSysTag for language in record.Script.LangSysRecord]
            self.assertEqual(languages, sorted(set(languages)))
        for record in table.FeatureList.FeatureRecord:
            for index in record.Feature.LookupListIndex:
                self.assertLess(index, len(table.LookupList.Lookup))

    def test_kerning_of_a_variable_font_at_its_place(self):
        light, black = (self.blend(f'{cli.INTER}@wght={weight}', cli.SERIF, '--at', '0') for weight in (100, 900))
        pairs = [(left, right) for left in LETTERS[:10] for right in LETTERS[:18]]
        self.assertNotEqual([self.kerning(light, *pair) for pair in pairs],
                            [self.kerning(black, *pair) for pair in pairs])


if __name__ == '__main__':
    cli.main()
