"""morphotype animate: vectors, pictures, videos, and what it refuses."""

import json
import math
import random
import re
import struct
import sys
import unittest
import xml.etree.ElementTree
import zlib

from fontTools import ttLib
from fontTools.pens.areaPen import AreaPen
from fontTools.pens.recordingPen import DecomposingRecordingPen

import cli

try:
    from PIL import Image, ImageSequence
except ImportError:
    Image = None

SVG = '{http://www.w3.org/2000/svg}'
PATH_EM = 4000 # units an em of path data
SANS, SERIF = cli.DEMO_SANS, cli.DEMO_SERIF


def path_points(data):
    """The commands of path data with relative numbers, and its points as they stand: on and off the curve."""
    commands = re.findall(r'([mlqz])([^mlqz]*)', data)
    assert ''.join(c + n for c, n in commands) == data, data[:80]
    x = y = 0
    points = []
    for command, numbers in commands:
        values = [int(n) for n in re.findall(r'-?\d+', numbers)]
        assert len(values) == {'m': 2, 'l': 2, 'q': 4, 'z': 0}[command], (command, numbers)
        points += [(x + dx, y + dy) for dx, dy in zip(values[::2], values[1::2])]
        if values:
            x, y = x + values[-2], y + values[-1]
    return ''.join(command for command, _ in commands), points


def path_lines(data, steps=4):
    """Path data as polygons."""
    polygons, x, y = [], 0, 0
    for command, numbers in re.findall(r'([mlqz])([^mlqz]*)', data):
        v = [int(n) for n in re.findall(r'-?\d+', numbers)]
        if command == 'm':
            polygons.append([(x + v[0], y + v[1])])
        elif command == 'l':
            polygons[-1].append((x + v[0], y + v[1]))
        elif command == 'q':
            for i in range(1, steps + 1):
                t = i / steps
                polygons[-1].append((x + 2 * (1 - t) * t * v[0] + t * t * v[2], y + 2 * (1 - t) * t * v[1] + t * t * v[3]))
        if v:
            x, y = x + v[-2], y + v[-1]
    return polygons


def font_lines(path, name, steps=4):
    """A glyph's outline as polygons in em, y upwards, and its advance."""
    font = ttLib.TTFont(path)
    glyphs, em = font.getGlyphSet(), font['head'].unitsPerEm
    pen = DecomposingRecordingPen(glyphs)
    glyphs[name].draw(pen)
    polygons = []
    for operator, points in pen.value:
        if operator == 'moveTo':
            polygons.append([points[0]])
        elif operator == 'lineTo':
            polygons[-1].append(points[0])
        elif operator == 'curveTo':
            p0, (p1, p2, p3) = polygons[-1][-1], points
            for i in range(1, steps + 1):
                t = i / steps
                polygons[-1].append(tuple((1 - t) ** 3 * a + 3 * (1 - t) ** 2 * t * b + 3 * (1 - t) * t * t * c + t ** 3 * d
                                          for a, b, c, d in zip(p0, p1, p2, p3)))
        elif operator == 'qCurveTo':
            offs = list(points[:-1])
            ons = [((a[0] + b[0]) / 2, (a[1] + b[1]) / 2) for a, b in zip(offs, offs[1:])] + [points[-1]]
            for off, on in zip(offs, ons):
                p0 = polygons[-1][-1]
                for i in range(1, steps + 1):
                    t = i / steps
                    polygons[-1].append(tuple((1 - t) ** 2 * a + 2 * (1 - t) * t * b + t * t * c for a, b, c in zip(p0, off, on)))
    return [[(x / em, y / em) for x, y in p] for p in polygons], glyphs[name].width / em


def glyph_area(path, name):
    """Square em."""
    font = ttLib.TTFont(path)
    glyphs = font.getGlyphSet()
    pen = AreaPen(glyphs)
    glyphs[name].draw(pen)
    return abs(pen.value) / font['head'].unitsPerEm ** 2


def distance(point, polygons):
    """From a point to the nearest edge."""
    best = float('inf')
    for polygon in polygons:
        for (ax, ay), (bx, by) in zip(polygon, polygon[1:] + polygon[:1]):
            dx, dy, px, py = bx - ax, by - ay, point[0] - ax, point[1] - ay
            length = dx * dx + dy * dy
            t = min(max((px * dx + py * dy) / length, 0), 1) if length else 0
            best = min(best, (px - t * dx) ** 2 + (py - t * dy) ** 2)
    return best ** 0.5


def winding(point, polygons):
    """How often the polygons go around a point."""
    turns, (x, y) = 0, point
    for polygon in polygons:
        for (ax, ay), (bx, by) in zip(polygon, polygon[1:] + polygon[:1]):
            if (ay <= y) != (by <= y) and (bx - ax) * (y - ay) / (by - ay) + ax > x:
                turns += 1 if by > ay else -1
    return turns


def box(polygons):
    xs, ys = zip(*(point for polygon in polygons for point in polygon))
    return min(xs), min(ys), max(xs), max(ys)


