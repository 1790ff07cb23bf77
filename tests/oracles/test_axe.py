"""The pages of specimen, report and inspect, judged by axe-core in Chromium: light and dark, wide and narrow."""

import os
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / 'tests' / 'cli')]

import browser
import cli
import oracles

FONTS = (cli.SANS_BOLD, cli.SERIF)
PAGES = {
    'specimen': ('--text', 'Between fonts'),
    'report': ('--text', 'ab&%'),
    'inspect': ('--text', 'kg'),
}
# What a page is like when it is looked at, besides as it is opened.
STATES = {
    'specimen': 'document.querySelector(".cell").click()',
    'report': 'document.querySelector("details").open = true; document.querySelector(".strip").click()',
    'inspect': '''for (const id of ["side-a", "side-b"])
        document.getElementById(id).dispatchEvent(new KeyboardEvent("keydown", {key: "Enter"}))''',
}


class Pages(cli.Test):
    @classmethod
    def setUpClass(cls):
        cls.axe = (oracles.Oracles(os.environ['ORACLES']).directory / 'node_modules' / 'axe-core' / 'axe.min.js').read_text()

    def serious(self, window):
        """What axe finds serious or critical."""
        found = window.run(self.axe + '; return axe.run(document).then(result => result.violations)')
        return [(each['id'], each['impact'], [node['html'][:160] for node in each['nodes'][:3]])
                for each in found if each['impact'] in ('serious', 'critical')]

    def look(self, **size):
        directory = self.path(str(size['width']))
        directory.mkdir()
        window = browser.Browser(directory, **size)
        self.addCleanup(window.close)
        for command in PAGES:
            for scheme in ('light', 'dark'):
                window.prefer(prefers_color_scheme=scheme)
                window.open(self.path(f'{command}.html').as_uri())
                self.assertEqual(self.serious(window), [], (command, scheme, size))
                window.run(STATES[command])
                self.assertEqual(self.serious(window), [], (command, scheme, size, 'in use'))

    def test_it_would_be_found(self):
        """A picture without a text, and text that is hard to read."""
        self.made('inspect', *FONTS, '-q', *PAGES['inspect'], '-o', 'x.html')
        window = browser.Browser(self.directory)
        self.addCleanup(window.close)
        window.open(self.path('x.html').as_uri())
        window.run('document.querySelector("main").append(new Image()); document.querySelector("h1").style.color = "#eee"')
        self.assertEqual({name for name, *_ in self.serious(window)}, {'image-alt', 'color-contrast'})

    def test_nothing_is_serious(self):
        for command, arguments in PAGES.items():
            self.made(command, *FONTS, '-q', *arguments, '-o', f'{command}.html')
        self.look(width=1280, height=900)
        self.look(width=390, height=844, phone=True)


if __name__ == '__main__':
    cli.main((*oracles.PROGRAMS, *browser.PROGRAMS))
