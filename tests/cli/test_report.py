"""morphotype report: its data against themselves and against inspect; its page as any browser would read it."""

import html.parser
import json
import string
import unittest

import cli

FLAGS = ['failed', 'components', 'holes', 'strays', 'clots', 'ink']
COUNTS = {'components', 'holes', 'crumbs', 'ink', 'strays', 'clots', 'ink_excess'}
PLACES = [step / 16 for step in range(17)]


def has_flag(glyph, *names):
    return any(flag['flag'] in names for flag in glyph['flags'])


class Data(cli.Test):
    """-o x.json"""

    def report(self, *arguments, fonts=(cli.SANS_BOLD, cli.SERIF)):
        self.assertEqual(self.made('report', *fonts, '-o', 'x.json', *arguments), [])
        data = json.loads(self.path('x.json').read_bytes())
        self.assertEqual((data['format'], data['version']), ('morphotype report', 2))
        self.check(data)
        return data

    def check(self, data):
        glyphs, summary = data['glyphs'], data['summary']
        self.assertEqual(data['at'], PLACES)
        self.assertEqual(summary['glyphs'], len(glyphs))
        self.assertEqual(summary['flagged'], sum(bool(glyph['flags']) for glyph in glyphs))
        self.assertEqual(summary['failed'], sum(has_flag(glyph, 'failed') for glyph in glyphs))
        for method in ('aligned', 'linked', 'both'):
            self.assertEqual(summary[method], sum(glyph.get('method') == method for glyph in glyphs))
        made = [glyph for glyph in glyphs if not has_flag(glyph, 'failed')]
        proved = [glyph for glyph in made if glyph['proved']]
        self.assertEqual(summary['proved'], len(proved))
        self.assertEqual([glyph for glyph in proved if any(self.parts(glyph))], [])
        inside = sum(not any(self.parts(glyph)) for glyph in made)
        self.assertAlmostEqual(summary['counts_in_range'], inside / len(glyphs), places=8)
        inside = sum(all(place['ink_excess'] <= data['limits']['ink'] for place in glyph['between']) for glyph in made)
        self.assertAlmostEqual(summary['ink_in_range'], inside / len(glyphs), places=8)
        order = [(-glyph['severity'], glyph.get('code_point', 0x110000)) for glyph in glyphs]
        self.assertEqual(order, sorted(order))
        for glyph in glyphs:
            self.check_glyph(glyph, data['limits'])

    @staticmethod
    def parts(glyph):
        """Components, and holes, out of the ends' range, summed over all places."""
        found = []
        for name in ('components', 'holes'):
            least, most = sorted(end[name] for end in (glyph['a'], glyph['b']))
            found.append(sum(max(0, least - place[name], place[name] - most) for place in glyph['between']))
        return found

    def check_glyph(self, glyph, limits):
        names = [flag['flag'] for flag in glyph['flags']]
        self.assertEqual(names, [flag for flag in FLAGS if flag in names])
        self.assertEqual(glyph['severity'] >= limits['severity'], bool(names))
        if 'glyph' in glyph:
            self.assertNotIn('character', glyph)
            self.assertRegex(glyph['glyph'], '^/[^/ ]+$')
        else:
            self.assertEqual(ord(glyph['character']), glyph['code_point'])
        if 'failed' in names:
            self.assertNotIn('method', glyph)
            return
        ends, between = (glyph['a'], glyph['b']), glyph['between']
        self.assertEqual([set(place) for place in between], [COUNTS] * 17)
        for place in between[1:-1]:
            least, most = sorted(end['ink'] for end in ends)
            out = max(0, place['ink'] - most, least - place['ink']) / most if most else 0
            self.assertAlmostEqual(place['ink_excess'], out, delta=2e-3)
        score = max(max(place['strays'] / 12, (place['clots'] - 1) / 0.15, place['ink_excess'] / 0.12) for place in between)
        self.assertAlmostEqual(glyph['severity'], score + 0.03 * min(40, sum(self.parts(glyph))), delta=0.0101)

    def test_latin(self):
        data = self.report('--text', 'oiHB%& ')
        self.assertEqual(data['a'], {'font': str(cli.SANS_BOLD), 'family': 'DejaVu Sans', 'style': 'Bold'})
        self.assertEqual(data['method'], 'joint')
        glyphs = {glyph['character']: glyph for glyph in data['glyphs']}
        self.assertEqual(set(glyphs), set('oiHB%& '))
        for character, components, holes in (('o', 1, 1), ('i', 2, 0), ('B', 1, 2), ('%', 3, 2), (' ', 0, 0)):
            for place in glyphs[character]['between'] + [glyphs[character]['a'], glyphs[character]['b']]:
                self.assertEqual((place['components'], place['holes']), (components, holes), character)
        self.assertFalse(has_flag(glyphs['H'], *FLAGS))
        self.assertEqual(data['summary']['proved'], len(glyphs))

    def test_letters_and_digits_need_no_look(self):
        data = self.report('--text', string.ascii_letters + string.digits)
        self.assertEqual([glyph.get('character') for glyph in data['glyphs'] if glyph['flags']], [])

    def test_ink_of_the_ends_is_that_of_the_glyphs(self):
        report = {glyph['character']: glyph for glyph in self.report('--text', 'oRg')['glyphs']}
        inspection = json.loads(self.run_program('inspect', cli.SANS_BOLD, cli.SERIF, '--text', 'oRg', '--json').stdout)
        for glyph in inspection['glyphs']:
            measured = report[glyph['character']]
            for key, place in (('a', 0), ('b', 16)):
                self.assertAlmostEqual(measured[key]['ink'], glyph[key]['area'], places=8)
                self.assertAlmostEqual(measured['between'][place]['ink'], glyph[key]['area'], delta=1e-3)

    def test_the_method_of_the_paper(self):
        data = self.report('--text', 'Rg', '--method', 'paper')
        self.assertEqual((data['method'], data['summary']['linked']), ('paper', 2))
        self.assertEqual(data['summary']['proved'], 0)

    def test_the_worst_come_first(self):
        data = self.report('--text', '一形永', '--method', 'paper', fonts=(cli.ZENHEI, cli.UKAI))
        self.assertGreaterEqual(data['summary']['flagged'], 1)
        self.assertEqual(data['glyphs'][-1]['character'], '一')

    def test_a_failed_glyph_is_the_worst(self):
        font = cli.cut_font(self.path('cut.ttf'), 'ABC', blank='B')
        data = self.report('--text', 'ABC', fonts=(cli.SANS_BOLD, font))
        self.assertEqual((data['summary']['failed'], data['glyphs'][0]['character']), (1, 'B'))
        self.assertIn('blank', data['glyphs'][0]['flags'][0]['reason'])

    def test_a_whole_font(self):
        font = cli.cut_font(self.path('cut.ttf'), 'ABCé')
        self.made('report', font, font, '-o', 'x.json', '-q')
        data = json.loads(self.path('x.json').read_bytes())
        self.check(data)
        self.assertEqual({glyph['character'] for glyph in data['glyphs']}, set('ABCé'))
        self.assertEqual(data['summary']['flagged'], 0)

    def test_characters_in_one_font_only_are_left_out(self):
        said = self.made('report', cli.SANS_BOLD, cli.SERIF, '-o', 'x.json', '--chars', self.write('chars', 'A 形'))
        self.assertEqual(said, ['morphotype: 1 character not in both fonts, left out: U+5F62'])

    def test_same_bytes_on_any_number_of_threads(self):
        for form in ('json', 'html'):
            outputs = set()
            for threads in (1, 2, 5):
                self.made('report', cli.SANS_BOLD, cli.SERIF, '--text', 'RgaxyQ&@', '-j', threads, '-o', 'x.' + form)
                outputs.add(self.path('x.' + form).read_bytes())
            self.assertEqual(len(outputs), 1)


