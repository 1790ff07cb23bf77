"""The recipes, run as they stand."""

import pathlib
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

sys.path.insert(0, str(pathlib.Path(__file__).parent))

from fontTools.ttLib import TTFont

import morphotype
from support import ROOT, SANS, SERIF


class Recipes(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_recipe(self, name, *arguments):
        program = ROOT / 'python' / 'recipes' / f'{name}.py'
        return subprocess.run([sys.executable, '-B', program, *map(str, arguments)], cwd=self.folder,
                              capture_output=True, text=True, check=False)

    def test_batch(self):
        lines = [f'{SANS} {SERIF} one.ttf', f'{SANS} missing.ttf two.ttf', f'{SERIF} {SANS} three.ttf']
        (self.folder / 'pairs.txt').write_text('\n'.join(lines))
        result = self.run_recipe('batch', 'pairs.txt')
        self.assertEqual(result.returncode, 1)
        self.assertTrue(result.stderr.startswith('missing.ttf: the file is missing or cannot be read'))
        self.assertEqual((self.folder / 'one.ttf').read_bytes(), morphotype.blend(SANS, SERIF))
        self.assertIn('glyf', TTFont(self.folder / 'three.ttf'))
        self.assertFalse((self.folder / 'two.ttf').exists())

    def test_fontmake_project(self):
        result = self.run_recipe('fontmake_project', SANS, SERIF, '0.4', 'Between', 'Bold', 'sources')
        self.assertEqual(result.returncode, 0, result.stderr)
        ufo = self.folder / 'sources' / 'Between-Bold.ufo'
        self.assertIn('Between', (ufo / 'fontinfo.plist').read_text())
        self.assertTrue((ufo / 'glyphs' / 'contents.plist').exists())

    def test_notebook(self):
        result = self.run_recipe('notebook', SANS, SERIF, 'ty')
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertTrue(ElementTree.fromstring(result.stdout).tag.endswith('svg'))

    def test_gate(self):
        flagged = morphotype.report(SANS, SERIF, chars='形t').flagged
        self.assertEqual([glyph.char for glyph in flagged], ['形'])
        result = self.run_recipe('gate', SANS, SERIF, '0', '形t')
        self.assertEqual((result.returncode, result.stdout[:1]), (1, '形'))
        self.assertEqual(self.run_recipe('gate', SANS, SERIF, '1', '形t').returncode, 0)

    def test_designspace(self):
        result = self.run_recipe('designspace', SANS, SERIF, '400', '900', 'x.designspace')
        self.assertEqual(result.returncode, 0, result.stderr)
        root = ElementTree.parse(self.folder / 'x.designspace').getroot()
        (axis,) = root.iter('axis')
        self.assertEqual((axis.get('tag'), axis.get('minimum'), axis.get('maximum')), ('wght', '400', '900'))
        for source in root.iter('source'):
            self.assertTrue((self.folder / source.get('filename')).is_dir())


if __name__ == '__main__':
    unittest.main()
