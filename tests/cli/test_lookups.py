"""Lookups out of the ordinary. Without an end: a font whose contexts call each other in a circle or too deep, or whose substitutions
make a text longer and longer, is refused by name; one that stays within bounds is blended. And one that takes glyphs away."""

import subprocess

import cli
import harfbuzz
from fontTools import ttLib
from fontTools.feaLib import builder

TEXT = 'abci'
LEVELS = 64 # HarfBuzz follows no more (HB_MAX_NESTING_LEVEL)


class Lookups(cli.Test):
    """Each font has the same few glyphs, and lookups of its own."""

    def setUp(self):
        super().setUp()
        self.plain = self.font('plain.ttf', '')

    def font(self, name, features, change=None):
        font = ttLib.TTFont(cli.cut_font(self.path(name), TEXT))
        for tag in ('GSUB', 'GPOS', 'GDEF'):
            if tag in font:
                del font[tag]
        if features:
            builder.addOpenTypeFeaturesFromString(font, features)
        if change:
            change(font)
        font.save(self.path(name))
        return name


class Endless(Lookups):
    """Circles, deep chains, growth."""

    @staticmethod
    def chain(tag, levels):
        """`levels` contexts, of which each calls the next, and the last calls a plain lookup. GPOS or GSUB."""
        plain, call = {'GSUB': ('sub a by b;', "sub a' lookup {} c;"), 'GPOS': ('pos a 10;', "pos a' lookup {} c;")}[tag]
        lookups = [f'lookup L0 {{ {plain} }} L0;']
        lookups += [f'lookup L{i} {{ {call.format(f"L{i - 1}")} }} L{i};' for i in range(1, levels)]
        return f'{" ".join(lookups)} feature test {{ lookup L{levels - 1}; }} test;'

    @staticmethod
    def call(tag, caller, called):
        """Changes what a lookup calls."""
        def change(part):
            if hasattr(part, 'LookupListIndex'):
                part.LookupListIndex = called
            for value in vars(part).values() if hasattr(part, '__dict__') else part if isinstance(part, list) else ():
                change(value)
        return lambda font: change(font[tag].table.LookupList.Lookup[caller].SubTable)

    def assert_refused(self, name):
        for fonts in ((name, self.plain), (self.plain, name)):
            for command, output in (('blend', 'x.ttf'), ('variable', 'x.ttf')):
                self.refused(1, command, *fonts, '-o', output, says=[f'{name}: ', 'circle'])

    def test_circles(self):
        for tag in ('GSUB', 'GPOS'):
            with self.subTest(tag):
                self.assert_refused(self.font('itself.ttf', self.chain(tag, 2), self.call(tag, 1, 1)))
                self.assert_refused(self.font('circle.ttf', self.chain(tag, 5), self.call(tag, 1, 4)))

    def test_depth(self):
        for tag in ('GSUB', 'GPOS'):
            with self.subTest(tag):
                self.made('blend', self.font('deep.ttf', self.chain(tag, LEVELS)), self.plain, '-o', 'x.ttf')
                self.path('x.ttf').unlink()
                self.assert_refused(self.font('deeper.ttf', self.chain(tag, LEVELS + 1)))

    @staticmethod
    def doublings(count):
        lookups = ' '.join(f'lookup L{i} {{ sub a by a a; }} L{i};' for i in range(count))
        return f'{lookups} feature ccmp {{ {" ".join(f"lookup L{i};" for i in range(count))} }} ccmp;'

    def test_growth(self):
        self.assert_refused(self.font('grows.ttf', self.doublings(40)))
        self.made('blend', self.font('long.ttf', self.doublings(5)), self.plain, '-o', 'x.ttf')


class Nothing(Lookups):
    """A multiple substitution by no glyph takes the glyph away, as HarfBuzz has it."""

    def test_taken_away(self):
        font = self.font('away.ttf', 'lookup AWAY { sub b by NULL; } AWAY; feature ccmp { sub a b\' lookup AWAY c; } ccmp;')
        self.made('blend', font, self.plain, '--at', '0,1', '-o', 'x.ttf')
        for path in (font, 'x-0.ttf', 'x-1.ttf'):
            order = ttLib.TTFont(self.path(path)).getGlyphOrder()
            named = lambda text: [order[number] for number, *_ in harfbuzz.shape(self.path(path), text)]
            self.assertEqual([len(named('abc')), len(named('bab'))], [2, 3], path)
        subprocess.run(['ots-sanitize', self.path('x-0.ttf')], check=True, stdout=subprocess.DEVNULL)


if __name__ == '__main__':
    cli.main()