class Reader(html.parser.HTMLParser):
    """Elements that are open, all start tags, and the text outside of styles and scripts."""

    VOID = {'meta', 'br', 'link'}

    def __init__(self, page):
        super().__init__()
        self.open, self.tags, self.text = [], [], ''
        self.feed(page)
        self.close()
        assert not self.open, self.open

    def handle_starttag(self, tag, attrs):
        self.tags.append((tag, dict(attrs)))
        if tag not in self.VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attrs):
        self.tags.append((tag, dict(attrs)))

    def handle_endtag(self, tag):
        assert self.open.pop() == tag, tag

    def handle_data(self, data):
        if self.open and self.open[-1] not in ('style', 'script'):
            self.text += data

    def count(self, tag):
        return sum(name == tag for name, _ in self.tags)


class Page(cli.Test):
    """-o x.html"""

    def page(self, *arguments, fonts=(cli.SANS_BOLD, cli.SERIF)):
        self.assertEqual(self.made('report', *fonts, '-o', 'x.html', *arguments), [])
        return Reader(self.path('x.html').read_text(encoding='utf-8'))

    def test_it_stands_alone(self):
        page = self.page('--text', 'Rgxy&', '--method', 'paper')
        self.assertFalse({tag for tag, _ in page.tags} & {'img', 'iframe', 'object', 'base'})
        for tag, attributes in page.tags:
            self.assertFalse(set(attributes) & {'src', 'onload', 'onclick', 'style'})
            self.assertTrue(tag == 'link' and attributes['href'].startswith('data:') or 'href' not in attributes)
        source = self.path('x.html').read_text(encoding='utf-8')
        for part in ('url(', '@import'):
            self.assertNotIn(part, source)
        self.assertIn('prefers-color-scheme: dark', source)
        self.assertIn('name="viewport"', source)

    def test_every_glyph_has_a_strip(self):
        arguments, fonts = ('--text', '一形國永', '--method', 'paper'), (cli.ZENHEI, cli.UKAI)
        page = self.page(*arguments, fonts=fonts)
        self.made('report', *fonts, '-o', 'x.json', *arguments)
        data = json.loads(self.path('x.json').read_bytes())
        flagged = data['summary']['flagged']
        self.assertTrue(0 < flagged < 4)
        between = sum(self.is_off(glyph, place) for glyph in data['glyphs'] if glyph['flags'] for place in glyph['between'][1::2])
        pictures = 9 * flagged + between + 5 * (4 - flagged)
        self.assertEqual((page.count('svg'), page.count('path')), (pictures, pictures))
        off = sum(self.is_off(glyph, place) for glyph in data['glyphs']
                  for place in (glyph['between'] if glyph['flags'] else glyph['between'][::4]))
        self.assertEqual(sum(attributes.get('class') == 'off' for tag, attributes in page.tags if tag == 'svg'), off)
        for tag, attributes in page.tags:
            if tag == 'path':
                self.assertRegex(attributes['d'], r'^(M-?\d+[ -]\d+([lq][-\d ]+)+z)+$')
        for glyph in data['glyphs']:
            self.assertIn(f"{glyph['character']}U+{glyph['code_point']:04X}", page.text)
            for flag in glyph['flags']:
                self.assertIn(f"{flag['flag']}: {flag['reason']}", page.text)

    @staticmethod
    def is_off(glyph, place):
        for name in ('components', 'holes'):
            least, most = sorted(end[name] for end in (glyph['a'], glyph['b']))
            if not least <= place[name] <= most:
                return True
        return max(place['strays'] / 12, (place['clots'] - 1) / 0.15, place['ink_excess'] / 0.12) >= 1

    def test_nothing_is_flagged(self):
        page = self.page('--text', 'HIo', fonts=(cli.SERIF, cli.SERIF))
        self.assertIn('None.', page.text)
        self.assertEqual(page.count('svg'), 5 * 3)

    def test_a_failed_glyph_has_no_strip(self):
        font = cli.cut_font(self.path('cut.ttf'), 'AB', blank='B')
        page = self.page('--text', 'AB', fonts=(font, cli.cut_font(self.path('other.ttf'), 'AB')))
        self.assertEqual([attributes['data-glyph'] for _, attributes in page.tags if 'data-glyph' in attributes], ['0'])
        self.assertIn('failed: one font draws the character', page.text)
        self.assertEqual(page.count('svg'), 5)

    def test_names_and_characters_are_escaped(self):
        font = cli.cut_font(self.path('<b>&"x\'.ttf'), '<&>"A')
        page = self.page('--text', '<&>"A', fonts=(font, cli.SANS_BOLD))
        self.assertEqual(page.count('b'), 1)  # the number of flagged glyphs
        self.assertIn(str(font), page.text)
        for character in '<&>"':
            self.assertIn(f'{character}U+{ord(character):04X}', page.text)

    def test_only_the_worst_have_strips(self):
        chars = self.write('chars', 'U+0021-0600')
        self.made('report', cli.SERIF, cli.SERIF, '-q', '--chars', chars, '--method', 'paper', '-o', 'x.html')
        page = Reader(self.path('x.html').read_text(encoding='utf-8'))
        self.assertEqual(page.count('svg'), 5 * 1000)
        self.assertRegex(page.text, r'Only the worst 1000 of the \d+ glyphs have strips')


