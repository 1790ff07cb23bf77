"""Programs of npm that judge what solid makes. They are installed once into the build's directory, at the versions of packages.txt."""

import json
import pathlib
import shutil
import subprocess

HERE = pathlib.Path(__file__).resolve().parent
PROGRAMS = ('npm', 'node')


class Oracles:
    def __init__(self, directory):
        self.directory = pathlib.Path(directory)
        wanted = (HERE / 'packages.txt').read_text()
        done = self.directory / 'packages.txt'
        if not done.exists() or done.read_text() != wanted:
            self.directory.mkdir(parents=True, exist_ok=True)
            (self.directory / 'package.json').write_text('{"private": true}\n')
            subprocess.run(['npm', 'install', '--no-audit', '--no-fund', '--no-save', '--ignore-scripts', *wanted.split()],
                           cwd=self.directory, check=True, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, timeout=300)
            for script in ('validate.cjs', 'union.mjs'): # beside the packages, where node looks for them
                shutil.copy(HERE / script, self.directory / script)
            done.write_text(wanted)

    def run(self, script, *arguments, **options):
        result = subprocess.run(['node', self.directory / script, *arguments], check=True, text=True,
                                stdout=subprocess.PIPE, timeout=300, **options)
        return json.loads(result.stdout)

    def validate(self, *files):
        """Of each GLB what the validator says: {'numErrors': 0, 'messages': […], …}."""
        return self.run('validate.cjs', *files)

    def union(self, solids):
        """Of each solid, a list of closed meshes (points, triangles): {'volume': v, 'parts': [{'genus': g, 'volume': v}, …]}."""
        flat = [[{'points': [c for point in points for c in point], 'triangles': [c for t in triangles for c in t]}
                 for points, triangles in meshes] for meshes in solids]
        return self.run('union.mjs', input=json.dumps(flat))


def shells(points, triangles):
    """A mesh of meshes that share no point, one by one."""
    parent = list(range(len(points)))

    def root(i):
        while parent[i] != i:
            parent[i] = i = parent[parent[i]]
        return i

    for triangle in triangles:
        for corner in triangle[1:]:
            parent[root(corner)] = root(triangle[0])
    groups = {}
    for triangle in triangles:
        groups.setdefault(root(triangle[0]), []).append(triangle)
    for group in groups.values():
        numbers = {}
        own = [tuple(numbers.setdefault(corner, len(numbers)) for corner in triangle) for triangle in group]
        yield [points[corner] for corner in numbers], own
