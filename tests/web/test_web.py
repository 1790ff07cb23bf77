"""The page that needs no install, in Chromium, against the command line: the same bytes and the same words. Run by tools/web --check."""

import functools
import http.server
import io
import os
import pathlib
import sys
import threading
import time
import unittest
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / 'tests' / 'cli'), str(ROOT / 'tests' / 'oracles')]

import browser
import cli
import oracles

PAGE = pathlib.Path(os.environ['PAGE'])
SANS = cli.DEBIAN / 'truetype/dejavu/DejaVuSans.ttf'
STEM = 'MorphotypeDemoSans-MorphotypeDemoSerif'
RATIO_MOST = 3 # of the page's time to that of the command line on one thread
LARGE = 200_000_000


class Server(http.server.ThreadingHTTPServer):
    """The page's folder on this machine, and what was asked for."""

    def __init__(self):
        self.asked = []
        super().__init__(('127.0.0.1', 0), functools.partial(Handler, directory=str(PAGE.parent)))
        threading.Thread(target=self.serve_forever, daemon=True).start()

    @property
    def page(self):
        return f'http://127.0.0.1:{self.server_address[1]}/{PAGE.name}'


class Handler(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_):
        self.server.asked.append(self.path)


class Window(browser.Browser):
    """The page in a window; what it saves comes to `directory`."""

    def __init__(self, directory, **size):
        super().__init__(directory, **size)
        self.directory = directory
        self.devtools('Browser.setDownloadBehavior', behavior='allow', downloadPath=str(directory))

    def wait(self, condition, seconds=60):
        """The value of an expression once it is one."""
        end = time.monotonic() + seconds
        while not (value := self.run(f'return {condition}')):
            assert time.monotonic() < end, f'waited for {condition}'
            time.sleep(0.05)
        return value

    def choose(self, *fonts):
        for place, font in zip(('#first', '#second'), fonts):
            self.type(place, str(font))

    def end_of_work(self, seconds=60):
        self.wait('document.getElementById("work").hidden', seconds)

    def make(self, *fonts, seconds=60):
        self.choose(*fonts)
        self.click('#make')
        self.end_of_work(seconds)

    def make_demo(self):
        self.click('#demo')
        self.end_of_work()

    def text(self, selector):
        return self.run('return document.querySelector(arguments[0]).textContent', selector)

    def is_made(self):
        return not self.run('return document.getElementById("result").hidden')

    def saved(self, button, name):
        """The bytes of what a button saves."""
        self.click(button)
        path, end = self.directory / name, time.monotonic() + 60
        while not path.exists():
            assert time.monotonic() < end, f'waited for {name}'
            time.sleep(0.05)
        return path.read_bytes()


class Test(cli.Test):
    def open(self, address=PAGE.as_uri(), **size):
        window = Window(cli.make_directory(self.addCleanup), **size) # not the test's: Chromium writes there all the time
        self.addCleanup(window.close)
        window.open(address)
        return window


class Bytes(Test):
    def test_whole(self):
        """All characters of DejaVu Sans and Serif: the same bytes, and the time that they take."""
        start = time.monotonic()
        self.made('variable', SANS, cli.SERIF, '-q', '-j', '1', '-o', 'x.ttf')
        native = time.monotonic() - start
        window = self.open()
        start = time.monotonic()
        window.make(SANS, cli.SERIF, seconds=1200)
        page = time.monotonic() - start
        print(f'{page:.1f} s, the command line on one thread {native:.1f} s: {page / native:.2f} times')
        self.assertTrue(window.saved('#ttf', 'DejaVuSans-DejaVuSerif.ttf') == self.path('x.ttf').read_bytes())
        self.assertLessEqual(page / native, RATIO_MOST)

    def test_formats(self):
        window = self.open()
        window.make_demo()
        for extension in ('ttf', 'woff2'):
            name = f'{STEM}.{extension}'
            self.made('variable', cli.DEMO_SANS, cli.DEMO_SERIF, '-q', '-o', name)
            self.assertEqual(window.saved(f'#{extension}', name), self.path(name).read_bytes())
        name = f'{STEM}.html'
        self.made('specimen', cli.DEMO_SANS, cli.DEMO_SERIF, '-q', '-o', name)
        self.assertEqual(window.saved('#html', name).decode(), self.path(name).read_text())

    def test_masters(self):
        window = self.open()
        window.make_demo()
        with zipfile.ZipFile(io.BytesIO(window.saved('#designspace', f'{STEM}.zip'))) as made:
            self.assertIsNone(made.testzip())
            files = {name: made.read(name) for name in made.namelist()}
        folder = self.path('masters')
        folder.mkdir()
        self.made('variable', cli.DEMO_SANS, cli.DEMO_SERIF, '-q', '-o', f'masters/{STEM}.designspace')
        self.assertEqual(files, {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob('*') if path.is_file()})


