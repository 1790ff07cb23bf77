"""Hints made by pointing, on the page of inspect and on that of report, in Chromium. The browser's part is skipped where it is not
installed."""

import subprocess
import sys
import time
import unittest

import browser
import cli
from fontTools import ttLib
from test_specimen import InChromium, PageReader, data_of

IN_CHROMIUM = ('Narrow', 'Pointing', 'Report')


def place(side, node):
    """A node's place in its font's units: the last two of a segment's numbers."""
    contour, segment = node
    return side['drawing'][contour][segment][-2:]


class Content(cli.Test):
    """The file, and what is said of hints."""

    def inspect(self, *arguments, says=()):
        self.assertEqual(self.made('inspect', cli.SANS_BOLD, cli.SERIF, '-o', 'x.html', *arguments), list(says))
        return self.path('x.html').read_text(encoding='utf-8')

    def test_it_stands_alone(self):
        reader = PageReader(self.inspect('--text', 'k</'))
        self.assertFalse({tag for tag, _ in reader.tags} & {'img', 'iframe', 'object', 'embed', 'base', 'form'})
        for _, attributes in reader.tags:
            self.assertFalse({name for name in attributes if name == 'src' or name.startswith('on') or name == 'style'})

    def test_its_drawings_are_those_of_the_fonts(self):
        data = data_of(self.inspect('--text', 'k/f_i'))
        self.assertEqual([(glyph['name'], glyph['label']) for glyph in data['glyphs']], [('k', 'U+006B'), ('/f_i', '/f_i')])
        for key, path in (('a', cli.SANS_BOLD), ('b', cli.SERIF)):
            font, side = ttLib.TTFont(path), data['glyphs'][0][key]
            glyph = font['glyf'][font.getBestCmap()[ord('k')]]
            self.assertEqual((side['units'], side['advance'], side['components']),
                             (font['head'].unitsPerEm, font['hmtx'][font.getBestCmap()[ord('k')]][0], 1))
            ends = {tuple(segment[-2:]) for contour in side['drawing'] for segment in contour}
            self.assertEqual(ends, {point for point, flag in zip(glyph.coordinates, glyph.flags) if flag & 1})

    def test_what_moves_begins_and_ends_at_the_drawings(self):
        """Every node of a letter of straight lines is a node of what moves, on its side."""
        glyph = data_of(self.inspect('--text', 'k'))['glyphs'][0]
        for key in 'ab':
            scale = 1000 / glyph[key]['units']
            moving = [segment[-2:] for contour in glyph['moving'] for segment in contour[key]]
            for contour in glyph[key]['drawing']:
                for x, y in (segment[-2:] for segment in contour):
                    self.assertLess(min(max(abs(x * scale - u), abs(y * scale - v)) for u, v in moving), 1)

    def test_hints_that_change_nothing(self):
        hints = self.write('hints', 'glyph k\npoint 172,0 99,0\npoint 20000,0 99,0\n')
        page = self.inspect('--text', 'ko', '--hints', hints, says=[
            f'morphotype: {hints}:3: U+006B: the hint changes nothing'])
        found = data_of(page)['glyphs'][0]['hints']
        self.assertEqual([(hint['kind'], hint['a'], hint['b'], hint['idle']) for hint in found],
                         [('point', [172, 0], [99, 0], False), ('point', [20000, 0], [99, 0], True)])
        self.assertEqual(data_of(page)['glyphs'][1]['hints'], [])

    def test_one_font(self):
        self.refused(2, 'inspect', cli.SERIF, '--text', 'k', '-o', 'x.html', says=['a page wants two fonts'])


class Editor(InChromium):
    COMMAND = 'inspect'
    ARGUMENTS = ('--text', 'k6W')
    READY = 'return document.getElementById("say") !== null'
    HAS_FONT = False
    START = ''

    @classmethod
    def make_fonts(cls):
        return cls.FONTS

    def glyph(self, index=0):
        return data_of(self.page.read_text(encoding='utf-8'))['glyphs'][index]

    def point_at(self, key, x, y):
        """A click on a place in the font's units."""
        left, top = self.browser.run('''const svg = document.getElementById("side-" + arguments[0]);
            svg.scrollIntoView({block: "center"});
            const place = new DOMPoint(arguments[1], -arguments[2]).matrixTransform(svg.getScreenCTM());
            return [place.x, place.y]''', key, x * 1000 / self.glyph()[key]['units'], y * 1000 / self.glyph()[key]['units'])
        self.browser.drag((round(left), round(top)), (round(left), round(top)))

    def lines(self):
        return self.browser.run('return document.getElementById("lines").value')

    def said(self):
        return self.text_of('#say')


