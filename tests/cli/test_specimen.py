"""morphotype specimen: what is in the page, and the page in use, in Chromium. The latter is skipped where it is not installed."""

import base64
import hashlib
import json
import subprocess
import sys
import time
import unittest

import browser
import cli
import harfbuzz
from fontTools import ttLib
from test_report import Reader

IN_CHROMIUM = ('Grid', 'Names', 'Phone', 'Play', 'Sending', 'Slider', 'Text')
LETTERS = 'ABCDEFGHIJKLMNOPQRSTUVWXYZ abcdefghijklmnopqrstuvwxyz'
OTHERS = '0123456789.,-&ΑΩαωЖдж'


class PageReader(Reader):
    VOID = {'meta', 'link', 'input'}

    def all(self, tag):
        return [attributes for name, attributes in self.tags if name == tag]


def element(page, opening):
    """What stands between an element's opening tag and the next closing one."""
    return page.split(opening, 1)[1].split('</', 1)[0]


def data_of(page):
    return json.loads(element(page, '<script type="application/json" id="data">'))


class Specimen(cli.Test):
    def specimen(self, *arguments, fonts=(cli.SANS_BOLD, cli.SERIF), says=None):
        said = self.made('specimen', *fonts, '-o', 'x.html', *arguments)
        if says is not None:
            self.assertEqual(said, says)
        return self.path('x.html').read_text(encoding='utf-8')


