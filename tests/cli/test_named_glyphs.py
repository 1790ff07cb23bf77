"""Glyphs by their names, /a.sc and /f_i, in texts, files of characters and hints; reports of glyphs without a character."""

import json

import cli
from fontTools import ttLib
from fontTools.feaLib.builder import addOpenTypeFeaturesFromString
from fontTools.pens.ttGlyphPen import TTGlyphPen
from fontTools.ttLib.tables._c_m_a_p import cmap_format_12

FONTS = ('a.ttf', 'b.ttf')
FEATURES = """
languagesystem DFLT dflt;
languagesystem latn dflt;
feature liga { sub A B by A_B; } liga;
feature dlig { sub B C by joined; } dlig;
feature smcp { sub A by A.sc; sub B by B.sc; sub C by C.sc; } smcp;
"""
# What the second font has for the first one's glyphs.
OTHERS = {'A_B': 'lig7', 'joined': 'lig8', 'A.sc': 'small1', 'B.sc': 'small2'}


def bar(left, bottom, right, top):
    pen = TTGlyphPen(None)
    pen.moveTo((left, bottom))
    for point in ((left, top), (right, top), (right, bottom)):
        pen.lineTo(point)
    pen.closePath()
    return pen.glyph()


class Named(cli.Test):
    """Two fonts of A to D and a slash, with ligatures and small capitals; the second has other names, and no small C."""

    def setUp(self):
        super().setUp()
        self.make_font('a.ttf', {}, FEATURES)
        features = FEATURES.replace(' sub C by C.sc;', '')
        for own, other in OTHERS.items():
            features = features.replace(f'by {own};', f'by {other};')
        self.make_font('b.ttf', {**OTHERS, 'C.sc': 'tiny'}, features)

    def make_font(self, name, names, features):
        """Each glyph is a bar of a width of its own; B's are higher."""
        cli.cut_font(self.path(name), 'ABCD/._ ')
        font = ttLib.TTFont(self.path(name))
        order = font.getGlyphOrder()
        for tag in ('GSUB', 'GPOS', 'GDEF', 'kern'):
            if tag in font:
                del font[tag]
        font['post'].formatType, font['post'].extraNames, font['post'].mapping = 2.0, [], {}
        added = [names.get(glyph, glyph) for glyph in ('A_B', 'joined', 'A.sc', 'B.sc', 'C.sc')]
        font.setGlyphOrder(order + added)
        for index, glyph in enumerate(['A', 'B', 'C', 'D', *added]):
            font['glyf'][glyph] = bar(100, 0, 300 + 100 * index, 1400 if names else 1000)
            font['hmtx'][glyph] = (500 + 100 * index, 100)
        addOpenTypeFeaturesFromString(font, features)
        font.save(self.path(name))

    def inspected(self, *arguments, fonts=FONTS):
        result = self.run_program('inspect', *fonts, '--json', *arguments)
        self.assertEqual(result.returncode, 0, result.stderr)
        return json.loads(result.stdout)['glyphs']

    def names(self, *arguments):
        return [glyph.get('glyph') or glyph['character'] for glyph in self.inspected(*arguments)]

    def widths(self, *arguments, **options):
        """The widths of the bars that an inspection shows of A."""
        return [round(glyph['a']['area'] * 2048 * 2048 / 1000) for glyph in self.inspected(*arguments, **options)]