class Animate(cli.Test):
    def animate(self, output, *arguments, keys=(f'{SANS}=g', f'{SERIF}=8')):
        self.assertEqual(self.made('animate', *keys, '-o', output, *arguments), [])
        return self.path(output)

    def paths(self, output, *arguments, **options):
        """The path elements of an SVG."""
        root = xml.etree.ElementTree.parse(self.animate(output, *arguments, **options)).getroot()
        return root.findall(f'.//{SVG}path')

    def key_times(self, path, attribute='d'):
        """Times and values of the animate element for an attribute."""
        animate = [a for a in path.findall(f'{SVG}animate') if a.get('attributeName') == attribute][0]
        times = [float(t) for t in animate.get('keyTimes').split(';')]
        values = animate.get('values').split(';')
        self.assertEqual(len(times), len(values))
        self.assertEqual(times, sorted(times))
        if animate.get('calcMode') == 'spline':
            self.assertEqual(len(animate.get('keySplines').split(';')), len(times) - 1)
        return times, values, animate

    def assert_drawn_as(self, data, font, name, bound=1.5e-3):
        """The path is the glyph, moved: its border is drawn, and all else that is drawn are cuts in its ink. Gives how far, in em."""
        glyph, advance = font_lines(font, name, 32)
        path = [[(x / PATH_EM, -y / PATH_EM) for x, y in p] for p in path_lines(data, 32)]
        here, there = box(path), box(glyph)
        dx, dy = here[0] - there[0], here[1] - there[1]
        moved = [[(x + dx, y + dy) for x, y in p] for p in glyph]
        for x, y in (point for polygon in path_lines(data) for point in polygon):
            point = x / PATH_EM, -y / PATH_EM
            self.assertTrue(distance(point, moved) < bound or winding(point, moved), point)
        for x, y in (point for polygon in font_lines(font, name)[0] for point in polygon):
            self.assertLess(distance((x + dx, y + dy), path), bound)
        return dx + advance / 2, dy