class Content(Specimen):
    """The file."""

    def test_it_stands_alone(self):
        page = self.specimen('--text', 'Type', '-q', says=[])
        reader = PageReader(page)
        self.assertFalse({tag for tag, _ in reader.tags} & {'img', 'iframe', 'object', 'embed', 'base', 'form'})
        for _, attributes in reader.tags:
            self.assertFalse({name for name in attributes if name == 'src' or name.startswith('on') or name == 'style'})
        self.assertEqual([link['href'][:5] for link in reader.all('link')], ['data:'])
        self.assertIn('width=device-width', str(reader.all('meta')))
        self.assertNotIn('url(', element(page, '<style>'))

    def test_its_policy_lets_in_its_own_style_and_script_alone(self):
        page = self.specimen('--text', 'Type', '-q')
        policies = [meta['content'] for meta in PageReader(page).all('meta') if 'http-equiv' in meta]
        rules = dict(rule.split(' ', 1) for rule in policies[0].split('; '))
        self.assertEqual((len(policies), rules['default-src']), (1, "'none'"))
        self.assertEqual((rules['font-src'], rules['img-src']), ('data:', 'data:'))
        for rule, opening in (('style-src', '<style>'), ('script-src', '<script type="module">')):
            digest = base64.b64encode(hashlib.sha256(element(page, opening).encode()).digest()).decode()
            self.assertEqual(rules[rule], f"'sha256-{digest}'")

    def test_its_font_is_that_of_variable(self):
        page = self.specimen('--text', LETTERS, '-q')
        self.made('variable', cli.SANS_BOLD, cli.SERIF, '--text', LETTERS, '-q', '-o', 'x.woff2')
        start = 'data:font/woff2;base64,'
        address = element(page, '<script type="text/plain" id="font">')
        self.assertTrue(address.startswith(start))
        packed = base64.b64decode(address[len(start):], validate=True)
        self.assertEqual(packed, self.path('x.woff2').read_bytes())
        self.assertEqual(data_of(page)['bytes'], len(packed))

    def test_characters_are_grouped_by_script(self):
        data = data_of(self.specimen('--text', 'dBж1Ω. А', '--family', 'Between', '-q'))
        groups = {group['script']: group['characters'] for group in data['groups']}
        self.assertEqual(groups, {'Latn': 'Bd', 'Cyrl': 'Аж', 'Grek': 'Ω', 'Zyyy': ' .1'})
        self.assertEqual((data['family'], data['text'], data['method']), ('Between', 'dBж1Ω. А', 'joint'))
        self.assertEqual([source['file'] for source in data['sources']], [cli.SANS_BOLD.name, cli.SERIF.name])
        self.assertIn('Bitstream', data['sources'][0]['copyright'])

    def test_characters_and_a_first_text(self):
        data = data_of(self.specimen('--chars', self.write('chars', 'ABCDEF é'), '--text', 'Cab', '-q'))
        self.assertEqual((sorted(''.join(group['characters'] for group in data['groups'])), data['text']), (sorted('ABCDEFabé'), 'Cab'))

    def test_a_whole_font(self):
        font = cli.cut_font(self.path('cut.ttf'), 'ABCéж')
        page = self.specimen('-q', fonts=(font, font))
        data = data_of(page)
        self.assertEqual(sorted(''.join(group['characters'] for group in data['groups'])), sorted('ABCéж'))
        self.assertNotIn('text', data)
        self.assertEqual((data['flagged'], data['still']), ([], ''))

    def test_features_are_those_of_the_font(self):
        data = data_of(self.specimen('--text', 'fi', '-q'))
        self.made('variable', cli.SANS_BOLD, cli.SERIF, '--text', 'fi', '-q', '-o', 'x.ttf')
        font = ttLib.TTFont(self.path('x.ttf'))
        tags = {record.FeatureTag for table in ('GSUB', 'GPOS') if table in font
                for record in font[table].table.FeatureList.FeatureRecord}
        self.assertIn('liga', tags)
        self.assertEqual(data['features'], sorted(tags))

    def test_flags_are_those_of_the_report(self):
        arguments, fonts = ('--text', '一形國永', '--method', 'paper', '-q'), (cli.ZENHEI, cli.UKAI)
        data = data_of(self.specimen(*arguments, fonts=fonts))
        self.made('report', *fonts, '-o', 'x.json', *arguments)
        report = json.loads(self.path('x.json').read_bytes())
        wanted = {glyph['character']: [flag['reason'] for flag in glyph['flags']]
                  for glyph in report['glyphs'] if glyph['flags']}
        self.assertTrue(wanted)
        self.assertEqual({glyph['character']: [each['reason'] for each in glyph['reasons']] for glyph in data['flagged']},
                         wanted)

    def test_all_characters_of_a_flagged_glyph_are_flagged(self):
        fonts = cli.cut_font(self.path('cut.ttf'), 'AΑB', blank='A'), cli.cut_font(self.path('other.ttf'), 'AΑB')
        for path in fonts:
            font = ttLib.TTFont(path)
            for table in font['cmap'].tables:
                table.cmap[ord('Α')] = table.cmap[ord('A')]
            font.save(path)
        data = data_of(self.specimen('--text', 'AΑB', '-q', fonts=fonts))
        self.assertEqual([glyph['character'] for glyph in data['flagged']], ['A', 'Α'])
        for glyph in data['flagged']:
            self.assertIn('blank', glyph['reasons'][0]['reason'])

    def test_characters_of_the_first_font_alone(self):
        font = cli.cut_font(self.path('cut.ttf'), 'AB')
        data = data_of(self.specimen('--glyphs', 'first', '-q', fonts=(cli.cut_font(self.path('other.ttf'), 'ABC'), font)))
        self.assertEqual(([group['characters'] for group in data['groups']], data['still']), (['ABC'], 'C'))

    def test_more_than_two_fonts(self):
        blank = cli.cut_font(self.path('cut.ttf'), 'AB', blank='B')
        data = data_of(self.specimen('--text', 'AB', '-q', fonts=(cli.SANS_BOLD, cli.SERIF, blank)))
        self.assertEqual([source['style'] for source in data['sources']], ['Bold', 'Book', 'Book'])
        self.assertEqual([(glyph['character'], [each['step'] for each in glyph['reasons']]) for glyph in data['flagged']],
                         [('B', [1])])

    def test_same_bytes_on_any_number_of_threads(self):
        pages = {self.specimen('--text', 'RgaxyQ&@', '-q', '-j', threads) for threads in (1, 2, 5)}
        self.assertEqual(len(pages), 1)

    def test_markup_in_names_and_texts_is_none_in_the_page(self):
        hostile = '</script><script>harm()</script><!--'
        page = self.specimen('--text', '<&>"', '--family', hostile, '-q')
        plain = self.specimen('--text', '<&>"', '--family', 'Plain', '-q')
        tags, wanted = ([tag for tag, _ in PageReader(each).tags] for each in (page, plain))
        self.assertEqual(tags, wanted)
        self.assertEqual(page.count('<!--'), 0)
        self.assertEqual((data_of(page)['family'], data_of(page)['text']), (hostile, '<&>"'))


