"""solid, judged by the glTF validator and by Manifold."""

import os
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / 'tests' / 'cli'), str(ROOT / 'docs')]

import classic_duck
import cli
import meshes
import oracles

SOLIDS = cli.SOURCE / 'solids'
NAMES = ('block', 'goblet', 'goblet-hollow', 'iron', 'duck')
GENUS = {'block': 1, 'goblet': 0, 'goblet-hollow': 0, 'iron': 1, 'duck': 0}


def model(name):
    return SOLIDS / f'{name}.obj'


class Oracle(cli.Test):
    @classmethod
    def setUpClass(cls):
        cls.oracles = oracles.Oracles(os.environ['ORACLES'])

    def union_of(self, *paths):
        return self.oracles.union([list(oracles.shells(*meshes.read(path))) for path in paths])

    def made_meshes(self, a, b, places):
        """The solid at each place."""
        self.made('solid', model(a), model(b), '-q', '--at', ','.join(places), '-o', 'x.obj')
        return [self.path(f'x-{place}.obj' if len(places) > 1 else 'x.obj') for place in places]


class Validator(Oracle):
    """Every GLB is valid glTF."""

    def test_morphs_and_meshes(self):
        turn = ('--rotate', '300', '--about', 'z', '--yoyo')
        for i, (a, b) in enumerate(zip(NAMES, NAMES[1:] + NAMES[:1])):
            self.made('solid', model(a), model(b), '-q', '-o', f'{i}.glb')
            self.made('solid', model(a), model(b), '-q', *turn, '-o', f'turn-{i}.glb')
            self.made('solid', model(a), model(b), '-q', '--at', '0,0.5', '-o', f'mesh-{i}.glb')
        files = sorted(path for path in self.files())
        for file, issues in zip(files, self.oracles.validate(*files), strict=True):
            self.assertEqual((issues['numErrors'], issues['numWarnings']), (0, 0), (file.name, issues['messages']))


class Manifold(Oracle):
    """Volumes, parts and holes."""

    def test_models(self):
        """The models are what solids/README.md says, and so is what goes in and out."""
        for name in NAMES:
            (path,) = self.made_meshes(name, name, ['0'])
            (solid,) = self.union_of(path)
            self.assertEqual([part['genus'] for part in solid['parts']], [GENUS[name]], name)
            self.assertAlmostEqual(solid['volume'], meshes.volume(*meshes.read(path)), 5)


class Figures(Oracle):
    """What is between the solids of figures 4 and 5, at 21 places."""

    # A needle as long as the solid and as wide as the last of 24 bits of a coordinate: what Manifold, which rounds to so many, makes of
    # faces that lie in one plane. What has less volume than that, as a share of the solid's, is no part.
    DUST = 2.0 ** -48

    def follow(self, a, b):
        """The genus of the solid at each place."""
        self.made('solid', a, b, '-q', '--steps', '21', '-o', 'way.obj')
        paths = sorted((path for path in self.files() if path.name.startswith('way-')),
                       key=lambda path: float(path.stem.split('-')[1]))
        solids = self.union_of(*paths)
        first, last = (solids[i]['volume'] ** (1 / 3) for i in (0, -1))
        for i, solid in enumerate(solids):
            mix, volume = (first + (last - first) * i / 20) ** 3, solid['volume']
            self.assertTrue(0.95 <= volume / mix <= 1.2, (i, volume / mix))
            parts = [part['volume'] for part in solid['parts'] if abs(part['volume']) > self.DUST * volume]
            self.assertEqual(sum(part > 0 for part in parts), 1, (i, parts))
            self.assertLessEqual(-sum(part for part in parts if part < 0), 0.025 * volume, i)
        return [max(solid['parts'], key=lambda part: part['volume'])['genus'] for solid in solids]

    def test_block_to_goblet(self):
        genus = self.follow(model('block'), model('goblet'))
        self.assertEqual((genus[0], genus[-1], sum(g != h for g, h in zip(genus, genus[1:]))), (1, 0, 1), genus)

    def test_duck_to_iron(self):
        self.follow(model('duck'), model('iron'))

    def test_classic_duck_to_iron(self):
        found = classic_duck.read()
        if not found:
            self.skipTest(f'no {classic_duck.MODEL}')
        self.path('duck.obj').write_text(found[0])
        self.follow('duck.obj', model('iron'))


if __name__ == '__main__':
    cli.main(oracles.PROGRAMS)