class Vectors(Animate):
    """SVG and Lottie."""

    def test_key_times_have_the_same_commands_and_the_fonts_outlines(self):
        (path,) = self.paths('x.svg')
        times, values, animate = self.key_times(path)
        self.assertEqual((times[0], times[-1]), (0, 1))
        self.assertEqual((animate.get('dur'), animate.get('repeatCount')), ('1s', 'indefinite'))
        self.assertEqual(len({path_points(value)[0] for value in values}), 1)
        self.assertEqual(path.get('d'), values[0])
        a = self.assert_drawn_as(values[0], SANS, 'g')
        b = self.assert_drawn_as(values[-1], SERIF, 'eight')
        for here, there in zip(a, b): # one baseline, and one middle
            self.assertAlmostEqual(here, there, delta=1.5e-3)
        self.assertLess(self.path('x.svg').stat().st_size, 30000)

    def test_glyphs_by_name_are_those_of_the_characters(self):
        one = self.animate('x.svg', keys=(f'{SANS}=g', f'{SANS}=/g')).read_bytes()
        two = self.animate('y.svg', keys=(f'{SANS}=/g', f'{SANS}=g')).read_bytes()
        self.assertEqual(one, two)
        self.refused(1, 'animate', f'{SANS}=/nothing', f'{SANS}=g', '-o', 'z.svg', says=[f'{SANS} has no glyph /nothing'])
        mixed = self.animate('x.svg', keys=(f'{SANS}=a /g/o', f'{SERIF}=8')).read_bytes()
        self.assertEqual(self.animate('y.svg', keys=(f'{SANS}=a go', f'{SERIF}=8')).read_bytes(), mixed)

    def test_a_place_on_axes_is_told_from_the_text(self):
        if not cli.INTER.exists():
            self.skipTest('no Inter')
        values = [self.key_times(self.paths('x.svg', keys=(f'{cli.INTER}@wght={weight}==', f'{SANS}=g'))[0])[1][0]
                  for weight in (100, 900)]
        heights = [box(path_lines(value)[:1]) for value in values]
        self.assertLess(heights[0][3] - heights[0][1], 0.7 * (heights[1][3] - heights[1][1])) # a bar of =

    def test_a_chain_shows_one_set_of_contours_at_a_time(self):
        paths = self.paths('x.svg', '--yoyo', keys=(f'{SANS}=g', f'{SERIF}=8', f'{SANS}=B'))
        self.assertEqual(len(paths), 3) # there, on and back, back
        shown = [self.key_times(path, 'visibility')[:2] for path in paths]
        for moment in (0.1, 0.4, 0.6, 0.9):
            visible = [values[max(i for i, t in enumerate(times) if t <= moment)] for times, values in shown]
            self.assertEqual(visible.count('visible'), 1, (moment, shown))
        self.assertEqual([path.get('visibility') for path in paths], [None, 'hidden', 'hidden'])
        self.assertEqual(self.key_times(paths[0])[1][0], self.key_times(paths[2])[1][-1])

    def test_holds_easing_and_colours_have_key_times(self):
        (path,) = self.paths('x.svg', '--duration', 2, '--hold', 1, '--loop', 3, '--color', '#f00,blue')
        times, values, animate = self.key_times(path)
        self.assertEqual((times[0], times[1], times[-2], times[-1]), (0, 0.25, 0.75, 1))
        self.assertEqual((values[0], values[-1]), (values[1], values[-2]))
        self.assertEqual((animate.get('dur'), animate.get('repeatCount'), animate.get('fill')), ('4s', '3', 'freeze'))
        self.assertEqual(animate.get('calcMode'), 'spline')
        fills = self.key_times(path, 'fill')[1]
        self.assertEqual((fills[0], fills[-1]), ('#ff0000', '#0000ff'))
        (path,) = self.paths('x.svg', '--ease', 'linear')
        self.assertEqual(self.key_times(path)[2].get('calcMode'), 'linear')
        (path,) = self.paths('x.svg', '--ease', 'cubic-bezier(0.34, 1.56, 0.64, 1)')
        self.assertGreater(len(self.key_times(path)[0]), 50)

    def test_css_has_the_same_paths(self):
        _, values, _ = self.key_times(self.paths('x.svg', '--ease', 'linear')[0])
        text = self.animate('y.svg', '--css', '--ease', 'linear').read_text()
        self.assertEqual(re.findall(r"d:path\('([^']+)'\)", text), values)
        self.assertIn('infinite', text)
        for word in ('<script', 'href', 'url('):
            self.assertNotIn(word, text)

    def test_stills_have_equal_commands(self):
        self.animate('x.svg', '--steps', 11)
        stills = [xml.etree.ElementTree.parse(self.path(f'x-{i:02}.svg')).getroot().find(f'{SVG}path') for i in range(1, 12)]
        self.assertFalse(self.path('x.svg').exists())
        drawn = [path_points(still.get('d')) for still in stills]
        self.assertEqual(len({commands for commands, _ in drawn}), 1)
        for (ax, ay), (mx, my), (bx, by) in zip(drawn[0][1], drawn[5][1], drawn[10][1]): # on straight lines
            self.assertLess(abs(ax + bx - 2 * mx) + abs(ay + by - 2 * my), 8)

    def test_letters_are_small_files(self):
        for a, b in zip('Rg8&pyS', 'BaS8gRB'):
            self.assertLessEqual(self.animate('x.svg', keys=(f'{SANS}={a}', f'{SANS}={b}')).stat().st_size, 30000, (a, b))

    def test_words_keep_their_letters(self):
        """cat to cart: c, a and t stay letters of the same commands, and r grows from a point."""
        if not cli.SERIF.exists():
            self.skipTest('no DejaVu')
        _, values, _ = self.key_times(self.paths('x.svg', keys=(f'{cli.SERIF}=cat', f'{cli.SERIF}=cart'))[0])
        first, last = path_lines(values[0]), path_lines(values[-1])
        points = [i for i, polygon in enumerate(first) if len(set(polygon)) == 1]
        self.assertEqual(len(points), 1)
        self.assertGreater(len(set(last[points[0]])), 10)
        kept = [i for i in range(len(first)) if i not in points]
        for i in kept: # as wide and as high as before
            a, b = box([first[i]]), box([last[i]])
            self.assertAlmostEqual(a[2] - a[0], b[2] - b[0], delta=8)

    def test_rotation_goes_on_an_arc(self):
        _, straight, _ = self.key_times(self.paths('x.svg')[0])
        _, turned, _ = self.key_times(self.paths('y.svg', '--rotate', 90)[0])
        self.assertGreater(len(turned), len(straight))
        self.assertEqual(len({path_points(value)[0] for value in turned}), 1)
        self.assert_drawn_as(turned[0], SANS, 'g')
        self.assert_drawn_as(turned[-1], SERIF, 'eight')

    def test_lottie_is_sound(self):
        data = json.loads(self.animate('x.json', '--yoyo', '--fps', 25, '--color', 'red,#00f').read_text())
        self.assertEqual((data['fr'], data['ip'], data['op'], data['assets']), (25, 0, 50, []))
        shapes, background = data['layers']
        self.assertEqual((shapes['ty'], background['ty'], background['sc']), (4, 1, '#ffffff'))
        self.assertEqual([layer['op'] for layer in data['layers']], [50, 50])
        items = shapes['shapes'][0]['it']
        self.assertEqual({item['ty'] for item in items}, {'sh', 'fl', 'tr'})
        (fill,) = [item for item in items if item['ty'] == 'fl']
        self.assertEqual((fill['r'], fill['c']['k'][0]['s'], fill['c']['k'][-1]['s']), (1, [1, 0, 0, 1], [1, 0, 0, 1]))
        for item in (item for item in items if item['ty'] == 'sh'):
            keys = item['ks']['k']
            self.assertEqual([keys[0]['t'], keys[-1]['t']], [0, 50])
            counts = {len(key['s'][0][name]) for key in keys for name in 'iov'}
            self.assertEqual(len(counts), 1)
            for key in keys[:-1]:
                for handle in (key['i'], key['o']):
                    self.assertTrue(0 <= handle['x'] <= 1)
            xs = [x for key in keys for x, _ in key['s'][0]['v']]
            self.assertTrue(0 <= min(xs) and max(xs) <= data['w'])
            self.assertEqual(keys[0]['s'], keys[-1]['s'])

    def test_same_bytes_on_any_number_of_threads(self):
        keys = (f'{SANS}=type', f'{SERIF}=Morph', f'{SANS}=8')
        for name in ('x.svg', 'x.json'):
            one = self.animate(name, '-j', 1, keys=keys).read_bytes()
            self.assertEqual(self.animate(name, '-j', 4, keys=keys).read_bytes(), one)