class Usage(Specimen):
    """What is refused, and what is said."""

    def test_output(self):
        fonts = (cli.SANS_BOLD, cli.SERIF)
        self.refused(2, 'specimen', *fonts, '--text', 'A', says=['-o'])
        for output in ('x', 'x.ttf', 'html', 'x.html.gz'):
            self.refused(2, 'specimen', *fonts, '--text', 'A', '-o', output, says=['.html'])
        self.refused(1, 'specimen', *fonts, '--text', 'A', '-o', 'nowhere/x.html', says=['nowhere/x.html'])
        self.path('d.html').mkdir()
        self.refused(1, 'specimen', *fonts, '--text', 'A', '-o', 'd.html', says=['d.html'])

    def test_fonts_and_characters(self):
        self.refused(2, 'specimen', cli.SERIF, '-o', 'x.html', says=['two fonts'])
        self.refused(1, 'specimen', cli.SANS_BOLD, cli.SERIF, '--text', '形', '-o', 'x.html', says=['形', 'lacks'])
        self.refused(2, 'specimen', cli.SANS_BOLD, cli.SERIF, '--at', '0.5', '-o', 'x.html', says=['--at'])

    def test_what_is_said(self):
        self.specimen('--text', 'A', says=[cli.NO_MATH])
        self.specimen('--text', 'A', '-q', says=[])
        said = self.made('specimen', cli.SANS_BOLD, cli.SERIF, '--text', 'A', '-v', '-o', 'x.html')
        self.assertEqual(said[-1], 'morphotype: x.html: 2 fonts')

    def test_a_page_is_replaced_whole_or_not_at_all(self):
        font = cli.cut_font(self.path('cut.ttf'), 'AB', blank='B')
        self.write('x.html', 'before')
        before = self.files()
        result = self.run_program('specimen', cli.SANS_BOLD, font, '--strict', '-o', 'x.html')
        self.assertEqual(result.returncode, 1)
        self.assertIn('“B” (U+0042)', result.stderr.decode())
        self.assertEqual(self.files(), before)
        page = self.specimen('--text', 'AB', fonts=(cli.SANS_BOLD, font))
        self.assertEqual([glyph['character'] for glyph in data_of(page)['flagged']], ['B'])

    def test_help(self):
        text = self.run_program('specimen', '--help').stdout.decode()
        self.assertTrue(text.startswith('usage: morphotype specimen '))
        self.assertLessEqual(max(map(len, text.splitlines())), 110)
        self.assertIn('\n  specimen ', self.run_program('--help').stdout.decode())


class InChromium(unittest.TestCase):
    """One page and one window for the tests of a class, which begin with the page as it is when it is opened. None of them may
    leave a message on the console, or ask for anything but the page and what is in it."""

    COMMAND = 'specimen'
    FONTS = (cli.SANS_BOLD, cli.SERIF)
    ARGUMENTS = ('--family', 'Between')
    READY = 'return !document.getElementById("play").disabled'
    HAS_FONT = True
    START = '#0'
    BLANK = 'Q' # the second font has no ink for it, so that it is flagged
    WINDOW = {}

    @classmethod
    def setUpClass(cls):
        cls.directory = cli.make_directory(cls.addClassCleanup)
        cls.fonts = cls.make_fonts()
        cls.page = cls.directory / 'x.html'
        subprocess.run([cli.MORPHOTYPE, cls.COMMAND, *cls.fonts, '-q', '-o', cls.page, *cls.ARGUMENTS], check=True)
        cls.browser = browser.Browser(cls.directory, **cls.WINDOW)
        cls.addClassCleanup(cls.browser.close)

    @classmethod
    def make_fonts(cls):
        text = LETTERS + OTHERS
        font = cli.cut_font(cls.directory / 'cut.ttf', text, blank=cls.BLANK)
        return (cli.SANS_BOLD, font)

    def setUp(self):
        self.browser.prefer(prefers_color_scheme='light', prefers_reduced_motion='no-preference')
        self.opened = []
        self.browser.requests()
        self.open(self.page)

    def open(self, page, place=None):
        self.opened.append(page.as_uri())
        self.browser.open('about:blank') # or else another place of the same page would be the page as it is
        self.browser.open(page.as_uri() + (self.START if place is None else place))
        self.wait(self.READY)

    def tearDown(self):
        self.assertEqual(self.browser.console(), [])
        asked = self.browser.requests()
        self.assertEqual([address for address in asked if not address.startswith(('data:', 'about:'))], self.opened)
        self.assertEqual(any(address.startswith('data:font/woff2;') for address in asked), self.HAS_FONT) # so that they would be seen

    def wait(self, script):
        """Until a script gives true; 20 seconds at most."""
        end = time.monotonic() + 20
        while not self.browser.run(script):
            self.assertLess(time.monotonic(), end, script)
            time.sleep(0.05)

    def place(self):
        return float(self.browser.run('return document.getElementById("at").value'))

    def box(self, selector):
        """Left, top, width and height in the window, pixels."""
        return self.browser.run('''const box = document.querySelector(arguments[0]).getBoundingClientRect();
            return [box.x, box.y, box.width, box.height]''', selector)

    def text_of(self, selector):
        return self.browser.run('return document.querySelector(arguments[0]).innerText', selector)

    def picture(self, selector='#text'):
        """A digest of an element's picture, as PNG, after two more frames: equal for equal pixels."""
        return hashlib.sha256(self.screenshot(selector)).hexdigest()

    def pixels(self, selector='#text'):
        """The same picture as rows of RGB."""
        path = self.directory / 'x.png'
        path.write_bytes(self.screenshot(selector))
        return cli.Image(path).rows

    def screenshot(self, selector):
        self.browser.run('return new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))')
        return self.browser.screenshot(selector)

    def drag_slider(self, share, pointer):
        """From where the thumb stands to this share of its way."""
        left, top, width, height = self.box('#at')
        thumb, middle = 22, top + height / 2
        x = [left + thumb / 2 + (width - thumb) * at for at in (self.place() / 100, share)]
        self.browser.drag((round(x[0]), round(middle)), (round(x[1]), round(middle)), pointer)


