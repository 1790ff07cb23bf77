"""Blended fonts in use: pages set by Chromium and by LibreOffice, in several scripts, whose text must be as wide as HarfBuzz has it
and whose ink must lie where the outlines say. Skipped where these programs are not installed."""

import base64
import html
import json
import re
import shutil
import subprocess
import sys

import cli
import harfbuzz
from fontTools import ttLib

NEEDS = {'Chromium': ['chromium'], 'LibreOffice': ['soffice', 'pdffonts', 'pdftotext'],
         'Scripts': ['chromium', 'ots-sanitize', 'soffice', 'pdffonts']}
LINES = ('AVATAR Type', 'Wave To P.', 'Хлеба ГДА', 'Ώρα Λάθη')
FAMILY = 'Between Ü'
SIZE = 64


class Typeset(cli.Test):
    """A font of few characters, half-way between two, and what HarfBuzz and its outlines say of each line."""

    def setUp(self):
        super().setUp()
        self.blend('x.ttf')
        self.font = ttLib.TTFont(self.path('x.ttf'))
        self.scale = SIZE / self.font['head'].unitsPerEm

    def blend(self, output):
        self.made('blend', cli.SANS_BOLD, cli.SERIF, '--text', ''.join(LINES), '--family', FAMILY, '-o', output)
        return self.path(output)

    def width(self, line):
        return sum(advance for _, advance, _, _ in harfbuzz.shape(self.path('x.ttf'), line)) * self.scale

    def ink(self, line):
        """The box around the line's outlines from its start on the baseline: left, right, bottom and top."""
        glyphs, order, x, boxes = self.font['glyf'], self.font.getGlyphOrder(), 0, []
        for number, advance, x_offset, y_offset in harfbuzz.shape(self.path('x.ttf'), line):
            glyph = glyphs[order[number]]
            if glyph.numberOfContours:
                boxes.append((x + x_offset + glyph.xMin, x + x_offset + glyph.xMax, y_offset + glyph.yMin,
                              y_offset + glyph.yMax))
            x += advance
        lefts, rights, bottoms, tops = zip(*boxes)
        return [value * self.scale for value in (min(lefts), max(rights), min(bottoms), max(tops))]

    def run_quietly(self, *command, **variables):
        home = self.path('home')
        home.mkdir(exist_ok=True)
        environment = {'HOME': home, 'PATH': '/usr/bin:/bin', 'LC_ALL': 'C.UTF-8', **variables}
        return subprocess.run(command, env=environment, cwd=self.directory, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, check=True, timeout=120).stdout.decode()


class Chromium(Typeset):
    """A web page with the font in it."""

    LEFT, LINE, WIDTH = 20, 120, 800
    SCRIPT = '''
        document.fonts.load('SIZEpx Blend', document.body.textContent).then(faces => {
            const lines = [...document.querySelectorAll('span')].map(line =>
                ({width: line.getBoundingClientRect().width, baseline: line.lastChild.getBoundingClientRect().bottom}));
            document.body.dataset.measured = JSON.stringify({faces: faces.length, lines: lines});
        });'''

    def page(self, font):
        """One line each LINE pixels; an empty box at its end stands on the baseline."""
        data = base64.b64encode(font.read_bytes()).decode()
        lines = ''.join(f'<span style="top: {i * self.LINE}px">{html.escape(line)}<i></i></span>'
                        for i, line in enumerate(LINES))
        return self.write('page.html', f'''<!DOCTYPE html>
            <html><head><meta charset="utf-8"><title>Blend</title><style>
            @font-face {{ font-family: Blend; src: url(data:font/{font.suffix[1:]};base64,{data}) }}
            body {{ margin: 0 }}
            span {{ position: absolute; left: {self.LEFT}px; font: {SIZE}px/{self.LINE}px Blend; white-space: pre }}
            i {{ display: inline-block; width: 0; height: 0 }}
            </style></head><body>{lines}<script>{self.SCRIPT.replace('SIZE', str(SIZE))}</script></body></html>''')

    def chromium(self, page, *arguments):
        return self.run_quietly('chromium', '--headless', '--no-sandbox', '--disable-gpu', '--no-first-run',
                                '--disable-background-networking', '--disable-dev-shm-usage', '--hide-scrollbars', '--force-device-scale-factor=1',
                                f'--window-size={self.WIDTH},{self.LINE * len(LINES)}', '--virtual-time-budget=5000',
                                f'--user-data-dir={self.path("profile")}', *arguments, page.as_uri())

    def measured(self, font):
        """What the page's script found of the lines, once the font is there."""
        dom = self.chromium(self.page(font), '--dump-dom')
        measured = json.loads(html.unescape(re.search('data-measured="([^"]*)"', dom)[1]))
        self.assertEqual(measured['faces'], 1)
        return measured['lines']

    def test_widths(self):
        for font in (self.path('x.ttf'), self.blend('x.woff2')):
            for line, found in zip(LINES, self.measured(font), strict=True):
                self.assertAlmostEqual(found['width'], self.width(line), delta=0.5, msg=f'{font.name}: {line}')

    def test_ink(self):
        lines = self.measured(self.path('x.ttf'))
        self.chromium(self.path('page.html'), f'--screenshot={self.path("page.png")}')
        image = cli.Image(self.path('page.png'))
        for i, line in enumerate(LINES):
            left, right, bottom, top = self.ink(line)
            baseline = lines[i]['baseline']
            wanted = [self.LEFT + left, self.LEFT + right, baseline - top, baseline - bottom]
            for value, found in zip(wanted, image.box(i * self.LINE, (i + 1) * self.LINE), strict=True):
                self.assertAlmostEqual(found, value, delta=1.5, msg=line)