class Pictures(Animate):
    """Frames in pixels."""

    def ink_of(self, font, name, size):
        return glyph_area(font, name) * size * size

    def test_numbered_frames_begin_and_end_with_the_fonts_drawings(self):
        self.animate('x.png', '--fps', 9, '--size', 100)
        frames = [cli.Image(self.path(f'x-{i:02}.png')) for i in range(1, 11)]
        self.assertEqual(len(self.files()), 10)
        self.assertEqual(len({(frame.width, frame.height) for frame in frames}), 1)
        self.assertAlmostEqual(frames[0].ink() / self.ink_of(SANS, 'g', 100), 1, delta=0.01)
        self.assertAlmostEqual(frames[-1].ink() / self.ink_of(SERIF, 'eight', 100), 1, delta=0.01)

    def test_frames_do_not_depend_on_the_format(self):
        """An APNG, read by zlib alone: its frames are the numbered ones."""
        self.animate('x.png', '--fps', 5, '--hold', 0.5, '--size', 40)
        data = self.animate('x.apng', '--fps', 5, '--hold', 0.5, '--size', 40, '--loop', 2).read_bytes()
        chunks, at = [], 8
        while at < len(data):
            length, kind = struct.unpack('>I4s', data[at:at + 8])
            body = data[at + 8:at + 8 + length]
            self.assertEqual(struct.unpack('>I', data[at + 8 + length:at + 12 + length])[0], zlib.crc32(kind + body))
            chunks.append((kind, body))
            at += 12 + length
        kinds = [kind for kind, _ in chunks]
        self.assertEqual(kinds[:4] + kinds[-1:], [b'IHDR', b'acTL', b'fcTL', b'IDAT', b'IEND'])
        width, height = struct.unpack('>II', chunks[0][1][:8])
        count, plays = struct.unpack('>II', chunks[1][1])
        controls = [struct.unpack('>IIIIIHHBB', body) for kind, body in chunks if kind == b'fcTL']
        self.assertEqual((count, plays), (len(controls), 2))
        sequence = [struct.unpack('>I', body[:4])[0] for kind, body in chunks if kind in (b'fcTL', b'fdAT')]
        self.assertEqual(sequence, list(range(len(sequence))))
        pixels = [body[4 * (kind == b'fdAT'):] for kind, body in chunks if kind in (b'IDAT', b'fdAT')]
        number = 1
        for control, packed in zip(controls, pixels, strict=True):
            self.assertEqual(control[1:5] + control[6:7], (width, height, 0, 0, 5))
            reader = object.__new__(cli.Image)
            reader.width, reader.height = width, height
            rows = reader.unfilter(zlib.decompress(packed))
            for _ in range(control[5]):
                self.assertEqual(cli.Image(self.path(f'x-{number:02}.png')).rows, rows, number)
                number += 1
        self.assertEqual(number - 1, len(list(self.directory.glob('x-*.png'))))

    @unittest.skipUnless(Image, 'no PIL')
    def test_gif_and_webp_have_the_same_frames(self):
        arguments = ('--fps', 5, '--size', 40, '--color', '#c00,#00c', '--background', '#ffe')
        self.animate('x.png', *arguments)
        wanted = [Image.open(self.path(f'x-{i}.png')).convert('RGB').tobytes() for i in range(1, 7)]
        for name in ('x.gif', 'x.webp'):
            with Image.open(self.animate(name, *arguments)) as image:
                frames = [frame.convert('RGB').tobytes() for frame in ImageSequence.Iterator(image)]
                self.assertEqual(image.info['loop'], 0)
            self.assertEqual(len(frames), 6)
            for one, two in zip(frames, wanted):
                self.assertLessEqual(max(abs(a - b) for a, b in zip(one, two)), 1)
        with Image.open(self.path('x.gif')) as image:
            times = [frame.info['duration'] for frame in ImageSequence.Iterator(image)]
        self.assertEqual(times, [200] * 6)

    @unittest.skipUnless(Image, 'no PIL')
    def test_without_a_background_pixels_are_clear(self):
        for name in ('x.apng', 'x.webp', 'x.gif'):
            with Image.open(self.animate(name, '--background', 'none', '--size', 40, '--fps', 4)) as image:
                alphas = image.convert('RGBA').getchannel('A')
            self.assertEqual(alphas.getpixel((0, 0)), 0)
            self.assertEqual(alphas.getextrema(), (0, 255))
            ink = sum(alphas.tobytes()) / 255
            self.assertAlmostEqual(ink / self.ink_of(SANS, 'g', 40), 1, delta=0.05)

    def test_canvas_and_size(self):
        for arguments, size in ((('--canvas', '300x101'), (300, 101)),
                                (('--canvas', '80x80', '--size', 20), (80, 80))):
            self.animate('x.png', '--steps', 2, *arguments)
            image = cli.Image(self.path('x-1.png'))
            self.assertEqual((image.width, image.height), size)
            left, right, top, bottom = image.box()
            self.assertTrue(left > 0 and top > 0 and right < size[0] and bottom < size[1])

    def test_a_ring_stays_a_ring(self):
        """From o to 8 there is always a hole."""
        self.animate('x.png', '--steps', 3, '--size', 60, keys=(f'{SANS}=o', f'{SERIF}=8'))
        for i in (1, 2, 3):
            image = cli.Image(self.path(f'x-{i}.png'))
            self.assertGreater(self.holes(image), 0, i)

    @staticmethod
    def holes(image):
        """Light regions that do not reach the border."""
        light = {(x, y) for y, row in enumerate(image.rows) for x in range(image.width) if row[3 * x] >= 128}
        regions = 0
        while light:
            stack, closed = [light.pop()], True
            while stack:
                x, y = stack.pop()
                closed = closed and 0 < x < image.width - 1 and 0 < y < image.height - 1
                for near in ((x + 1, y), (x - 1, y), (x, y + 1), (x, y - 1)):
                    if near in light:
                        light.remove(near)
                        stack.append(near)
            regions += closed
        return regions