class Slider(InChromium):
    def test_keys(self):
        first = self.picture()
        self.browser.type('#at', 'End')
        self.assertEqual(self.place(), 100)
        last = self.picture()
        self.assertNotEqual(last, first)
        for keys, place in ((['Left'], 99), (['Down', 'Down'], 97), (['PageDown'], 87), (['Right', 'Up'], 89)):
            self.browser.type('#at', *keys)
            self.assertEqual(self.place(), place, keys)
        self.assertEqual(self.text_of('#value'), '89')
        self.assertNotIn(self.picture(), (first, last))
        self.browser.type('#at', 'Home')
        self.assertEqual((self.place(), self.picture()), (0, first))

    def test_the_mouse(self):
        first = self.picture()
        self.drag_slider(0.5, 'mouse')
        self.assertAlmostEqual(self.place(), 50, delta=1)
        self.assertNotEqual(self.picture(), first)

    def test_the_ends_are_the_fonts(self):
        """The text is as wide as HarfBuzz has it in each font, kerned."""
        text, size = 'AVATAR Type minimum', 40
        width = '''const text = document.getElementById('text'), range = document.createRange();
            text.style.fontSize = arguments[1];
            text.textContent = arguments[0];
            range.selectNodeContents(text);
            return range.getBoundingClientRect().width'''
        for key, font in zip(('Home', 'End'), self.fonts):
            self.browser.type('#at', key)
            units = ttLib.TTFont(font)['head'].unitsPerEm
            wanted = sum(advance for _, advance, _, _ in harfbuzz.shape(font, text)) * size / units
            self.assertAlmostEqual(self.browser.run(width, text, f'{size}px'), wanted, delta=0.5)

    def test_everything_in_sight_follows(self):
        """Text, sizes and characters, but neither the names at the slider's ends nor the five places."""
        for selector, moves in (('#family', True), ('#waterfall', True), ('.rows', True), ('#stage', True),
                                ('#places', False), ('#first', False), ('#last', False)):
            self.browser.run('document.querySelector(arguments[0]).scrollIntoView({block: "center"})', selector)
            self.browser.type('#at', 'Home')
            before = self.picture(selector)
            self.browser.type('#at', 'End')
            self.assertEqual(self.picture(selector) != before, moves, selector)

    def test_places_of_the_character(self):
        self.browser.click('.place:nth-child(4)')
        self.assertEqual(self.place(), 75)

    def test_the_address_may_have_a_place(self):
        self.browser.open('about:blank')
        self.open(self.page, '#62.5')
        self.assertEqual(self.place(), 62.5)
        self.browser.run('location.hash = "#25"')
        self.wait('return document.getElementById("at").value === "25"')

    def test_it_is_named(self):
        self.assertEqual((self.text_of('#first'), self.text_of('#last')), ('DejaVu Sans Bold', 'DejaVu Serif Book'))
        self.browser.type('#at', 'Right')
        self.assertEqual(self.browser.run('return document.getElementById("at").getAttribute("aria-valuetext")'),
                         '1 of 100 from DejaVu Sans Bold to DejaVu Serif Book')


