#!/usr/bin/env python3
"""Draws the classic duck of Debian's package assimp-testmodels on its way to the iron, as figure 5 has it.

    classic_duck.py PROGRAM DIRECTORY

Writes classic-duck.png to DIRECTORY, and beside it the duck's own notice, classic-duck.txt. The duck stays where its package has it:
its license does not let it into this repository. Ends with 77 where the package is not installed. The duck may have 12 pieces.
"""

import json
import pathlib
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

MODEL = pathlib.Path('/usr/share/assimp/models/Collada/duck.dae')
IRON = pathlib.Path(__file__).resolve().parent.parent / 'solids' / 'iron.obj'
SPACES = {'c': 'http://www.collada.org/2005/11/COLLADASchema'}
PIECES = 12


def obj_of(mesh, unit):
    """A COLLADA mesh of polygons as OBJ, in metres."""
    polygons = mesh.find('c:polylist', SPACES)
    inputs = {i.get('semantic'): i for i in polygons.findall('c:input', SPACES)}
    width, offset = 1 + max(int(i.get('offset')) for i in inputs.values()), int(inputs['VERTEX'].get('offset'))
    vertices = mesh.find(f'c:vertices[@id="{inputs["VERTEX"].get("source")[1:]}"]/c:input[@semantic="POSITION"]', SPACES)
    numbers = mesh.find(f'c:source[@id="{vertices.get("source")[1:]}"]/c:float_array', SPACES).text.split()
    places = [f'{float(number) * unit:.9g}' for number in numbers]
    corners = [int(n) + 1 for n in polygons.find('c:p', SPACES).text.split()[offset::width]]
    lines = [f'v {" ".join(places[i:i + 3])}' for i in range(0, len(places), 3)]
    for count in map(int, polygons.find('c:vcount', SPACES).text.split()):
        lines.append('f ' + ' '.join(map(str, corners[:count])))
        corners = corners[count:]
    return '\n'.join(lines) + '\n'


def read():
    """The duck as OBJ, and its notice; or None where it is not installed."""
    if not MODEL.exists():
        return None
    root = xml.etree.ElementTree.parse(MODEL).getroot()
    unit = float(root.find('.//c:unit', SPACES).get('meter'))
    return obj_of(root.find('.//c:mesh', SPACES), unit), root.find('.//c:copyright', SPACES).text.strip() + '\n'


def main(program, directory):
    found = read()
    if not found:
        sys.exit(77)
    with tempfile.TemporaryDirectory() as place:
        duck = pathlib.Path(place) / 'duck.obj'
        duck.write_text(found[0])
        picture = directory / 'classic-duck.png'
        made = subprocess.run([program, 'solid', duck, IRON, '--steps', '11', '--size', '100', '-o', picture, '--json'],
                              check=True, stdout=subprocess.PIPE, text=True)
    (directory / 'classic-duck.txt').write_text(found[1])
    pieces = len(json.loads(made.stdout)['a']['pieces'])
    print(f'{picture}: {pieces} pieces')
    sys.exit(pieces > PIECES)


if __name__ == '__main__':
    main(sys.argv[1], pathlib.Path(sys.argv[2]))