class Use(Test):
    def test_nothing_is_asked_for(self):
        """The page alone comes from its server, and works on when that is gone."""
        server = Server()
        window = self.open(server.page)
        server.shutdown()
        server.server_close()
        window.make_demo()
        self.assertTrue(window.is_made())
        self.assertEqual(server.asked, [f'/{PAGE.name}'])
        asked = [address for address in window.requests() if not address.startswith(('blob:', 'data:', 'about:', 'chrome:'))]
        self.assertEqual(set(asked), {server.page})

    def test_it_would_be_refused(self):
        window = self.open()
        self.assertTrue(window.run('return fetch("https://example.org/").then(() => false, () => true)'))
        self.assertTrue(any('Content Security Policy' in entry['message'] for entry in window.console()))

    def test_specimen(self):
        """The specimen in its frame shows the font."""
        window = self.open()
        window.make_demo()
        window.call('POST', '/frame', {'id': {browser.ELEMENT: window.find('#specimen')}})
        window.wait('!document.getElementById("at").disabled')
        self.assertIn('Morphotype', window.text('#family'))
        self.assertFalse(window.run('return !document.getElementById("problem").hidden'))

    def test_keys(self):
        window = self.open()
        for _ in range(3):
            window.press('Tab')
        self.assertEqual(window.run('return document.activeElement.id'), 'demo')
        window.press('Enter')
        window.end_of_work()
        self.assertEqual(window.run('return document.activeElement.id'), 'result-heading')

    def test_cancel(self):
        window = self.open()
        window.choose(SANS, cli.SERIF)
        window.click('#make')
        window.wait('document.getElementById("bar").value > 0')
        window.click('#cancel')
        self.assertEqual(window.text('#status'), 'Cancelled.')
        self.assertFalse(window.is_made())
        window.make_demo()
        self.assertTrue(window.is_made())

    def test_drop(self):
        """Two files that are dropped are both fonts, whatever else there is."""
        window = self.open()
        window.run('''const transfer = new DataTransfer();
            for (const name of ["A.ttf", "B.otf"]) transfer.items.add(new File(["x"], name));
            document.body.dispatchEvent(new DragEvent("drop", {dataTransfer: transfer, bubbles: true, cancelable: true}))''')
        self.assertEqual((window.text('#first-name'), window.text('#second-name')), ('A.ttf', 'B.otf'))
        self.assertFalse(window.run('return document.getElementById("make").disabled'))


class Bad(Test):
    """What is no font: the line of the command line, and a page that goes on working."""

    def refused_alike(self, window, first, second):
        line = self.refused(1, 'variable', first, second, '-o', 'x.ttf').removeprefix('morphotype: ').rstrip()
        window.make(self.path(first), self.path(second))
        self.assertEqual(window.text('#problem'), line)
        self.assertFalse(window.is_made())

    def test_files(self):
        window = self.open()
        self.write('good.ttf', cli.SERIF.read_bytes())
        self.write('empty.ttf', b'')
        self.write('cut.ttf', cli.SERIF.read_bytes()[:100000])
        self.write('x.pdf', b'%PDF-1.7\n' + bytes(range(256)) * 64)
        self.write('# named @ oddly: \u2068.ttf', b'no font')
        with open(self.path('large.ttf'), 'wb') as file:
            file.truncate(LARGE)
        for name in ('empty.ttf', 'cut.ttf', 'x.pdf', '# named @ oddly: \u2068.ttf', 'large.ttf'):
            self.refused_alike(window, name, 'good.ttf')
            self.refused_alike(window, 'good.ttf', name)
        window.make_demo()
        self.assertTrue(window.is_made())
        self.assertEqual(window.text('#problem'), '')

    def test_nothing_shared(self):
        cli.cut_font(self.path('a.ttf'), 'a')
        cli.cut_font(self.path('b.ttf'), 'b')
        self.refused_alike(self.open(), 'a.ttf', 'b.ttf')


class Looks(Test):
    @classmethod
    def setUpClass(cls):
        cls.axe = (oracles.Oracles(os.environ['ORACLES']).directory / 'node_modules' / 'axe-core' / 'axe.min.js').read_text()

    def look(self, window, state):
        """What axe finds serious or critical, in light and in dark, and what is wider than the window."""
        for scheme in ('light', 'dark'):
            window.prefer(prefers_color_scheme=scheme)
            found = window.run(self.axe + '; return axe.run(document, {iframes: false}).then(result => result.violations)')
            found = [(each['id'], [node['html'][:160] for node in each['nodes'][:3]])
                     for each in found if each['impact'] in ('serious', 'critical')]
            self.assertEqual(found, [], (state, scheme))
        self.assertLessEqual(*window.run('return [document.documentElement.scrollWidth, innerWidth]'), state)

    def look_at_all(self, **size):
        window = self.open(**size)
        self.look(window, 'opened')
        window.choose(SANS, cli.SERIF)
        window.click('#make')
        window.wait('document.getElementById("bar").value > 0')
        self.look(window, 'at work')
        window.click('#cancel')
        window.make(self.write('x.pdf', b'%PDF-1.7'), cli.SERIF)
        self.look(window, 'refused')
        window.make_demo()
        self.look(window, 'made')

    def test_wide(self):
        self.look_at_all(width=1280, height=900)

    def test_phone(self):
        self.look_at_all(width=390, height=844, phone=True)


if __name__ == '__main__':
    cli.main((*oracles.PROGRAMS, *browser.PROGRAMS))
