"""solid: meshes in, morph targets, meshes, pictures and data out, and what is refused."""

import json
import math
import random
import struct
import unittest

import cli
import meshes

SOLIDS = cli.SOURCE / 'solids'
BLOCK, GOBLET, IRON, DUCK = (SOLIDS / f'{name}.obj' for name in ('block', 'goblet', 'iron', 'duck'))


class Morph(cli.Test):
    """OUT.glb"""

    def test_figure_4(self):
        self.made('solid', BLOCK, GOBLET, '-q', '-o', 'x.glb')
        data = self.path('x.glb').read_bytes()
        self.assertLessEqual(len(data), 20000)
        glb = meshes.Glb(data)
        channels = glb.channels()
        self.assertEqual(list(channels), [(0, 'weights')])
        self.assertEqual(channels[0, 'weights'], [(0, (0,)), (2, (1,))])

    def test_ends_are_the_sources(self):
        """Every point stands on its solid's surface, and every point of the solid is one."""
        self.made('solid', BLOCK, IRON, '-q', '-o', 'x.glb')
        glb = meshes.Glb(self.path('x.glb').read_bytes())
        for weight, path in ((0, BLOCK), (1, IRON)):
            points, ends = meshes.read(path)[0], glb.at(weight)
            for place in points:
                self.assertLess(min(math.dist(place, end) for end in ends), 1e-5, (path, place))
            for axis in range(3):
                for most in (min, max):
                    self.assertAlmostEqual(most(p[axis] for p in points), most(p[axis] for p in ends), 5)

    def test_agrees_with_meshes(self):
        self.made('solid', BLOCK, GOBLET, '-q', '-o', 'x.glb')
        self.made('solid', BLOCK, GOBLET, '-q', '--at', '0.3', '-o', 'x.obj')
        glb, (points, triangles) = meshes.Glb(self.path('x.glb').read_bytes()), meshes.read(self.path('x.obj'))
        self.assertEqual(glb.triangles, triangles)
        for a, b in zip(glb.at(0.3), points, strict=True):
            self.assertLess(math.dist(a, b), 1e-5)

    def test_nodes_turn(self):
        """Formula (5): at each key the nodes bring the mesh to where the mesh at that place is."""
        turn = ('--rotate', '200', '--about', '1,2,-2')
        self.made('solid', BLOCK, GOBLET, '-q', *turn, '--duration', '3', '--yoyo', '-o', 'x.glb')
        glb = meshes.Glb(self.path('x.glb').read_bytes())
        channels = glb.channels()
        self.assertEqual([round(time, 5) for time, _ in channels[1, 'weights']], [0, 1, 2, 3, 4, 5, 6])
        self.made('solid', BLOCK, GOBLET, '-q', *turn, '--at', '0,0.3333333333333333,0.6666666666666666,1', '-o', 'x.obj')
        for key, name in ((1, '0.3333333333333333'), (2, '0.6666666666666666'), (5, '0.3333333333333333')):
            (_, (weight,)), (_, back) = (channels[1, path][key] for path in ('weights', 'translation'))
            (_, moved), (_, quaternion) = (channels[0, path][key] for path in ('translation', 'rotation'))
            points = meshes.read(self.path(f'x-{name}.obj'))[0]
            for place, wanted in zip(glb.at(weight), points, strict=True):
                place = meshes.turned([p + b for p, b in zip(place, back)], quaternion)
                self.assertLess(math.dist([p + m for p, m in zip(place, moved)], wanted), 1e-4)

    def test_turned_ends_are_the_sources_too(self):
        self.made('solid', BLOCK, GOBLET, '-q', '--rotate', '-90', '--at', '0,1,0.999999', '-o', 'x.off')
        for place, source in (('0', BLOCK), ('1', GOBLET)):
            self.assertAlmostEqual(meshes.volume(*meshes.read(self.path(f'x-{place}.off'))),
                                   meshes.volume(*meshes.read(source)), 6)
        near, end = (meshes.read(self.path(f'x-{place}.off'))[0] for place in ('0.999999', '1'))
        for place in end:
            self.assertLess(min(math.dist(place, other) for other in near), 1e-4)


