"""solid, judged by the glTF validator and by Manifold."""

import os
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / 'cli'))

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


if __name__ == '__main__':
    cli.main(oracles.PROGRAMS)