class Sending(InChromium):
    """What is seen goes into the address, onto paper and into files."""

    def test_it_opens_half_way(self):
        self.open(self.page, '')
        self.assertEqual(self.place(), 50)

    def address(self):
        return self.browser.run('return location.hash')

    def test_the_address_restores_what_is_seen(self):
        self.browser.run('document.getElementById("text").textContent = "Hamburg & 24"')
        self.browser.type('#text', 'End', '!')
        self.browser.type('#at', 'Home', 'Right', 'Right')
        self.browser.type('#size', 'Home')
        self.browser.type('#tracking', 'End')
        self.browser.run('document.getElementById("show-features").click()')
        self.browser.click('.features [data-tag="kern"]')
        states = 'return ["at", "size", "tracking"].map(id => document.getElementById(id).value)'
        address, state = self.address(), self.browser.run(states)
        self.assertIn('features=-kern', address)
        self.open(self.page, address)
        self.assertEqual((self.browser.run(states), self.text_of('#text')), (state, 'Hamburg & 24!'))
        self.browser.run('document.getElementById("show-features").click()')
        self.assertEqual(self.browser.run('return document.querySelector(".features [data-tag=kern]").ariaPressed'), 'false')
        self.browser.run('document.getElementById("show-features").click(); document.getElementById("text").blur()')
        self.browser.run('return new Promise(done => setTimeout(done, 100))')
        self.assertEqual(self.address(), address)
        self.browser.run('document.getElementById("text").focus()')

    def test_a_damaged_address(self):
        for address in ('#at=nan&size=x&tracking=%ff&features=,,&paragraph', '#at=-5&size=1e9', '#%', '#at=1e400'):
            self.open(self.page, address)
            self.assertTrue(0 <= self.place() <= 100)

    def test_everything_is_printed_where_the_slider_stands(self):
        self.open(self.page, '#at=50')
        self.browser.devtools('Page.printToPDF')
        places = self.browser.run('return [...document.querySelectorAll(".rows")].map(each => each.style.getPropertyValue("--at"))')
        self.assertEqual(set(places), {'50'})

    def test_tracking(self):
        before = self.width()
        self.browser.type('#tracking', 'End')
        size = float(self.browser.run('return parseFloat(document.getElementById("text").style.fontSize)'))
        letters = len(self.text_of('#text'))
        self.assertAlmostEqual(self.width() - before, 0.3 * size * letters, delta=1)

    def width(self):
        return self.browser.run("""const range = document.createRange(), text = document.getElementById('text');
            text.style.whiteSpace = 'nowrap';
            range.selectNodeContents(text);
            return range.getBoundingClientRect().width""")

    def test_paragraph(self):
        before = self.text_of('#text'), self.text_of('#pixels')
        self.browser.click('#paragraph')
        self.assertEqual(self.text_of('#pixels'), '18 px')
        self.assertGreater(len(self.text_of('#text')), 400)
        self.assertLess(self.box('#text')[2], 18 * 35)
        self.browser.click('#paragraph')
        self.assertEqual((self.text_of('#text'), self.text_of('#pixels')), before)
        self.open(self.page, '#paragraph=1&size=24&text=Short')
        self.assertEqual((self.text_of('#text'), self.text_of('#pixels')), ('Short', '24 px'))

    def test_both_ends_are_drawn_over(self):
        self.browser.click('.cell[data-character="g"]')
        before = self.picture('#stage')
        self.browser.click('#ends')
        self.assertNotEqual(self.picture('#stage'), before)

    def test_the_font_and_its_style_are_saved(self):
        self.browser.devtools('Browser.setDownloadBehavior', behavior='allow', downloadPath=str(self.directory))
        self.browser.devtools('Browser.grantPermissions', permissions=['clipboardReadWrite', 'clipboardSanitizedWrite'])
        self.browser.click('#woff2')
        saved, end = self.directory / 'Between.woff2', time.monotonic() + 20
        while not saved.exists() and time.monotonic() < end:
            time.sleep(0.05)
        self.assertIn('fvar', ttLib.TTFont(saved))
        self.browser.type('#at', 'Home', 'Right')
        self.browser.click('#css')
        self.wait('return document.getElementById("exported").textContent.includes("CSS")')
        text = self.browser.run('return navigator.clipboard.readText()')
        self.assertIn('font-variation-settings: "MORF" 1;', text)
        self.assertIn('src: url("Between.woff2") format("woff2");', text)