class FailOn(cli.Test):
    """--fail-on: the report is written, and the exit code says whether it is good enough."""

    def setUp(self):
        super().setUp()
        self.fonts = (cli.SANS_BOLD, cli.cut_font(self.path('cut.ttf'), 'ABCDE', blank='BCD'))

    def judged(self, code, fail_on, *arguments, fonts=None, text='ABCDE'):
        """Runs it; gives its data and what it says, one line or none."""
        result = self.run_program('report', *(fonts or self.fonts), '--text', text, '--fail-on', fail_on, '-o', 'x.json', *arguments)
        said = result.stderr.decode()
        self.assertEqual((result.returncode, said.count('\n')), (code, code), said)
        data = json.loads(self.path('x.json').read_bytes())
        self.path('x.json').unlink()
        return data, said

    def test_number(self):
        for number in (1, 2, 3):
            data, said = self.judged(1, number, '-q')
            self.assertEqual(said, 'morphotype: x.json: 3 of 5 glyphs flagged (--fail-on)\n')
            self.assertEqual(data['summary']['flagged'], 3)
        for number in (4, 1000):
            self.judged(0, number)

    def test_reasons(self):
        _, said = self.judged(1, 'failed')
        self.assertEqual(said, 'morphotype: x.json: 3 of 5 glyphs flagged for failed (--fail-on)\n')
        self.judged(0, 'components,holes,strays,clots,ink')
        self.judged(0, 'failed', text='AE')
        _, said = self.judged(1, 'ink,failed,clots')
        self.assertIn('flagged for failed (', said)

    def test_each_reason(self):
        """Fails for those that the data have, and for no other."""
        fonts, text = (cli.ZENHEI, cli.UKAI), '一形國永'
        data, _ = self.judged(1, 1, '--method', 'paper', fonts=fonts, text=text)
        found = {flag['flag'] for glyph in data['glyphs'] for flag in glyph['flags']}
        self.assertTrue(0 < len(found) < len(FLAGS))
        for flag in FLAGS:
            self.judged(int(flag in found), flag, '--method', 'paper', fonts=fonts, text=text)

    def test_usage(self):
        for wrong in ('', '0', '-1', '1.5', 'none', 'ink,', ',ink', 'ink,blots', 'Ink', 'nan', '1,2'):
            self.refused(2, 'report', *self.fonts, '--fail-on', wrong, '-o', 'x.json', says=['--fail-on', ', '.join(FLAGS[:-1])])
        self.refused(2, 'blend', *self.fonts, '--fail-on', '1', '-o', 'x.ttf', says=['but of report'])


