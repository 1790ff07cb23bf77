#!/usr/bin/python3
"""defaults.py BUILD

Prints the two tables of docs/paper.md, "How the defaults were chosen", with the programs of the build directory: matches of
every 19th of the common characters of GB 2312 between WenQuanYi Zen Hei and AR PL UKai; points half-way, and the distance from
the source at T = 1, of letters and digits of DejaVu Sans Bold and DejaVu Serif.
"""
import json, os, pathlib, re, statistics, string, subprocess, sys, tempfile

HERE = pathlib.Path(__file__).resolve().parent
FONTS = '/usr/share/fonts/truetype/'
HAN = [FONTS + 'wqy/wqy-zenhei.ttc', FONTS + 'arphic/ukai.ttc']
LATIN = [FONTS + 'dejavu/DejaVuSans-Bold.ttf', FONTS + 'dejavu/DejaVuSerif.ttf']
MATCHING = ['', '--rounds 0', '--rounds 1', '--rounds 3', '--rounds 30', '--rounds 100', '--threshold 0', '--threshold 0.25',
            '--threshold 0.75', '--threshold 1', '--weights 1,0,0', '--weights 0,1,0', '--weights 0,0,1',
            '--weights 0.34,0.33,0.33', '--weights 0.5,0,0.5']
CURVES = [(0.25, 0.35), (0.5, 0.2), (0.5, 0.35), (0.5, 0.5), (0.5, 1), (1, 0.35), (2, 0.35)]


def output_of(*command, code=(0,), **more):
    run = subprocess.run([str(word) for word in command], capture_output=True, text=True, **more)
    if run.returncode not in code:
        sys.exit(run.stderr.strip() or f'{command[0]} ended with {run.returncode}')
    return run.stdout


def matching(program):
    text = (HERE / 'gb2312-level1.txt').read_text(encoding='utf-8')
    characters = ''.join(re.sub('#.*', '', text).split())[::19]
    print('| changed | glyphs matched otherwise | matches beyond the least |\n|---|---|---|')
    usual = None
    for options in MATCHING:
        glyphs = json.loads(output_of(program, 'inspect', *HAN, '--text', characters, '--json', '--method', 'paper',
                                      *options.split()))['glyphs']
        usual = usual or glyphs
        others = sum(x['matches'] != y['matches'] for x, y in zip(usual, glyphs))
        beyond = sum(len(g['matches']) - max(len(g[side]['components']) for side in 'ab') for g in glyphs)
        print(f'| `{options}` | {others} | {beyond} |' if options else f'| nothing | – | {beyond} |', flush=True)


def points(program, tolerance, fit):
    with tempfile.TemporaryDirectory() as directory:
        out = os.path.join(directory, 'x.json')
        output_of(program, 'report', *LATIN, '--text', string.ascii_letters + string.digits, '--tolerance', tolerance,
                  '--fit', fit, '-q', '-o', out)
        glyphs = json.loads(pathlib.Path(out).read_text(encoding='utf-8'))['glyphs']
    return statistics.median(g['half']['points'] / max(g['a']['points'], g['b']['points']) for g in glyphs)


def curves(program, ends):
    print('| `--tolerance` | `--fit` | points | mean | largest |\n|---|---|---|---|---|')
    for tolerance, fit in CURVES:
        said = output_of(ends, *LATIN, 1, '30-39', '41-5a', '61-7a', code=(0, 1),
                         env={**os.environ, 'MT_TOLERANCE': str(tolerance), 'MT_FIT': str(fit)})
        mean, largest = re.search(r'mean ([\d.]+), largest ([\d.]+)', said).groups()
        print(f'| {tolerance} | {fit} | {points(program, tolerance, fit):.2f} | {mean} | {largest} |', flush=True)


if len(sys.argv) != 2:
    sys.exit(__doc__)
matching(f'{sys.argv[1]}/morphotype')
print()
curves(f'{sys.argv[1]}/morphotype', f'{sys.argv[1]}/tests/ends/ends')