class LibreOffice(Typeset):
    """A text document, set in the font where it is installed, as a PDF."""

    def document(self):
        lines = ''.join(f'<text:p>{html.escape(line)}</text:p>' for line in LINES)
        spaces = ' '.join(f'xmlns:{name}="urn:oasis:names:tc:opendocument:xmlns:{where}:1.0"' for name, where in (
            ('office', 'office'), ('style', 'style'), ('text', 'text'), ('fo', 'xsl-fo-compatible'),
            ('svg', 'svg-compatible')))
        return self.write('page.fodt', f'''<?xml version="1.0" encoding="UTF-8"?>
            <office:document {spaces} office:version="1.3" office:mimetype="application/vnd.oasis.opendocument.text">
            <office:font-face-decls><style:font-face style:name="Blend" svg:font-family="'{FAMILY}'"/></office:font-face-decls>
            <office:styles><style:default-style style:family="paragraph"><style:text-properties style:font-name="Blend"
            fo:font-size="{SIZE}pt" style:letter-kerning="true" fo:language="en" fo:country="US"/></style:default-style>
            </office:styles><office:body><office:text>{lines}</office:text></office:body></office:document>''')

    def install(self):
        """A set-up of fontconfig that knows this font alone."""
        self.path('fonts').mkdir()
        shutil.copy(self.path('x.ttf'), self.path('fonts'))
        return self.write('fonts.conf', f'''<?xml version="1.0"?><!DOCTYPE fontconfig SYSTEM "fonts.dtd">
            <fontconfig><dir>{self.path('fonts')}</dir><cachedir>{self.path('cache')}</cachedir></fontconfig>''')

    def test_widths(self):
        configuration, document = self.install(), self.document()
        self.run_quietly('soffice', f'-env:UserInstallation={self.path("profile").as_uri()}', '--headless', '--convert-to',
                         'pdf', document, FONTCONFIG_FILE=configuration)
        fonts = self.run_quietly('pdffonts', 'page.pdf').splitlines()[2:]
        self.assertEqual(len(fonts), 1, fonts)
        name = self.font['name'].getDebugName(6)
        self.assertRegex(fonts[0], rf'^[A-Z]{{6}}\+{re.escape(name)} +\S+.* yes yes yes ')
        text = self.run_quietly('pdftotext', '-bbox', 'page.pdf', '-')
        words = [(float(left), float(right), html.unescape(word)) for left, right, word in
                 re.findall('<word xMin="([^"]*)" yMin="[^"]*" xMax="([^"]*)" yMax="[^"]*">([^<]*)</word>', text)]
        self.assertEqual([word for _, _, word in words], ' '.join(LINES).split())
        for line in LINES:
            parts, words = words[:len(line.split())], words[len(line.split()):]
            self.assertAlmostEqual(parts[-1][1] - parts[0][0], self.width(line), delta=1, msg=line)