class Usage(cli.Test):
    """What is refused."""

    def test_output(self):
        fonts = (cli.SANS_BOLD, cli.SERIF)
        self.refused(2, 'report', *fonts, '--text', 'A', says=['-o'])
        for output in ('x', 'x.pdf', 'html', 'x.html.gz'):
            self.refused(2, 'report', *fonts, '--text', 'A', '-o', output, says=['.html', '.json'])
        self.refused(1, 'report', *fonts, '--text', 'A', '-o', 'nowhere/x.html', says=['nowhere/x.html'])
        self.path('d.html').mkdir()
        self.refused(1, 'report', *fonts, '--text', 'A', '-o', 'd.html', says=['d.html'])

    def test_fonts_and_characters(self):
        self.refused(2, 'report', cli.SERIF, '-o', 'x.html', says=['two fonts'])
        self.refused(1, 'report', cli.SANS_BOLD, cli.SERIF, '--text', '形', '-o', 'x.html', says=['形', 'lacks'])
        self.refused(2, 'report', cli.SANS_BOLD, cli.SERIF, '--text', '', '-o', 'x.html', says=['--text'])
        self.refused(2, 'report', cli.SANS_BOLD, cli.SERIF, '--at', '0.5', '-o', 'x.html', says=['--at'])

    def test_help(self):
        text = self.run_program('report', '--help').stdout.decode()
        self.assertTrue(text.startswith('usage: morphotype report '))
        self.assertLessEqual(max(map(len, text.splitlines())), 110)
        self.assertIn('\n  report ', self.run_program('--help').stdout.decode())


if __name__ == '__main__':
    unittest.TestCase.maxDiff = None
    cli.main()