class Movies(Animate):
    """Videos by a command named ffmpeg: here one that keeps what it is told and given."""

    COMMAND = '''#!{python}
import sys
frames = sys.stdin.buffer.read()
open(sys.argv[-1].removeprefix('file:'), 'wb').write(b'movie')
open({log!r}, 'w').write(repr((sys.argv[1:], len(frames))))
sys.exit({code})
'''

    def run_with(self, code, *arguments):
        folder = self.path('bin')
        folder.mkdir(exist_ok=True)
        command = folder / 'ffmpeg'
        if code is not None:
            command.write_text(self.COMMAND.format(python=sys.executable, log=str(self.path('log')), code=code))
            command.chmod(0o755)
        return self.run_program('animate', f'{SANS}=g', f'{SERIF}=8', '--size', 40, '--fps', 5, *arguments,
                                env={'PATH': str(folder)})

    def test_frames_go_to_ffmpeg(self):
        result = self.run_with(0, '-o', 'x.mp4', '--loop', 2)
        self.assertEqual((result.returncode, result.stderr), (0, b''))
        self.assertEqual(self.path('x.mp4').read_bytes(), b'movie')
        arguments, length = eval(self.path('log').read_text()) # pylint: disable=eval-used
        width, height = map(int, arguments[arguments.index('-s') + 1].split('x'))
        self.assertEqual((width % 2, height % 2), (0, 0))
        self.assertEqual(length, 2 * 6 * width * height * 3)
        self.assertEqual(arguments[arguments.index('-r') + 1], '5')
        self.assertEqual([path.name for path in self.directory.iterdir() if path.name.startswith('.')], [])

    def test_webm_may_be_clear(self):
        self.assertEqual(self.run_with(0, '-o', 'x.webm', '--background', 'none').returncode, 0)
        arguments, length = eval(self.path('log').read_text()) # pylint: disable=eval-used
        width, height = map(int, arguments[arguments.index('-s') + 1].split('x'))
        self.assertEqual(length, 6 * width * height * 4)
        self.assertIn('yuva420p', arguments)

    def test_without_ffmpeg_and_with_a_failing_one(self):
        for code, words in ((None, b'is not installed'), (3, b'ffmpeg could not make it')):
            result = self.run_with(code, '-o', 'x.mp4')
            self.assertEqual(result.returncode, 1)
            self.assertIn(words, result.stderr)
            self.assertEqual(result.stderr.count(b'\n'), 1)
            self.assertEqual([path.name for path in self.directory.iterdir() if path.name not in ('bin', 'log')], [])


def svg(content, view='0 0 24 24', more=''):
    return f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{view}" {more}>{content}</svg>'


STAR = svg('<path fill="#e6a000" d="M12 1l3.2 7.7 8.3.6-6.4 5.4 2 8.1-7.1-4.4-7.100 4.400 2-8.100L.5 9.300l8.300-.6z"/>')
HEART = svg('<path style="fill:crimson" d="M256 460C100 330 40 260 40 170c0-62 48-112 110-112 42 0 82 24 106 62 24-38 64-62 106-62 '
            '62 0 110 50 110 112 0 90-60 160-216 290z"/>', '0 0 512 512')
RING = svg('<path fill-rule="evenodd" d="M12 2a10 10 0 1 0 0 20 10 10 0 1 0 0-20zM12 6a6 6 0 1 0 0 12 6 6 0 1 0 0-12z"/>')
FRAME = svg('<rect x="2" y="2" width="20" height="4"/><rect x="2" y="18" width="20" height="4"/>'
            '<path d="M2 2v20h4V2z"/><g transform="rotate(180 12 12)"><path d="M2 2v20h4V2z"/></g>') # of four bars