class Scripts(Typeset):
    """Blends and variable fonts of other scripts, half-way: taken by the sanitizer, fontTools, Chromium and LibreOffice."""

    NOTO, TRUETYPE = cli.DEBIAN / 'truetype/noto', cli.DEBIAN / 'truetype'
    PAIRS = {
        'Arabic': (NOTO / 'NotoSansArabic-Regular.ttf', TRUETYPE / 'dejavu/DejaVuSans.ttf', 'السلام عليكم'),
        'Devanagari': (TRUETYPE / 'lohit-devanagari/Lohit-Devanagari.ttf', TRUETYPE / 'annapurna/AnnapurnaSIL-Regular.ttf',
                       'कर्म हिन्दी'),
        'Thai': (TRUETYPE / 'tlwg/Garuda.ttf', TRUETYPE / 'tlwg/Norasi.ttf', 'สวัสดี น้ำ'),
        'Khmer': (NOTO / 'NotoSansKhmer-Regular.ttf', NOTO / 'NotoSerifKhmer-Bold.ttf', 'ភាសា ខ្មែរ'),
        'Code': (TRUETYPE / 'firacode/FiraCode-Regular.ttf', TRUETYPE / 'jetbrains-mono/JetBrainsMono-Bold.ttf',
                 'a::b != c'),
    }

    def setUp(self):
        cli.Test.setUp(self)
        (self.path('fonts')).mkdir()
        for name, (a, b, text) in self.PAIRS.items():
            for command, place in (('blend', None), ('variable', 50)):
                self.made(command, a, b, '--text', text, '--family', f'{name} {command}', '-o', f'fonts/{name}-{command}.ttf')

    def fonts(self):
        """Name, file, place on the axis or None, and text of each."""
        for name, (_, _, text) in self.PAIRS.items():
            yield f'{name} blend', self.path(f'fonts/{name}-blend.ttf'), None, text
            yield f'{name} variable', self.path(f'fonts/{name}-variable.ttf'), 50, text

    def test_accepted(self):
        for name, path, _, _ in self.fonts():
            with self.subTest(name):
                subprocess.run(['ots-sanitize', path], check=True, stdout=subprocess.DEVNULL)
                font = ttLib.TTFont(path)
                for tag in font.keys():
                    if hasattr(font[tag], 'table'):
                        font[tag].table.ensureDecompiled(recurse=True)

    def test_chromium(self):
        faces, lines = '', ''
        for name, path, place, text in self.fonts():
            faces += f"@font-face {{ font-family: '{name}'; src: url({path.as_uri()}) }}\n"
            varied = f"font-variation-settings: 'MORF' {place};" if place is not None else ''
            lines += f'<div><span style="font-family: \'{name}\'; {varied}">{html.escape(text)}</span></div>\n'
        page = self.write('page.html', f'''<!DOCTYPE html>
            <html><head><meta charset="utf-8"><title>Scripts</title><style>{faces}
            span {{ font-size: {SIZE}px; white-space: pre }}</style></head><body>{lines}<script>
            Promise.all([...document.querySelectorAll('span')].map(async line => {{
                const faces = await document.fonts.load('{SIZE}px ' + line.style.fontFamily, line.textContent);
                return {{faces: faces.length, line}};
            }})).then(all => document.body.dataset.measured = JSON.stringify(all.map(({{faces, line}}) =>
                ({{faces, width: line.getBoundingClientRect().width}}))));</script></body></html>''')
        dom = self.run_quietly('chromium', '--headless', '--no-sandbox', '--disable-gpu', '--no-first-run',
                               '--disable-background-networking', '--disable-dev-shm-usage', '--allow-file-access-from-files',
                               '--virtual-time-budget=5000', f'--user-data-dir={self.path("profile")}', '--dump-dom',
                               page.as_uri())
        measured = json.loads(html.unescape(re.search('data-measured="([^"]*)"', dom)[1]))
        for found, (name, path, place, text) in zip(measured, self.fonts(), strict=True):
            with harfbuzz.Font(path, place) as font:
                width = sum(advance for _, advance, _, _ in font.shape(text))
            self.assertEqual(found['faces'], 1, name)
            self.assertAlmostEqual(found['width'], width * SIZE / ttLib.TTFont(path)['head'].unitsPerEm, delta=1, msg=name)

    def test_libreoffice(self):
        spaces = ' '.join(f'xmlns:{name}="urn:oasis:names:tc:opendocument:xmlns:{where}:1.0"' for name, where in (
            ('office', 'office'), ('style', 'style'), ('text', 'text'), ('fo', 'xsl-fo-compatible'), ('svg', 'svg-compatible')))
        fonts = [(name, text) for name, _, _, text in self.fonts()]
        faces = ''.join(f'<style:font-face style:name="{name}" svg:font-family="\'{name}\'"/>' for name, _ in fonts)
        styles = ''.join(f'<style:style style:name="P{i}" style:family="paragraph"><style:text-properties '
                         f'style:font-name="{name}" style:font-name-complex="{name}"/></style:style>'
                         for i, (name, _) in enumerate(fonts))
        lines = ''.join(f'<text:p text:style-name="P{i}">{html.escape(text)}</text:p>' for i, (_, text) in enumerate(fonts))
        document = self.write('page.fodt', f'''<?xml version="1.0" encoding="UTF-8"?>
            <office:document {spaces} office:version="1.3" office:mimetype="application/vnd.oasis.opendocument.text">
            <office:font-face-decls>{faces}</office:font-face-decls><office:automatic-styles>{styles}</office:automatic-styles>
            <office:body><office:text>{lines}</office:text></office:body></office:document>''')
        configuration = self.write('fonts.conf', f'''<?xml version="1.0"?><!DOCTYPE fontconfig SYSTEM "fonts.dtd">
            <fontconfig><dir>{self.path('fonts')}</dir><cachedir>{self.path('cache')}</cachedir></fontconfig>''')
        self.run_quietly('soffice', f'-env:UserInstallation={self.path("profile").as_uri()}', '--headless', '--convert-to',
                         'pdf', document, FONTCONFIG_FILE=configuration)
        embedded = self.run_quietly('pdffonts', 'page.pdf')
        for name, path, _, _ in self.fonts():
            postscript = ttLib.TTFont(path)['name'].getDebugName(6)
            self.assertRegex(embedded, rf'(?m)^[A-Z]{{6}}\+{re.escape(postscript)} ')


if __name__ == '__main__':
    cli.main(NEEDS[sys.argv[1]])