class Play(InChromium):
    def places(self, seconds):
        seen, end = [], time.monotonic() + seconds
        while time.monotonic() < end:
            if self.place() not in seen[-1:]:
                seen.append(self.place())
            time.sleep(0.02)
        return seen

    def test_to_and_fro(self):
        first = self.picture()
        self.browser.click('#play')
        self.wait('return Number(document.getElementById("at").value) > 30')
        self.assertNotEqual(self.picture(), first)
        self.wait('return Number(document.getElementById("at").value) > 95')
        self.wait('return Number(document.getElementById("at").value) < 90')
        self.assertEqual(self.browser.run('return document.getElementById("play").ariaLabel'), 'Pause')
        self.browser.click('#play')
        self.assertEqual(self.browser.run('return document.getElementById("play").ariaLabel'), 'Play')
        self.assertEqual(len(self.places(0.5)), 1)

    def test_the_space_bar_plays_and_a_key_ends_it(self):
        self.browser.type('#at', ' ')
        self.wait('return Number(document.getElementById("at").value) > 5')
        self.browser.type('#at', 'Right')
        self.assertEqual(len(self.places(0.5)), 1)

    def test_less_motion(self):
        """It stands on each of a few places."""
        self.browser.prefer(prefers_reduced_motion='reduce')
        self.browser.click('#play')
        seen = [place for place in self.places(4) if place]
        self.assertGreaterEqual(len(seen), 2)
        self.assertEqual(seen, [25, 50, 75, 100][:len(seen)])


class Text(InChromium):
    def type_over(self, text):
        self.browser.click('#text')
        self.browser.run('getSelection().selectAllChildren(document.getElementById("text"))')
        self.browser.type('#text', text)

    def test_typing(self):
        self.assertEqual(self.text_of('#text'), 'The fonts between two fonts')
        before, sizes = self.picture(), self.picture('#waterfall')
        self.type_over('Hamburg')
        self.assertEqual(self.text_of('#text'), 'Hamburg')
        self.assertNotEqual(self.picture(), before)
        self.assertNotEqual(self.picture('#waterfall'), sizes)
        lines = self.browser.run('return [...document.querySelectorAll("#waterfall span")].map(line => line.textContent)')
        self.assertEqual(set(lines), {'Hamburg'})
        self.assertEqual(self.text_of('#missing'), '')

    def test_characters_that_the_font_has_not(self):
        self.type_over('Haus Ö形Ö')
        self.assertEqual(self.text_of('#missing'), 'Not in the font: Ö 形')

    def test_nothing_is_left(self):
        self.browser.click('#text')
        self.browser.run('document.execCommand("selectAll"); document.execCommand("delete")')
        self.assertEqual(self.browser.run('return getComputedStyle(document.getElementById("text"), "::before").content'),
                         '"Type here"')

    def test_samples(self):
        names = self.browser.run('return [...document.querySelectorAll("#samples button")].map(each => each.textContent)')
        self.assertEqual(names, []) # one script has a sample: there is nothing to choose

    def test_size(self):
        before = self.box('#text')
        self.browser.type('#size', 'End')
        self.assertEqual(self.text_of('#pixels'), '400 px')
        self.assertGreater(self.box('#text')[3], before[3])

    def test_all_sizes(self):
        sizes = self.browser.run('''return [...document.querySelectorAll("#waterfall span")].map(
            line => parseFloat(getComputedStyle(line).fontSize))''')
        self.assertEqual(sizes, sorted(set(sizes)))
        self.assertEqual((sizes[0], sizes[-1]), (12, 96))
        heights = self.browser.run('''return [...document.querySelectorAll("#waterfall .line")].map(
            line => line.getBoundingClientRect().height)''')
        self.assertEqual(heights, sorted(heights))