class Notation(Named):
    """Which texts name glyphs."""

    def test_names_in_a_text(self):
        self.assertEqual(self.names('--text', '/A_B/joined /A.sc'), ['/A_B', '/joined', '/A.sc'])
        self.assertEqual(self.names('--text', 'D/A.sc B'), ['D', '/A.sc', 'B'])
        self.assertEqual(self.names('--text', '/A.sc  B'), ['/A.sc', ' ', 'B'])
        self.assertEqual(self.names('--text', 'D /B'), ['D', ' ', '/B'])
        self.assertEqual(self.names('--text', '/A.sc', '--text', '/B'), ['/A.sc', '/B'])

    def test_slashes_of_texts(self):
        for text in ('A/B', 'A/', '/', 'A / B', '/ A', 'A//B', 'A/B.C', 'A/B_D/C.D', '//', '// A', 'A/_', 'A/.', '//D.C', 'A//A.B'):
            with self.subTest(text=text):
                self.assertEqual(self.names('--text', text), list(dict.fromkeys(text)))

    def test_two_slashes(self):
        self.assertEqual(self.names('--text', '//A'), ['/', 'A'])
        self.assertEqual(self.names('--text', '/B //A'), ['/B', '/', 'A'])
        one, two = (self.strip('--text', text) for text in ('/ A', '//A'))
        self.assertLess(two.width, one.width)
        self.assertEqual(two.width, self.strip('--text', 'D/A').width - self.strip('--text', 'DA').width +
                         self.strip('--text', 'A').width)

    def strip(self, *arguments):
        self.made('strip', *FONTS, '--at', '0', '--no-labels', '-q', '-o', 'x.png', *arguments)
        return cli.Image(self.path('x.png'))

    def test_ways_to_name_a_glyph(self):
        order = ttLib.TTFont(self.path('a.ttf')).getGlyphOrder()
        own = self.widths('--text', '/A_B /joined /B')
        self.assertEqual(own, [600, 700, 300])
        numbers = (order.index(name) for name in ('A_B', 'joined', 'B'))
        self.assertEqual(self.widths('--text', ' '.join(f'/gid{number}' for number in numbers)), own)
        self.assertEqual(self.widths('--text', '/uni0041_uni0042 /B_C /uni0042'), own)

    def test_files_of_characters(self):
        path = self.write('chars', '# glyphs\n/A_B/B_C  AB # and /x\nU+0044,U+0043\n/A.sc\n/ A/B\n')
        self.assertEqual(self.names('--chars', path), ['/A_B', '/B_C', 'A', 'B', 'D', 'C', '/A.sc', '/'])

    def test_unknown_names(self):
        for text, name in (('/x', 'x'), ('A /A.scc', 'A.scc'), ('/B/none', 'none'), ('/A_x', 'A_x'), ('/\x1bx', '<U+001B>x'),
                           ('/' + 'é' * 300, 'é' * 127)):
            for command, output in (('blend', 'x.ttf'), ('variable', 'x.ttf'), ('strip', 'x.png'), ('sheet', 'x.pdf'),
                                    ('inspect', 'x.svg'), ('report', 'x.html'), ('specimen', 'x.html')):
                with self.subTest(command=command, text=text):
                    self.refused(1, command, *FONTS, '--text', text, '-o', output,
                                 says=[f'--text: a.ttf has no glyph /{name}\n'])
        path = self.write('chars', 'A\n\nB /A.sc /x C\n')
        self.refused(1, 'sheet', *FONTS, '--chars', path, '-o', 'x.pdf', says=[f'{path}:3: a.ttf has no glyph /x\n'])
        path = self.write('chars', b'A /\xff\xfe\n')
        self.refused(1, 'sheet', *FONTS, '--chars', path, '-o', 'x.pdf', says=[f'{path}:1: not UTF-8\n'])

    def test_names_are_of_the_first_font(self):
        self.refused(1, 'inspect', *FONTS, '--text', '/small1', '--json', says=['a.ttf has no glyph /small1'])
        self.assertEqual(self.widths('--text', '/small1', fonts=FONTS[::-1]), [round(800 * 1.4)])


