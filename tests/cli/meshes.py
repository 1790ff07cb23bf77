"""Meshes for the tests of solid: files read without the program under test, and measures."""

import json
import math
import struct

COMPONENTS = {5121: ('B', 1), 5123: ('H', 2), 5125: ('I', 4), 5126: ('f', 4)}
WIDTHS = {'SCALAR': 1, 'VEC3': 3, 'VEC4': 4}


def read_obj(data):
    words = [line.split() for line in data.decode().splitlines()]
    points = [tuple(map(float, line[1:4])) for line in words if line[:1] == ['v']]
    return points, [tuple(int(word.split('/')[0]) - 1 for word in line[1:]) for line in words if line[:1] == ['f']]


def read_off(data):
    lines = data.decode().splitlines()
    points, faces = map(int, lines[1].split()[:2])
    assert lines[0] == 'OFF' and len(lines) == 2 + points + faces
    polygons = [tuple(map(int, line.split())) for line in lines[2 + points:]]
    assert all(polygon[0] == len(polygon) - 1 for polygon in polygons)
    return [tuple(map(float, line.split())) for line in lines[2:2 + points]], [polygon[1:] for polygon in polygons]


def read_stl(data):
    (count,) = struct.unpack_from('<I', data, 80)
    assert len(data) == 84 + 50 * count and not data.startswith(b'solid')
    numbers, triangles = {}, []
    for i in range(count):
        values = struct.unpack_from('<12f', data, 84 + 50 * i)
        corners = [values[k:k + 3] for k in (3, 6, 9)]
        normal = cross(minus(corners[1], corners[0]), minus(corners[2], corners[0]))
        length = math.hypot(*normal)
        assert length < 1e-9 or math.dist(values[:3], [c / length for c in normal]) < 1e-3
        triangles.append(tuple(numbers.setdefault(corner, len(numbers)) for corner in corners))
    return list(numbers), triangles


def read_ply(data):
    header, body = data.split(b'end_header\n', 1)
    assert b'format binary_little_endian 1.0' in header
    points, faces = (int(header.split(b'element ' + name)[1].split()[0]) for name in (b'vertex', b'face'))
    assert len(body) == 12 * points + 13 * faces
    triangles = [struct.unpack_from('<B3i', body, 12 * points + 13 * i) for i in range(faces)]
    return [struct.unpack_from('<3f', body, 12 * i) for i in range(points)], [triangle[1:] for triangle in triangles]


class Glb:
    """A binary glTF of one mesh of one primitive, as the program writes it."""

    def __init__(self, data):
        magic, version, whole, length = struct.unpack_from('<4sIII', data)
        assert (magic, version, whole) == (b'glTF', 2, len(data))
        self.json = json.loads(data[20:20 + length])
        self.binary = data[28 + length:]
        self.primitive = self.json['meshes'][0]['primitives'][0]
        self.points = self.read(self.primitive['attributes']['POSITION'])
        indices = [row[0] for row in self.read(self.primitive['indices'])]
        self.triangles = [tuple(indices[i:i + 3]) for i in range(0, len(indices), 3)]
        self.ways = [self.read(target['POSITION']) for target in self.primitive.get('targets', [])]

    def read(self, accessor):
        accessor = self.json['accessors'][accessor]
        view = self.json['bufferViews'][accessor['bufferView']]
        letter, size = COMPONENTS[accessor['componentType']]
        width = WIDTHS[accessor['type']]
        assert view['byteLength'] == accessor['count'] * width * size
        return [struct.unpack_from(f'<{width}{letter}', self.binary, view['byteOffset'] + i * width * size)
                for i in range(accessor['count'])]

    def at(self, weight):
        """The points where the target has this weight, before nodes move them."""
        return [tuple(a + weight * d for a, d in zip(*pair)) for pair in zip(self.points, self.ways[0])]

    def channels(self):
        """{(node, path): [(time, values)]}"""
        animation, found = self.json['animations'][0], {}
        for channel in animation['channels']:
            sampler = animation['samplers'][channel['sampler']]
            assert sampler.get('interpolation', 'LINEAR') == 'LINEAR'
            times = [row[0] for row in self.read(sampler['input'])]
            target = channel['target']
            found[target['node'], target['path']] = list(zip(times, self.read(sampler['output'])))
        return found


def read_glb(data):
    glb = Glb(data)
    return glb.points, glb.triangles


READERS = {'.obj': read_obj, '.off': read_off, '.stl': read_stl, '.ply': read_ply, '.glb': read_glb}


def read(path):
    """(points, triangles)"""
    return READERS[path.suffix](path.read_bytes())


def write_obj(path, points, polygons):
    lines = [f"v {' '.join(map(repr, point))}" for point in points]
    lines += [f"f {' '.join(str(corner + 1) for corner in polygon)}" for polygon in polygons]
    path.write_text('\n'.join(lines) + '\n')
    return path


def minus(a, b):
    return [p - q for p, q in zip(a, b)]


def dot(a, b):
    return sum(p * q for p, q in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def volume(points, polygons):
    return sum(dot(points[polygon[0]], cross(points[polygon[i]], points[polygon[i + 1]]))
               for polygon in polygons for i in range(1, len(polygon) - 1)) / 6


def turned(place, quaternion):
    axis, w = quaternion[:3], quaternion[3]
    first = cross(axis, place)
    second = cross(axis, first)
    return [p + 2 * (w * a + b) for p, a, b in zip(place, first, second)]


TETRAHEDRON = ([(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)],
               [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)])


def cuboid(low, high):
    corners = [tuple(float((low, high)[i >> k & 1][k]) for k in range(3)) for i in range(8)]
    return corners, [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