class Drawings(Animate):
    """From SVG."""

    def setUp(self):
        super().setUp()
        for name, content in (('star.svg', STAR), ('heart.svg', HEART), ('ring.svg', RING), ('frame.svg', FRAME)):
            self.write(name, content)

    def test_drawings_move_in_their_colours(self):
        (path,) = self.paths('x.svg', keys=('star.svg', 'heart.svg'))
        _, values, _ = self.key_times(path)
        self.assertEqual(len({path_points(value)[0] for value in values}), 1)
        fills = self.key_times(path, 'fill')[1]
        self.assertEqual((fills[0], fills[-1]), ('#e6a000', '#dc143c'))
        (path,) = self.paths('x.svg', '--color', 'navy', keys=('star.svg', 'heart.svg'))
        self.assertEqual(path.get('fill'), '#000080')
        for value, sides in ((values[0], (23, 21.8)), (values[-1], (432 * 24 / 512, 402 * 24 / 512))):
            left, top, right, bottom = box(path_lines(value, 16))
            self.assertAlmostEqual((right - left) * 24 / PATH_EM, sides[0], delta=0.05)
            self.assertAlmostEqual((bottom - top) * 24 / PATH_EM, sides[1], delta=0.05)

    def test_drawings_and_letters_make_a_chain(self):
        paths = self.paths('x.svg', keys=('star.svg', f'{SANS}=go', 'heart.svg'))
        self.assertEqual(len(paths), 2)
        self.assert_drawn_as(self.key_times(self.paths('x.svg', keys=('star.svg', f'{SANS}=g'))[0])[1][-1], SANS, 'g')

    def test_a_ring_stays_a_ring(self):
        for keys in (('ring.svg', 'frame.svg'), ('frame.svg', 'ring.svg'), ('ring.svg', f'{SANS}=o')):
            self.animate('x.png', '--steps', 5, '--size', 60, keys=keys)
            for i in range(1, 6):
                self.assertEqual(Pictures.holes(cli.Image(self.path(f'x-{i}.png'))), 1, (keys, i))

    def test_what_is_alike_on_both_sides_stays_so(self):
        """At 200 pixels an em no pixel is other than its mirror image: one outline, holes, and several parts."""
        self.write('star.svg', svg('<path d="M12 1l2.600 8H23l-6.800 5 2.600 8L12 17l-6.800 5 2.600-8L1 9h8.400z"/>')) # not drawn askew
        self.write('heart.svg', svg('<path d="M12 22C5 16 1.500 12.500 1.500 7.700 1.500 2.400 9.600 0 12 5 14.400 0 22.500 2.400 22.500 7.700 22.500 12.500 19 16 12 22z"/>'))
        self.write('arrow.svg', svg('<path d="M12 2l9 10h-6v10h-6V12H3z"/>'))
        self.write('pause.svg', svg('<path d="M5 4h5v16H5zM14 4h5v16h-5z"/>'))
        self.write('house.svg', svg('<path d="M12 2L2 11h3v11h14V11h3zM10 22v-6h4v6z" fill-rule="evenodd"/>'))
        for keys in (('star.svg', 'heart.svg'), ('heart.svg', 'arrow.svg'), ('house.svg', 'ring.svg'), ('pause.svg', 'ring.svg'),
                     ('ring.svg', 'frame.svg')):
            self.animate('x.png', '--steps', 9, '--canvas', '200x200', '--color', 'black', keys=keys)
            for i in range(1, 10):
                for row in cli.Image(self.path(f'x-{i}.png')).rows:
                    dark = row[::3]
                    self.assertLessEqual(max(abs(p - q) for p, q in zip(dark, reversed(dark))), 60, (keys, i))

    def test_ends_have_the_drawings_ink(self):
        self.animate('x.png', '--steps', 2, '--size', 96, keys=('ring.svg', 'frame.svg'))
        for i, ink in ((1, 3.14159 * (100 - 36)), (2, 400 - 144)):
            self.assertAlmostEqual(cli.Image(self.path(f'x-{i}.png')).ink() / 16 / ink, 1, delta=0.002)

    def ends(self, keys, *options):
        """The first frame and the last, as bytes."""
        self.animate('e.png', '--fps', 3, '--size', 90, *options, keys=keys)
        return self.path('e-1.png').read_bytes(), self.path(f'e-{3 * (len(keys) - 1) + 1}.png').read_bytes()

    def test_ends_are_drawings_of_the_key_frames_by_themselves(self):
        """Pixel for pixel. The drawings share a box, and texts that of a third: so all canvases are the same."""
        for a, b in (('ring.svg', 'frame.svg'), ('frame.svg', 'ring.svg')):
            for options in ((), ('--ease', 'linear', '--hold', 0)):
                first, last = self.ends((a, b), *options)
                self.assertEqual(first, self.ends((a, a))[0])
                self.assertEqual(last, self.ends((b, b))[1])
                self.assertNotEqual(first, last)
        if not cli.SERIF.exists():
            return
        block = f'{cli.SERIF}=███'
        for one, other in ((f'{SANS}=g', f'{SERIF}=8'), (f'{cli.SERIF}=V', f'{cli.SERIF}=W')):
            alone = self.ends((one, block, one))[0], self.ends((other, block, other))[1]
            self.assertEqual(self.ends((one, block, other)), alone)

    def test_what_is_in_the_file_tells_not_its_name(self):
        drawn = self.animate('x.svg', keys=('star.svg', 'heart.svg')).read_bytes()
        self.write('a=b.txt', '\ufeff<?xml version="1.0"?>\n<!DOCTYPE svg PUBLIC "a" "http://example.org/none.dtd">' + STAR)
        self.assertEqual(self.animate('y.svg', keys=('a=b.txt', 'heart.svg')).read_bytes(), drawn)
        self.write('font.svg', 'OTTO')
        self.refused(2, 'animate', 'font.svg', 'star.svg', '-o', 'z.svg', says=['font.svg: a key frame is'])
        self.refused(2, 'animate', 'star.svg', SANS, '-o', 'z.svg', says=[SANS, 'a key frame is'])

    def test_what_is_left_out_is_told_once(self):
        self.write('x-in.svg', STAR.replace('</svg>', '<text>a</text><text>b</text><path d="M0 0h9v9" stroke="red"/></svg>'))
        arguments = ('animate', 'x-in.svg', 'heart.svg', '-o', 'x.svg')
        self.assertEqual(self.made(*arguments), ['morphotype: x-in.svg: left out: strokes, text'])
        self.assertEqual(self.made(*arguments, '-q'), [])

    def test_bad_drawings(self):
        laughs = '<!DOCTYPE svg [<!ENTITY a "ha"><!ENTITY b "&a;&a;&a;&a;&a;&a;&a;&a;">]>' + svg('<text>&b;</text>')
        for content, says in ((svg(''), 'nothing is filled'), (svg('<script>x()</script>'), 'nothing is filled; left out: scripts'),
                              (laughs, 'it declares entities'), ('<svg', 'damaged'), ('<html></html>', 'no SVG drawing'),
                              (svg('<g>' * 101 + '<circle r="9"/>' + '</g>' * 101), 'over 100 levels'),
                              (svg('<g>' * 9999), 'over 100 levels'), (svg('<circle r="99999"/>'), 'too large')):
            self.write('bad.svg', content)
            self.refused(1, 'animate', 'star.svg', 'bad.svg', '-o', 'x.svg', says=['bad.svg: ', says])
        self.refused(1, 'animate', 'none.svg', 'star.svg', '-o', 'x.svg', says=['none.svg', 'No such file'])
        self.write('hints.txt', 'A whole\n')
        self.refused(2, 'animate', 'star.svg', 'heart.svg', '-o', 'x.svg', '--hints', 'hints.txt', says=['star.svg is a drawing'])

    def test_detailed_drawings_move(self):
        """Two borders of 5000 points each are one contour of as many, not shapes that shrink and grow."""
        def border(waves):
            points = []
            for i in range(5000):
                angle = 2 * math.pi * i / 5000
                r = 9 + sum(math.sin(angle * wave + wave) for wave in waves) / len(waves)
                points.append(f'{12 + r * math.cos(angle):.4f} {12 + r * math.sin(angle):.4f}')
            return svg('<path d="M' + 'L'.join(points) + 'z"/>')
        self.write('a.svg', border((3, 8)))
        self.write('b.svg', border((2, 5, 7)))
        (path,) = self.paths('x.svg', keys=('a.svg', 'b.svg'))
        self.assertEqual(path_points(path.get('d'))[0].count('z'), 1)

    def test_long_spirals_move(self):
        """A band of 2500 points in three turns is some hundred curves in a row, fitted in seconds."""
        points = []
        for i in range(2500):
            step, side = (i, 0.3) if i < 1250 else (2499 - i, 2.3)
            angle, r = 6 * math.pi * step / 1249, side + 11 * step / 1249
            points.append(f'{14 + r * math.cos(angle):.4f} {14 + r * math.sin(angle):.4f}')
        self.write('spiral.svg', svg('<path d="M' + 'L'.join(points) + 'z"/>', '0 0 28 28'))
        result = self.run_program('animate', 'spiral.svg', 'star.svg', '-o', 'x.svg', timeout=100)
        self.assertEqual((result.returncode, result.stderr), (0, b''))

    def test_work_on_tangles_is_bounded(self):
        """What would take minutes moves as was found by then, or shrinks and grows, which is told; the same on any machine."""
        teeth = svg('<path d="M0 24' + ''.join(f'L{i * .024:.3f} 0L{i * .024 + .012:.3f} 23' for i in range(1000)) + 'L24 24z"/>')
        nest = svg('<path fill-rule="evenodd" d="' + ''.join(f'M{i / 70:.4f} {i / 70:.4f}h{24 - i / 35:.4f}v{24 - i / 35:.4f}h{i / 35 - 24:.4f}z'
                                                            for i in range(800)) + '"/>')
        for drawing, passes in ((teeth, 0), (nest, 1)):
            self.write('bad.svg', drawing)
            said = self.made('animate', 'bad.svg', 'ring.svg', '-o', 'x.svg')
            self.assertEqual(len(said), passes, said)
            if passes:
                self.assertIn('1 part could not be morphed', said[0])

    def test_damaged_drawings_are_drawn_or_refused(self):
        """Bytes of drawings changed at random: an exit code of the program's own, and few lines."""
        source = random.Random(15)
        for number in range(40):
            text = list(source.choice((STAR, HEART, RING, FRAME)))
            for _ in range(source.randint(1, 6)):
                text[source.randrange(len(text))] = source.choice('0123456789.-eMmLlAaZz<>&"\x00 ')
            self.write('bad.svg', ''.join(text))
            result = self.run_program('animate', 'bad.svg', 'ring.svg', '-o', 'x.svg')
            self.assertIn(result.returncode, (0, 1, 2), (number, result.stderr))
            self.assertLessEqual(result.stderr.count(b'\n'), 2, (number, result.stderr))