class Pictures(Named):
    """What commands show of a named glyph."""

    def test_partners_are_those_of_the_blend(self):
        for glyph, width in zip(self.inspected('--text', '/A_B/joined/A.sc'), (600, 700, 800)):
            self.assertEqual([round(glyph[side]['area'] * 2048 * 2048) for side in 'ab'], [1000 * width, 1400 * width])

    def test_a_glyph_without_a_partner(self):
        result = self.run_program('inspect', *FONTS, '--text', '/C.sc A', '--json')
        self.assertEqual(result.stderr.decode().count('\n'), 1)
        self.assertIn('1 glyph that b.ttf has not stays as in a.ttf: /C.sc\n', result.stderr.decode())
        alone, paired = json.loads(result.stdout)['glyphs']
        self.assertEqual((set(alone), alone['glyph']), ({'glyph', 'a'}, '/C.sc'))
        self.assertIn('b', paired)
        self.made('inspect', *FONTS, '--text', '/C.sc A', '-o', 'x.png')
        self.assertIn('/C.sc', ' '.join(self.made('strip', *FONTS, '--text', '/C.sc', '-o', 'x.png')))

    def test_one_font(self):
        glyph, = self.inspected('--text', '/A_B', fonts=FONTS[:1])
        self.assertEqual(set(glyph), {'glyph', 'a'})

    def ink(self, *arguments, t=0):
        self.made('strip', *FONTS, '--at', t, '--no-labels', '--size', 400, '-q', '-o', 'x.png', *arguments)
        return cli.Image(self.path('x.png')).ink() * 2048 * 2048 / 400 / 400 / (1000 + 400 * t)

    def test_strips(self):
        """Widths of bars: each named glyph is there, once, at both ends; nothing is substituted by it or with it."""
        for t in (0, 1):
            self.assertAlmostEqual(self.ink('--text', 'AB', t=t), 600, delta=10)
            self.assertAlmostEqual(self.ink('--text', '/A_B', t=t), 600, delta=10)
            self.assertAlmostEqual(self.ink('--text', '/A/B', t=t), 200 + 300, delta=10)
            self.assertAlmostEqual(self.ink('--text', 'A/B.sc', t=t), 200 + 900, delta=10)
            self.assertAlmostEqual(self.ink('--text', 'D/A.sc AB/B.sc', t=t), 500 + 800 + 600 + 900, delta=15)
            self.assertAlmostEqual(self.ink('--text', '/A B', t=t), 200 + 300, delta=10)

    def test_strips_of_private_characters(self):
        """Characters for private use keep their glyphs beside named ones."""
        for name in FONTS:
            font = ttLib.TTFont(self.path(name))
            subtable = cmap_format_12(12)
            subtable.platformID, subtable.platEncID, subtable.language = 3, 10, 0
            subtable.cmap = {**font.getBestCmap(), 0x10FFFD: 'C', 0x10FFFC: 'D'}
            font['cmap'].tables = [subtable]
            font.save(self.path(name))
        self.assertAlmostEqual(self.ink('--text', '\U0010FFFD/A.sc \U0010FFFC/B.sc'), 400 + 800 + 500 + 900, delta=15)

    def test_sheets(self):
        arguments = ('-o', 'x.png', '--size', 100, '--steps', 2, '--rows', 10)
        self.made('sheet', *FONTS, '--text', 'AD', *arguments)
        two = cli.Image(self.path('x.png'))
        self.made('sheet', *FONTS, '--text', '/A_B/joined AD', *arguments)
        four = cli.Image(self.path('x.png'))
        self.assertEqual((four.width, four.height), (two.width, two.height + 200))
        self.made('sheet', *FONTS, '--text', '/A_B', *arguments[2:], '-o', 'x.svg')

    def test_fonts(self):
        """A new font of named glyphs has the characters that lead to them."""
        self.made('blend', *FONTS, '--text', '/A /joined', '-q', '-o', 'x.ttf')
        font = ttLib.TTFont(self.path('x.ttf'))
        self.assertEqual(set(font.getGlyphOrder()), {'.notdef', 'A', 'joined'})
        self.assertEqual(font.getBestCmap(), {0x41: 'A'})
        self.made('blend', *FONTS, '--text', '/A', '--alternates', '-q', '-o', 'x.ttf')
        self.assertEqual(set(ttLib.TTFont(self.path('x.ttf')).getGlyphOrder()), {'.notdef', 'A', 'A.sc'})
        self.made('blend', *FONTS, '--text', '/A/A.sc', '--no-layout', '-q', '-o', 'x.ttf')
        self.assertEqual(set(ttLib.TTFont(self.path('x.ttf')).getGlyphOrder()), {'.notdef', 'A', 'A.sc'})
        self.made('variable', *FONTS, '--text', '/joined', '-q', '-o', 'x.ttf')
        self.assertEqual(ttLib.TTFont(self.path('x.ttf')).getGlyphOrder(), ['.notdef', 'joined'])
        self.made('blend', *FONTS, '--text', '/joined', '-q', '-o', 'x.ufo')

    def test_a_specimen_begins_with_the_characters(self):
        self.made('specimen', *FONTS, '--text', 'A/A.sc D', '-q', '-o', 'x.html')
        self.assertIn('"text": "AD"', self.path('x.html').read_text(encoding='utf-8'))