class Meshes(cli.Test):
    """Meshes in and out, of every format."""

    def test_formats_go_round(self):
        wanted = meshes.volume(*meshes.read(BLOCK))
        for suffix in meshes.READERS:
            with self.subTest(suffix=suffix):
                self.made('solid', BLOCK, IRON, '--at', '0', '-o', f'a{suffix}')
                points, triangles = meshes.read(self.path(f'a{suffix}'))
                self.assertEqual((len(points), len(triangles)), (16, 32))
                self.assertAlmostEqual(meshes.volume(points, triangles), wanted, 5)
                self.made('solid', f'a{suffix}', IRON, '--at', '0', '-o', 'back.obj')
                points, triangles = meshes.read(self.path('back.obj'))
                self.assertEqual((len(points), len(triangles)), (16, 32))
                self.assertAlmostEqual(meshes.volume(points, triangles), wanted, 5)

    def test_half_way_without_a_place(self):
        said = self.made('solid', BLOCK, GOBLET, '-o', 'x.obj')
        self.made('solid', BLOCK, GOBLET, '-q', '--at', '0.5', '-o', 'y.obj')
        self.assertEqual(self.path('x.obj').read_bytes(), self.path('y.obj').read_bytes())
        self.assertLessEqual(len(said), 1)

    def test_several(self):
        self.made('solid', BLOCK, GOBLET, '-q', '--steps', '3', '-o', 'x.stl')
        self.assertEqual({path.name for path in self.files()}, {'x-0.stl', 'x-0.5.stl', 'x-1.stl'})

    def test_all_or_none(self):
        self.path('x-0.5.stl').mkdir()
        self.refused(1, 'solid', BLOCK, GOBLET, '-q', '--steps', '3', '-o', 'x.stl', says=['x-0.5.stl'])
        self.refused(1, 'solid', BLOCK, GOBLET, '-q', '-o', 'nowhere/x.glb', says=['nowhere/x.glb'])

    def test_overlaps_are_told_once(self):
        low, high = meshes.cuboid((0, 0, 0), (1, 1, 1)), meshes.cuboid((3, 0, 0), (4, 1, 1))
        both = low[0] + high[0], low[1] + [tuple(corner + 8 for corner in face) for face in high[1]]
        two = meshes.write_obj(self.path('two.obj'), *both)
        (said,) = self.made('solid', two, two, '--steps', '4', '-o', 'x.obj')
        self.assertIn('closed meshes', said)
        self.assertEqual(self.made('solid', two, two, '-q', '--steps', '4', '-o', 'x.obj'), [])
        self.assertEqual(self.made('solid', two, two, '--at', '0,1', '-o', 'x.obj'), [])

    def test_same_bytes_again(self):
        for name in ('a.glb', 'a.png', 'a.json', 'a.obj'):
            self.made('solid', DUCK, IRON, '-q', '--json', '-o', name)
            first = self.path(name).read_bytes()
            self.made('solid', DUCK, IRON, '-q', '--json', '-o', name)
            self.assertEqual(first, self.path(name).read_bytes())