class Usage(Animate):
    """What is refused, and how."""

    def wrong(self, *arguments, says=(), keys=(f'{SANS}=g', f'{SERIF}=8'), output='x.svg'):
        self.refused(2, 'animate', *keys, '-o', output, *arguments, says=says)

    def test_key_frames(self):
        self.wrong(keys=(f'{SANS}=g',), says=['two key frames are wanted'])
        self.wrong(keys=(f'{SANS}=g', SERIF), says=['a key frame is FONT=TEXT, or an SVG drawing'])
        self.wrong(keys=(f'{SANS}=g', f'{SERIF}='), says=['there is no text'])
        self.refused(1, 'animate', f'{SANS}=g', 'none.otf=8', '-o', 'x.svg', says=['none.otf: ', 'No such file'])
        self.refused(1, 'animate', f'{SANS}#7=g', f'{SERIF}=8', '-o', 'x.svg', says=[f'{SANS}#7: no such face'])
        self.refused(1, 'animate', f'{SANS}@wght=5=g', f'{SERIF}=8', '-o', 'x.svg', says=['no such axis'])
        self.refused(1, 'animate', f'{SANS}=g', f'{SERIF}=ж', '-o', 'x.svg', says=[SERIF, 'lacks “ж” (U+0436)'])
        self.refused(1, 'animate', f'{SANS}=g', f'{SERIF}= ', '-o', 'x.svg', says=['there is no ink'])

    def test_options(self):
        for option, value in (('--ease', 'bounce'), ('--ease', 'cubic-bezier(0,0,1)'), ('--ease', 'cubic-bezier(2,0,1,1)'),
                              ('--ease-over', 'all'), ('--duration', '0'), ('--duration', 'nan'), ('--hold', '-1'),
                              ('--fps', '0'), ('--fps', '2.5'), ('--loop', '0'), ('--loop', 'ever'), ('--canvas', '10'),
                              ('--canvas', '10x9999'), ('--canvas', '10x'), ('--color', 'nocolour'), ('--color', '#ab'),
                              ('--color', 'red,'), ('--background', '#12345g'), ('--size', '1'), ('--steps', '1')):
            self.wrong(option, value, says=[option, value])
        self.wrong('--color', 'red,green,blue', says=['3 colours for 2 key frames'])

    def test_formats(self):
        self.wrong(output='x.bmp', says=['animate writes'])
        self.wrong('--css', output='x.json', says=['--css is for .svg'])
        self.wrong('--steps', 3, output='x.gif', says=['--steps is for'])
        self.wrong('--fps', 60, output='x.gif', says=['at most 50'])
        self.wrong('--background', 'none', output='x.mp4', says=['has a background'])
        self.wrong('--canvas', '101x100', output='x.mp4', says=['even'])
        self.refused(2, 'animate', f'{SANS}=g', f'{SERIF}=8', says=['-o OUT'])
        self.refused(1, 'animate', f'{SANS}=g', f'{SERIF}=8', '-o', 'none/x.svg', says=['none/x.svg'])

    def test_too_large(self):
        self.refused(1, 'animate', f'{SANS}=g', f'{SERIF}=8', '-o', 'x.svg', '--size', 8192, '--ease',
                     'cubic-bezier(0,-2,1,3)', says=['too large'])
        self.refused(1, 'animate', f'{SANS}=g', f'{SERIF}=8', '-o', 'x.gif', '--duration', 600, '--fps', 50,
                     says=['20000 frames'])
        self.refused(1, 'animate', f'{SANS}=g', f'{SERIF}=8', '-o', 'x.apng', '--duration', 100, '--canvas', '8000x8000',
                     says=['2^35 pixels'])
        self.refused(1, 'animate', f'{SANS}=g', f'{SERIF}=8', '-o', 'x.mp4', '--duration', 100, '--canvas', '1000x1000', '--loop',
                     1000, says=['2^35 pixels'])
        word, slow = 'go8a' * 2, ('--duration', 600, '--ease', 'cubic-bezier(0.3,-1,0.6,2)')
        for output in ('x.svg', 'x.json'):
            self.refused(1, 'animate', f'{SANS}={word}', f'{SERIF}={word}', '-o', output, '--size', 8, *slow, says=['2^22 segments'])

    def test_hints_are_read(self):
        self.write('hints.txt', 'nonsense\n')
        self.refused(1, 'animate', f'{SANS}=g', f'{SERIF}=g', '-o', 'x.svg', '--hints', 'hints.txt', says=['hints.txt'])


if __name__ == '__main__':
    cli.main()