class Grid(InChromium):
    def cell(self, character):
        return f'.cell[data-character="{character}"]'

    def shown(self):
        return self.browser.run('return [...document.querySelectorAll(".cell")].map(each => each.dataset.character).join("")')

    def chosen(self):
        return self.browser.run('''return [document.querySelector(".cell[aria-selected=true]").dataset.character,
            document.getElementById("large").textContent, document.activeElement.dataset.character]''')

    def colours(self, selector):
        """Pixels that are red rather than grey."""
        return sum(row[i] - row[i + 2] > 60 for row in self.pixels(selector) for i in range(0, len(row), 3))

    def test_all_characters_are_there(self):
        self.assertEqual(sorted(self.shown()), sorted(LETTERS + OTHERS))
        names = self.browser.run('return [...document.querySelectorAll(".script")].map(each => each.textContent)')
        self.assertEqual(names, ['Latin', 'Greek', 'Cyrillic', 'Figures', 'Punctuation and signs'])

    def test_flagged_glyphs_are_marked(self):
        marked = self.browser.run('return [...document.querySelectorAll(".flagged")].map(each => each.title)')
        self.assertEqual(marked, ['U+0051: one font draws the character, the other leaves it blank'])
        self.browser.click(self.cell('A'))
        self.assertGreater(self.colours(self.cell('Q')), 10)
        self.assertEqual(self.colours(self.cell('R')), 0)
        self.browser.click('#only')
        self.assertEqual(self.shown(), 'Q')
        self.browser.click('#only')
        self.assertEqual(len(self.shown()), len(LETTERS + OTHERS))

    def test_everything_has_a_role_and_a_name(self):
        for selector, role, name in (
                ('#at', 'slider', 'Place between the fonts'), ('#play', 'button', 'Play'), ('#size', 'slider', 'Size'),
                ('#text', 'textbox', 'Text to set in the font'), ('#grid', 'listbox', 'Characters'),
                ('#only', 'checkbox', 'Only what needs a look: 1'), (self.cell('g'), 'option', 'g'),
                ('#glyph', 'complementary', 'The chosen character'), ('.place', 'button', '0')):
            self.assertEqual(self.browser.role(selector), (role, name))
        nodes = self.browser.devtools('Accessibility.getFullAXTree')['nodes']
        told = [node['description']['value'] for node in nodes
                if node['role']['value'] == 'option' and node['name']['value'] == 'Q']
        self.assertEqual(told, ['U+0051: one font draws the character, the other leaves it blank'])

    def test_a_click_shows_the_glyph_large(self):
        self.browser.click(self.cell('Q'))
        self.assertEqual((self.text_of('#large'), self.text_of('#code')), ('Q', 'U+0051'))
        self.assertIn('leaves it blank', self.text_of('#reasons'))
        before = self.picture('#stage')
        self.browser.click(self.cell('g'))
        self.assertEqual((self.text_of('#code'), self.text_of('#reasons')), ('U+0067', ''))
        self.assertNotEqual(self.picture('#stage'), before)
        self.assertGreater(self.box('#large')[3], 5 * self.box(self.cell('g'))[3] / 2)

    def test_keys(self):
        self.browser.click(self.cell('A'))
        columns = int(self.browser.run('return getComputedStyle(document.documentElement).getPropertyValue("--columns")'))
        below = [letter for letter in sorted(LETTERS) if letter != ' '][columns]
        for key, character in (('Right', 'B'), ('Left', 'A'), ('Down', below), ('Up', 'A'), ('k', 'k'), ('Home', 'A')):
            self.browser.press(key)
            self.assertEqual(self.chosen(), [character] * 3, key)
        self.assertEqual(self.browser.run('return document.querySelectorAll(".cell[tabindex=\'0\']").length'), 1)

    def test_thousands_are_laid_out_only_where_they_are_seen(self):
        """The page with all of Unicode's first Han block in its data: what is out of sight is neither laid out nor moved."""
        han = ''.join(map(chr, range(0x4E00, 0xA000)))
        page = self.page.read_text(encoding='utf-8')
        self.assertEqual(page.count('"groups": ['), 1)
        self.page.with_name('han.html').write_text(page.replace(
            '"groups": [', '"groups": [{"script": "Hani", "characters": "%s"},' % han), encoding='utf-8')
        self.open(self.page.with_name('han.html'))
        counts = '''const rows = [...document.querySelectorAll(".rows")], place = document.getElementById("at").value;
            return [rows.length, rows.filter(each => each.firstChild.checkVisibility({contentVisibilityAuto: true})).length,
                    rows.filter(each => each.style.getPropertyValue("--at") === place).length]'''
        self.browser.run('document.querySelectorAll(".rows")[200].scrollIntoView()')
        self.browser.type('#at', 'End')
        self.picture('.bar')
        rows, laid_out, moved = self.browser.run(counts)
        self.assertGreater(rows, 300)
        self.assertTrue(0 < moved < 12, moved)
        self.assertTrue(0 < laid_out < 60, laid_out)