class Hints(Named):
    """glyph /name"""

    def test_of_a_ligature(self):
        """A corner goes with the next one."""
        hint = 'point 100,1000 700,1400\n'
        for name in ('A_B', 'uni0041_uni0042'):
            hints = self.write('hints', f'glyph /{name}\n' + hint)
            for command, output in (('strip', 'x.png'), ('inspect', 'x.svg'), ('sheet', 'x.svg')):
                with self.subTest(command=command, name=name):
                    without, with_hints = (self.picture(command, output, *more) for more in ((), ('--hints', hints)))
                    self.assertFalse(without == with_hints)
        other = self.write('hints', 'glyph /joined\n' + hint)
        self.assertTrue(self.picture('inspect', 'x.svg') == self.picture('inspect', 'x.svg', '--hints', other))

    def picture(self, command, output, *arguments):
        self.made(command, *FONTS, '--text', '/A_B', '-q', '-o', output, *arguments)
        return self.path(output).read_bytes()

    def test_in_a_blend_and_a_variable_font(self):
        hints = self.write('hints', 'glyph /A_B\npoint 100,1000 700,1400\n')
        for command in ('blend', 'variable'):
            outlines = []
            for more in ((), ('--hints', hints)):
                self.made(command, *FONTS, '-q', '-o', 'x.ttf', *more)
                font = ttLib.TTFont(self.path('x.ttf'))
                outlines.append({name: font['glyf'][name].compile(font['glyf']) for name in ('A_B', 'joined', 'A')}
                                if command == 'blend' else self.path('x.ttf').read_bytes())
            self.assertFalse(outlines[0] == outlines[1])
            if command == 'blend':
                self.assertEqual(*({name: glyph for name, glyph in each.items() if name != 'A_B'} for each in outlines))

    def test_unknown_names(self):
        hints = self.write('hints', 'glyph A\npoint 1,2 3,4\n\nglyph /A.scc\n# here\npoint 1,2 3,4\n')
        for command, output in (('blend', 'x.ttf'), ('strip', 'x.png'), ('inspect', 'x.json'), ('report', 'x.json'),
                                ('variable', 'x.ttf')):
            self.refused(1, command, *FONTS, '--text', 'A', '--hints', hints, '-o', output,
                         says=[f'{hints}:4: a.ttf has no glyph /A.scc\n'])

    def test_a_glyph_without_a_partner(self):
        hints = self.write('hints', 'glyph /C.sc\npoint 1,2 3,4\n')
        self.made('blend', *FONTS, '--hints', hints, '-q', '-o', 'x.ttf')


