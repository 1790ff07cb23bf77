#!/usr/bin/python3
"""topology.py MORPHOTYPE --chars FILE A B [A B …] [-- OPTIONS FOR REPORT …]
Runs `morphotype report` for each pair of fonts, with both methods, over the characters of the file (as --chars of the program
reads it), without the forms that their layout makes of them, and prints a Markdown table: how many glyphs keep their counts of components and holes in the range of the ends'
at every place, and how many their ink within the limit of it. Glyphs that fail count as out of both.
"""
import json, os, subprocess, sys, tempfile


def report(program, a, b, chars, method, extra):
    with tempfile.TemporaryDirectory() as directory:
        out = os.path.join(directory, 'x.json')
        command = [program, 'report', a, b, '--chars', chars, '--no-layout', '--method', method, '-o', out, '-q', *extra]
        run = subprocess.run(command, capture_output=True, text=True)
        if run.returncode:
            sys.exit(run.stderr.strip() or f'{program} ended with {run.returncode}')
        with open(out, encoding='utf-8') as file:
            return json.load(file)


def name(font):
    return ' '.join(part for part in (font['family'], font['style']) if part)


def main():
    args, extra = sys.argv[1:], []
    if '--' in args:
        extra = args[args.index('--') + 1:]
        args = args[:args.index('--')]
    if '--chars' not in args[:-1]:
        sys.exit(__doc__)
    i = args.index('--chars')
    chars = args[i + 1]
    del args[i:i + 2]
    program, fonts = args[0] if args else '', args[1:]
    if len(fonts) < 2 or len(fonts) % 2:
        sys.exit(__doc__)
    print('| pair | method | glyphs | counts in the range of the ends | ink within its limit |\n|---|---|---|---|---|')
    for a, b in zip(fonts[::2], fonts[1::2]):
        for method in ('joint', 'paper'):
            data = report(program, a, b, chars, method, extra)
            s = data['summary']
            print(f"| {name(data['a'])}, {name(data['b'])} | {method} | {s['glyphs']} | {100 * s['counts_in_range']:.1f} % "
                  f"| {100 * s['ink_in_range']:.1f} % |", flush=True)


if __name__ == '__main__':
    main()
