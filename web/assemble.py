"""Writes the page that needs no install: one file of HTML with the styles, the script, the engine and the demo fonts in it.

    assemble.py OUT.html VERSION ENGINE.js WORKER.js PAGE.html HEAD.html STYLE.css… SCRIPT.js… --specimen FILE… --demo FONT FONT

The specimen that it shows is a page of its own, whose style and script (FILE…) the policy lets in too, by their digests: what a
page makes is bound by its policy. Nothing else can be asked for, from wherever it comes: default-src 'none'.
"""

import argparse
import base64
import json
import pathlib
import sys

sys.path[:0] = [str(pathlib.Path(__file__).resolve().parents[1] / 'src' / 'base')]

import embed

# The worker runs the engine, whose script and code are in the page; the specimen stands in a frame.
RULES = ("worker-src blob:", "frame-src blob:", "trusted-types engine")


def demo(paths):
    return [{'name': pathlib.Path(path).name, 'base64': base64.b64encode(pathlib.Path(path).read_bytes()).decode()} for path in paths]


def main():
    parser = argparse.ArgumentParser()
    for name in ('out', 'version', 'engine', 'worker', 'page', 'head'):
        parser.add_argument(name)
    parser.add_argument('files', nargs='+')
    parser.add_argument('--specimen', nargs='+')
    parser.add_argument('--demo', nargs=2)
    given = parser.parse_args()
    style, script = embed.join(given.files)
    specimen_style, specimen_script = embed.join(given.specimen)
    engine = embed.read(given.engine) + embed.read(given.worker)
    if '</script' in engine.lower() or '<!--' in engine:
        sys.exit('the engine: has </script or <!-- in it')
    policy = embed.policy([style, specimen_style], [script, specimen_script], *RULES).replace(
        'script-src ', "script-src 'wasm-unsafe-eval' ")
    page = embed.fill(embed.read(given.page), {'head': embed.read(given.head), 'data': json.dumps({'demo': demo(given.demo)})})
    page = page.replace('{{version}}', given.version)
    page = embed.fill(page, {'policy': policy, 'style': style, 'script': script, 'engine': engine})
    pathlib.Path(given.out).write_text(page, encoding='utf-8')


main()