class Pointing(Editor):
    def test_two_clicks_make_a_hint(self):
        glyph = self.glyph()
        a, b = place(glyph['a'], (0, 0)), place(glyph['b'], (0, 3))
        self.point_at('a', *a)
        self.assertEqual(self.lines(), '')
        self.point_at('b', *b)
        line = 'point %d,%d %d,%d' % (*a, *b)
        self.assertEqual(self.lines(), f'glyph k\n{line}\n')
        self.assertIn(line, self.said())
        self.saved_hints_do_as_they_say(self.lines())

    def saved_hints_do_as_they_say(self, text):
        """The command line takes them, and the glyph is another one with them."""
        hints = self.directory / 'hints.txt'
        hints.write_text(text, encoding='utf-8')
        pictures = []
        for arguments in ((), ('--hints', hints)):
            out = self.directory / 'x.svg'
            subprocess.run([cli.MORPHOTYPE, 'strip', *self.FONTS, '--text', 'k', '-q', '-o', out, *arguments], check=True)
            pictures.append(out.read_bytes())
        self.assertNotEqual(*pictures)

    def test_save_gives_the_file(self):
        self.browser.devtools('Browser.setDownloadBehavior', behavior='allow', downloadPath=str(self.directory))
        glyph = self.glyph()
        for key, node in (('a', (0, 0)), ('b', (0, 3))):
            self.point_at(key, *place(glyph[key], node))
        self.browser.click('#save')
        saved, end = self.directory / 'hints.txt', time.monotonic() + 20
        while not saved.exists() and time.monotonic() < end:
            time.sleep(0.05)
        self.assertEqual(saved.read_text(encoding='utf-8'), self.lines())
        saved.unlink()

    def test_what_goes_together_already_is_said(self):
        """The places under the pointer and its counterpart make a hint that changes nothing."""
        glyph = self.glyph()
        nodes = {key: {tuple(segment[-2:]) for contour in glyph[key]['drawing'] for segment in contour} for key in 'ab'}
        moving = glyph['moving'][0]
        pairs = ({key: tuple(round(value * glyph[key]['units'] / 1000) for value in moving[key][i][-2:]) for key in 'ab'}
                 for i in range(len(moving['a'])))
        both = next(pair for pair in pairs if all(pair[key] in nodes[key] for key in 'ab'))
        for key in 'ab':
            self.point_at(key, *both[key])
        self.assertIn('they go together already: it changes nothing', self.said())

    def test_components(self):
        self.browser.click('#components')
        self.point_at('a', 300, 700)
        self.point_at('b', 250, 500)
        self.assertRegex(self.lines(), r'^glyph k\ncomponent \d+,\d+ \d+,\d+\n$')
        self.assertIn('each side has one component: it changes nothing', self.said())

    def test_a_hint_is_removed(self):
        for key in 'ab':
            self.point_at(key, *place(self.glyph()[key], (0, 0)))
        self.assertNotEqual(self.lines(), '')
        self.browser.click('#hints button')
        self.assertEqual(self.lines(), '')

    def test_by_keys(self):
        for key in 'ab':
            self.browser.run('document.getElementById("side-" + arguments[0]).focus()', key)
            self.browser.press('Right', 'Right', 'Enter')
        a, b = (place(self.glyph()[key], (0, 1)) for key in 'ab')
        self.assertEqual(self.lines(), 'glyph k\npoint %d,%d %d,%d\n' % (*a, *b))

    def test_the_slider_moves_what_is_between(self):
        self.browser.type('#between-at', 'Home')
        first = self.picture('#between')
        self.browser.type('#between-at', 'End')
        self.assertEqual(self.text_of('#between-value'), 'T = 1')
        self.assertNotEqual(self.picture('#between'), first)

    def test_glyphs_are_chosen(self):
        self.browser.click('#glyphs button:nth-child(3)')
        self.assertEqual(self.text_of('#editor-name'), 'W U+0057')


class Narrow(Editor):
    WINDOW = {'width': 390, 'height': 844, 'phone': True}

    def test_it_fits(self):
        self.assertEqual(self.browser.run('return [innerWidth, document.documentElement.scrollWidth]'), [390, 390])


class Report(Editor):
    COMMAND = 'report'

    def test_a_glyph_is_enlarged(self):
        self.assertEqual(self.box('#dialog')[2], 0)
        names = [glyph['name'] for glyph in data_of(self.page.read_text(encoding='utf-8'))['glyphs']]
        self.assertEqual(sorted(names), sorted('k6W'))
        self.browser.click('summary')
        self.browser.click('.strip[data-glyph="1"] .enlarge')
        self.assertGreater(self.box('#dialog')[2], 1000)
        self.assertTrue(self.text_of('#editor-name').startswith(names[1]))
        self.assertGreater(self.box('#between')[3], 200)
        self.browser.press('Escape')
        self.assertEqual(self.box('#dialog')[2], 0)

    def test_two_clicks_make_a_hint(self):
        self.browser.click('summary')
        self.browser.click('.strip[data-glyph="0"] svg')
        glyph = self.glyph()
        a, b = place(glyph['a'], (0, 0)), place(glyph['b'], (0, 1))
        self.point_at('a', *a)
        self.point_at('b', *b)
        self.assertEqual(self.lines(), f'glyph {glyph["name"]}\npoint %d,%d %d,%d\n' % (*a, *b))

    def test_what_is_folded_away_is_printed(self):
        self.assertFalse(self.browser.run('return document.querySelector("details").open'))
        self.browser.devtools('Page.printToPDF')
        self.assertTrue(self.browser.run('return document.querySelector("details").open'))


if __name__ == '__main__':
    unittest.TestCase.maxDiff = None
    in_chromium = sys.argv[1:] and sys.argv[1].split('.')[0] in IN_CHROMIUM
    cli.main(browser.PROGRAMS if in_chromium else ())