class Report(Named):
    """Glyphs that no character leads to."""

    def report(self, *arguments):
        self.made('report', *FONTS, '-q', '-o', 'x.json', *arguments)
        data = json.loads(self.path('x.json').read_bytes())
        self.assertEqual(data['summary']['glyphs'], len(data['glyphs']))
        self.assertEqual(data['summary']['unblended'], len(data['unblended']))
        return data

    def names(self, glyphs):
        return [glyph.get('glyph') or glyph['character'] for glyph in glyphs]

    def test_a_whole_font(self):
        data = self.report()
        self.assertCountEqual(self.names(data['glyphs']), [' ', '.', '/', 'A', 'B', 'C', 'D', '_', '/A_B', '/joined', '/A.sc', '/B.sc'])
        self.assertEqual(self.names(data['unblended']), ['/C.sc'])
        for glyph in data['glyphs']:
            self.assertEqual('glyph' in glyph, 'character' not in glyph and 'code_point' not in glyph)
        inks = {glyph.get('glyph'): [glyph[side]['ink'] * 2048 * 2048 for side in 'ab'] for glyph in data['glyphs']}
        self.assertEqual([round(ink) for ink in inks['/joined']], [700 * 1000, 700 * 1400])

    def test_as_many_as_the_blend_has(self):
        for arguments in ((), ('--text', 'AB'), ('--text', 'AB', '--alternates'), ('--text', '/joined /C.sc'), ('--text', 'D')):
            data = self.report(*arguments)
            self.made('blend', *FONTS, *arguments, '-q', '-o', 'x.ttf')
            order = ttLib.TTFont(self.path('x.ttf')).getGlyphOrder()
            self.assertEqual(len(order), 1 + len(data['glyphs']) + len(data['unblended']))

    def test_names_can_be_given_again(self):
        named = [glyph['glyph'] for glyph in self.report()['glyphs'] if 'glyph' in glyph]
        again = self.report('--text', ' '.join(named))
        self.assertEqual(self.names(again['glyphs']), named)

    def test_nothing_to_measure(self):
        data = self.report('--text', '/C.sc')
        self.assertEqual((data['glyphs'], self.names(data['unblended'])), ([], ['/C.sc']))
        self.made('report', *FONTS, '--text', '/C.sc', '-o', 'x.html')

    def test_the_page(self):
        self.made('report', *FONTS, '-q', '-o', 'x.html', '--rotate', 'auto')
        page = self.path('x.html').read_text(encoding='utf-8')
        for name in ('/A_B', '/joined', '/A.sc', '/C.sc'):
            self.assertEqual(page.count(f'<bdi class="name">{name}</bdi>'), 1)
        self.assertIn('1 glyph without a partner in the second font', page)

    def test_a_flagged_form_has_its_strip(self):
        """The second font's ligature is two bars more: parts come out of nothing."""
        font = ttLib.TTFont(self.path('b.ttf'))
        pen = TTGlyphPen(None)
        for left in range(100, 1600, 300):
            for bottom in range(0, 1400, 300):
                bar(left, bottom, left + 100, bottom + 100).draw(pen, font['glyf'])
        font['glyf']['lig7'] = pen.glyph()
        font.save(self.path('b.ttf'))
        arguments = ('--text', '/A_B', '--method', 'paper')
        flagged = [glyph for glyph in self.report(*arguments)['glyphs'] if glyph['flags']]
        self.assertEqual(self.names(flagged), ['/A_B'])
        self.made('report', *FONTS, *arguments, '-o', 'x.html')
        self.assertGreaterEqual(self.path('x.html').read_text(encoding='utf-8').count('<svg'), 9)

    def test_names_are_escaped(self):
        font = ttLib.TTFont(self.path('a.ttf'))
        font.setGlyphOrder([{'A.sc': '<b>&"', 'B.sc': 'a/b', 'C.sc': 'C'}.get(name, name) for name in font.getGlyphOrder()])
        font.save(self.path('odd.ttf'))
        self.made('report', 'odd.ttf', 'odd.ttf', '-q', '-o', 'x.html')
        page = self.path('x.html').read_text(encoding='utf-8')
        self.assertIn('/&lt;b&gt;&amp;', page)
        self.assertNotIn('<b>&"', page)
        self.assertNotIn('/a/b', page)

    def test_same_bytes_on_any_number_of_threads(self):
        for form in ('json', 'html'):
            outputs = set()
            for threads in (1, 3):
                self.made('report', *FONTS, '-q', '-j', threads, '-o', 'x.' + form)
                outputs.add(self.path('x.' + form).read_bytes())
            self.assertEqual(len(outputs), 1)


if __name__ == '__main__':
    cli.main()