class Pictures(cli.Test):
    """OUT.png and its like."""

    def picture(self, *arguments):
        self.made('solid', *arguments, '-q', '--no-labels', '-o', 'x.png')
        return cli.Image(self.path('x.png'))

    def differing(self, image):
        """The share of pixels of the first of two steps that are not the same in the second; of a size that makes margins whole."""
        margin, gap = 10, 8
        width = (image.width - 2 * margin - gap) // 2
        first, second = ([bytes(row[3 * left:3 * (left + width)]) for row in image.rows] for left in (margin, margin + width + gap))
        different = sum(abs(p - q) > 2 for one, other in zip(first, second) for p, q in zip(one[::3], other[::3]))
        return different / (width * image.height)

    def test_first_end_is_a_drawing_of_the_first(self):
        self.picture(BLOCK, GOBLET, '--at', '0', '--size', '120')
        first = self.path('x.png').read_bytes()
        self.picture(BLOCK, BLOCK, '--at', '1', '--size', '120')
        self.assertEqual(first, self.path('x.png').read_bytes())

    def test_near_the_ends_hardly_anything_changes(self):
        for places in ('0,0.000001', '0.999999,1'):
            for pair in ((BLOCK, GOBLET), (IRON, BLOCK), (DUCK, IRON)):
                image = self.picture(*pair, '--at', places, '--size', '100')
                self.assertLess(self.differing(image), 0.002, (pair, places))
        self.assertGreater(self.differing(self.picture(BLOCK, GOBLET, '--at', '0,1', '--size', '100')), 0.1)

    def test_what_is_seen_is_what_is_there(self):
        """A cube from the front: its square has one shade, and a line around it."""
        cube = meshes.write_obj(self.path('cube.obj'), *meshes.cuboid((0, 0, 0), (1, 1, 1)))
        image = self.picture(cube, cube, '--at', '0', '--size', '100', '--view', '0,0')
        left, right, top, bottom = image.box()
        for length in (right - left, bottom - top):
            self.assertAlmostEqual(length, 101, delta=1)
        inner = {bytes(row[3 * (left + 3):3 * (right - 3)]) for row in image.rows[top + 3:bottom - 3]}
        self.assertEqual(len(inner), 1)
        self.assertEqual(len({inner_row[i:i + 3] for inner_row in inner for i in range(0, len(inner_row), 3)}), 1)

    def test_a_hole_is_seen_through(self):
        image = self.picture(BLOCK, GOBLET, '--at', '0', '--size', '100', '--view', '0,0')
        middle = image.rows[image.height // 2][3 * (image.width // 2):][:3]
        self.assertEqual(bytes(middle), b'\xff\xff\xff')

    def test_places_stand_side_by_side(self):
        sizes = [self.picture(BLOCK, GOBLET, '--steps', str(steps)).width for steps in (2, 3, 4)]
        self.assertAlmostEqual(sizes[2] - sizes[1], sizes[1] - sizes[0], delta=1)

    def test_formats(self):
        for name, start in (('x.svg', b'<?xml'), ('x.pdf', b'%PDF')):
            self.made('solid', BLOCK, GOBLET, '-q', '--steps', '2', '-o', name)
            self.assertTrue(self.path(name).read_bytes().startswith(start))

    def test_too_large(self):
        self.refused(1, 'solid', BLOCK, GOBLET, '--steps', '100', '--size', '4096', '-o', 'x.png', says=['too large'])


class Data(cli.Test):
    """--json"""

    def test_schema(self):
        result = self.run_program('solid', BLOCK, GOBLET, '--json', '--method', 'paper')
        self.assertEqual((result.returncode, result.stderr), (0, b''))
        data = json.loads(result.stdout)
        self.assertEqual((data['format'], data['version'], data['method']), ('morphotype solid', 1, 'paper'))
        for side, path in (('a', BLOCK), ('b', GOBLET)):
            points, polygons = meshes.read(path)
            self.assertEqual(data[side]['file'], str(path))
            self.assertEqual(data[side]['points'], len(points))
            self.assertAlmostEqual(data[side]['volume'], meshes.volume(points, polygons), 6)
            self.assertEqual(data[side]['low'], [min(p[k] for p in points) for k in range(3)])
            self.assertEqual(data[side]['components'], 1)
            self.assertGreaterEqual(len(data[side]['pieces']), 1)
        for link in data['links']:
            self.assertLess(link['a'], len(data['a']['pieces']))
            self.assertLess(link['b'], len(data['b']['pieces']))
        self.assertNotIn('rotation', data)

    def test_beside_another_output(self):
        result = self.run_program('solid', BLOCK, GOBLET, '--json', '--rotate', '30', '-o', 'x.ply')
        self.assertEqual(json.loads(result.stdout)['rotation'], {'degrees': 30, 'axis': [0, 1, 0]})
        self.assertTrue(self.path('x.ply').exists())
        self.assertEqual(self.made('solid', BLOCK, GOBLET, '-o', 'x.json'), [])
        self.assertEqual(json.loads(self.path('x.json').read_text())['format'], 'morphotype solid')


class Errors(cli.Test):
    """What is no solid, and wrong usage."""

    def refuse(self, name, content, *says):
        path = self.write(name, content)
        for pair in ((path, GOBLET), (GOBLET, path)):
            self.refused(1, 'solid', *pair, '-o', 'x.glb', says=[name, *says])

    def refuse_mesh(self, points, polygons, *says):
        path = meshes.write_obj(self.path('bad.obj'), points, polygons)
        self.refused(1, 'solid', path, GOBLET, '-o', 'x.glb', says=['bad.obj', *says])

    def test_files(self):
        self.refused(1, 'solid', 'missing.obj', GOBLET, '-o', 'x.glb', says=['missing.obj', 'No such file'])
        self.refused(1, 'solid', 'a.fbx', GOBLET, '-o', 'x.glb', says=['a.fbx', '.obj, .stl, .ply, .off and .glb'])
        self.refuse('a.obj', '', 'no triangles')
        self.refuse('a.stl', '', 'no STL')
        self.refuse('a.ply', '', 'no PLY')
        self.refuse('a.off', '', 'no OFF')
        self.refuse('a.glb', '', 'no binary glTF')
        self.refuse('b.glb', GOBLET.read_bytes(), 'no binary glTF')
        self.path('folder.obj').mkdir()
        self.refused(1, 'solid', 'folder.obj', GOBLET, '-o', 'x.glb', says=['directory'])

    def test_open(self):
        points, polygons = meshes.cuboid((0, 0, 0), (1, 1, 1))
        self.refuse_mesh(points, polygons[:-1], 'has one triangle')

    def test_not_oriented(self):
        points, polygons = meshes.TETRAHEDRON
        self.refuse_mesh(points, [polygons[0][::-1], *polygons[1:]], 'opposite sides')

    def test_one_sided(self):
        """A Klein bottle, closed and of one side: a torus of squares, with one seam turned around."""
        n = 8
        number = lambda i, k: (i % n) * n + ((k if i < n else -k) % n)
        points = [(math.cos(2 * math.pi * i / n) * (3 + math.cos(2 * math.pi * k / n)),
                   math.sin(2 * math.pi * i / n) * (3 + math.cos(2 * math.pi * k / n)), math.sin(2 * math.pi * k / n))
                  for i in range(n) for k in range(n)]
        squares = [(number(i, k), number(i + 1, k), number(i + 1, k + 1), number(i, k + 1))
                   for i in range(n) for k in range(n)]
        self.refuse_mesh(points, squares, 'opposite sides')

    def test_crossing(self):
        first, second = meshes.cuboid((0, 0, 0), (1, 1, 1)), meshes.cuboid((0.5, 0, 0), (1.5, 1, 1))
        shifted = [tuple(corner + 8 for corner in face) for face in second[1]]
        self.refuse_mesh(first[0] + second[0], first[1] + shifted, 'cross or touch')

    def test_empty(self):
        self.refuse_mesh([(0, 0, 0)] * 3, [(0, 1, 2)], 'none of its triangles has an area')

    def test_no_numbers(self):
        points, polygons = meshes.TETRAHEDRON
        self.refuse_mesh([(math.nan, 0, 0), *points[1:]], polygons, 'line 1')
        self.refuse_mesh([(math.inf, 0, 0), *points[1:]], polygons, 'line 1')
        self.refuse_mesh([(1e300, 0, 0), *points[1:]], polygons, 'point 1')

    def test_a_million_triangles(self):
        self.refuse('a.stl', bytes(80) + struct.pack('<I', 10**6) + bytes(50 * 10**6), '1000000 triangles')
        self.refuse('a.obj', 'v 0 0 0\nv 1 0 0\nv 0 1 0\n' + 'f 1 2 3\n' * 10**6, 'over 200000 triangles')

    def test_usage(self):
        for arguments, says in (
                ((BLOCK, '-o', 'x.glb'), 'two solids'),
                ((BLOCK, GOBLET, IRON, '-o', 'x.glb'), 'one argument too many'),
                ((BLOCK, GOBLET), '-o'),
                ((BLOCK, GOBLET, '-o', 'x.fbx'), 'x.fbx'),
                ((BLOCK, GOBLET, '-o', 'x.glb', '--rotate', 'auto'), 'auto'),
                ((BLOCK, GOBLET, '-o', 'x.glb', '--about', 'w'), '--about w'),
                ((BLOCK, GOBLET, '-o', 'x.glb', '--about', '0,0,0'), '--about'),
                ((BLOCK, GOBLET, '-o', 'x.png', '--view', '0,91'), '--view'),
                ((BLOCK, GOBLET, '-o', 'x.png', '--size', '10'), '--size'),
                ((BLOCK, GOBLET, '-o', 'x.glb', '--depth', '0'), '--depth'),
                ((BLOCK, GOBLET, '-o', 'x.obj', '--at', '0.5,0.5'), 'twice'),
                ((BLOCK, GOBLET, '-o', 'x.obj', '--tolerance', '1'), '--tolerance')):
            self.refused(2, 'solid', *arguments, says=[says])


class Hostile(cli.Test):
    """Three hundred damaged files, always the same: each is refused in one line, or is a solid."""

    COUNT, SEED = 300, 15
    WORDS = ['nan', 'inf', '-1', '0', '1e400', '1e-400', '999999999999', '4294967295', '2147483648', 'x', '', '#', '\\', '/',
             '1/', '-', '0x10', '1.5']

    def setUp(self):
        super().setUp()
        self.random = random.Random(self.SEED)
        self.made('solid', BLOCK, IRON, '-q', '--at', '0', '-o', 'seed.obj')
        self.seeds = []
        for suffix in meshes.READERS:
            self.made('solid', BLOCK, IRON, '-q', '--at', '1', '-o', f'seed{suffix}')
            self.seeds.append((suffix, self.path(f'seed{suffix}').read_bytes()))
        points, polygons = meshes.TETRAHEDRON
        facets = ''.join('facet normal 0 0 0\nouter loop\n' + ''.join(f'vertex {x} {y} {z}\n' for x, y, z in corners) +
                         'endloop\nendfacet\n' for corners in ([points[c] for c in face] for face in polygons))
        self.seeds.append(('.stl', f'solid a\n{facets}endsolid a\n'.encode()))
        rows = [' '.join(map(str, p)) for p in points] + [' '.join(map(str, (3, *face))) for face in polygons]
        self.seeds.append(('.ply', ('ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty '
                                    'float z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n' +
                                    '\n'.join(rows) + '\n').encode()))

    def cut(self, data):
        return data[:self.random.randrange(len(data))]

    def flip(self, data):
        changed = bytearray(data)
        for _ in range(self.random.choice((1, 1, 3, 20))):
            changed[self.random.randrange(min(len(data), self.random.choice((200, 10**9))))] = self.random.choice(
                (0, 1, 127, 128, 255, self.random.randrange(256)))
        return bytes(changed)

    def swap_words(self, data):
        words = data.split(b' ')
        for _ in range(self.random.choice((1, 2, 8))):
            words[self.random.randrange(len(words))] = self.random.choice(self.WORDS).encode()
        return b' '.join(words)

    def swap_lines(self, data):
        lines = data.splitlines(keepends=True)
        for _ in range(self.random.choice((1, 4))):
            i, k = (self.random.randrange(len(lines)) for _ in range(2))
            lines[i] = self.random.choice((b'', lines[k], lines[i] * 50))
        return b''.join(lines)

    def repeat(self, data):
        start = self.random.randrange(len(data))
        return data[:start] + data[start:start + self.random.choice((4, 12, 50, 200))] * self.random.choice((2, 40)) + data[start:]

    def change_number(self, data):
        """A whole number of a JSON, a header or a list becomes another."""
        digits = [i for i, byte in enumerate(data) if chr(byte).isdigit()]
        i = self.random.choice(digits or [0])
        return data[:i] + self.random.choice((b'-1', b'99999999', b'4294967296', b'', b'1e9', b'0')) + data[i + 1:]

    def test_all(self):
        wound = [self.cut, self.flip, self.swap_words, self.swap_lines, self.repeat, self.change_number]
        solid = 0
        for number in range(self.COUNT):
            suffix, data = self.random.choice(self.seeds)
            for _ in range(self.random.choice((1, 1, 1, 2))):
                data = self.random.choice(wound)(data) or data
            path = self.write(f'hostile{suffix}', data)
            with self.subTest(number=number):
                result = self.run_program('solid', path, 'seed.obj', '--at', '0.5', '-q', '-o', 'x.off', timeout=60)
                said = result.stderr.decode()
                self.assertIn(result.returncode, (0, 1), said)
                self.assertEqual(said.count('\n'), result.returncode, said)
                self.assertEqual(self.path('x.off').exists(), result.returncode == 0)
            solid += result.returncode == 0
            self.path('x.off').unlink(missing_ok=True)
        self.assertGreater(solid, 5) # some damage does no harm
        self.assertLess(solid, self.COUNT / 2)


if __name__ == '__main__':
    cli.main()