class Phone(InChromium):
    WINDOW = {'width': 390, 'height': 844, 'phone': True}
    ARGUMENTS = ('--family', 'A family name that is rather long')

    def fits(self):
        self.assertEqual(self.browser.run('return [innerWidth, document.documentElement.scrollWidth]'), [390, 390])

    def test_it_fits(self):
        self.fits()
        self.browser.run('document.getElementById("show-features").click()')
        self.browser.type('#at', 'End')
        self.browser.type('#size', 'End')
        self.fits()
        self.browser.run('document.querySelector(".foot").scrollIntoView()')
        self.fits()

    def test_a_finger_on_the_slider(self):
        first = self.picture()
        self.drag_slider(0.6, 'touch')
        self.assertAlmostEqual(self.place(), 60, delta=2)
        self.assertNotEqual(self.picture(), first)

    def test_a_tap_brings_up_the_sheet(self):
        cell = '.cell[data-character="Q"]'
        self.assertEqual(self.box('#glyph')[3], 0)
        self.browser.run('document.querySelector(".characters").scrollIntoView()')
        self.browser.run('scrollBy(0, document.querySelector(arguments[0]).getBoundingClientRect().bottom - innerHeight)', cell)
        left, top, width, height = self.box(cell) # at the window's lower edge
        self.browser.drag((round(left + width / 2), round(top + height / 2)),
                          (round(left + width / 2), round(top + height / 2)), 'touch')
        self.assertIn('leaves it blank', self.text_of('#reasons'))
        sheet, seen = self.box('#glyph'), self.box(cell)
        self.assertLessEqual(sheet[1] + sheet[3], 844)
        self.assertLessEqual(seen[1] + seen[3], sheet[1])
        self.fits()
        self.browser.click('#close')
        self.assertEqual(self.box('#glyph')[3], 0)

    def test_dark(self):
        light = self.paper_and_ink()
        self.browser.prefer(prefers_color_scheme='dark')
        dark = self.paper_and_ink()
        self.assertTrue(min(light[0]) > 230 and max(light[1]) < 60, light)
        self.assertTrue(max(dark[0]) < 60 and min(dark[1]) > 200, dark)

    def paper_and_ink(self):
        """The commonest colour of the text's picture, and the one that is furthest from it."""
        pixels = [tuple(row[i:i + 3]) for row in self.pixels() for i in range(0, len(row), 3)]
        paper = max(set(pixels), key=pixels.count)
        return paper, max(set(pixels), key=lambda pixel: sum(abs(a - b) for a, b in zip(pixel, paper)))

    def test_contrast(self):
        """Of all texts in the page's colours, by WCAG 2.2, 1.4.3."""
        for scheme in ('light', 'dark'):
            self.browser.prefer(prefers_color_scheme=scheme)
            colours = self.browser.run('''const style = getComputedStyle(document.documentElement);
                return ["paper", "wash", "ink", "quiet", "mark"].map(name => style.getPropertyValue(`--${name}`).trim())''')
            paper, wash, *inks = (self.luminance(colour) for colour in colours)
            for ink in inks:
                for ground in (paper, wash):
                    least, most = sorted((ink, ground))
                    self.assertGreaterEqual((most + 0.05) / (least + 0.05), 4.5, (scheme, colours))

    @staticmethod
    def luminance(colour):
        parts = [int(colour[i:i + 2], 16) / 255 for i in (1, 3, 5)]
        red, green, blue = (part / 12.92 if part <= 0.03928 else ((part + 0.055) / 1.055) ** 2.4 for part in parts)
        return 0.2126 * red + 0.7152 * green + 0.0722 * blue


class Names(InChromium):
    """Fonts whose names are markup."""

    HOSTILE = '</script><script>window.harm = 1</script><img src=x onerror="window.harm = 2">&amp;'
    ARGUMENTS = ('--family', HOSTILE)

    @classmethod
    def make_fonts(cls):
        font = ttLib.TTFont(cli.cut_font(cls.directory / 'cut.ttf', LETTERS))
        for number in (0, 1, 5, 13, 16):
            font['name'].setName(cls.HOSTILE, number, 3, 1, 0x409)
        font['name'].setName('javascript:window.harm=3', 14, 3, 1, 0x409)
        font.save(cls.directory / '<b>&.ttf')
        return (cls.directory / '<b>&.ttf', cls.directory / 'cut.ttf')

    def test_they_do_no_harm(self):
        self.assertIsNone(self.browser.run('return window.harm'))
        self.assertEqual(self.browser.run('return document.title'), f'{self.HOSTILE}: a specimen')
        self.assertEqual(self.text_of('#family'), self.HOSTILE)
        self.assertTrue(self.text_of('#first').startswith(self.HOSTILE))
        self.assertEqual(self.text_of('#sources').count(self.HOSTILE), 3) # its name, version and copyright
        self.assertIn('javascript:', self.text_of('#sources'))
        self.assertEqual(self.browser.run('return document.querySelectorAll("a[href^=javascript], img").length'), 0)
        self.assertIn('<b>&.ttf', self.text_of('#colophon'))


if __name__ == '__main__':
    unittest.TestCase.maxDiff = None
    in_chromium = sys.argv[1:] and sys.argv[1].split('.')[0] in IN_CHROMIUM
    cli.main(browser.PROGRAMS if in_chromium else ())
