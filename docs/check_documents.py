"""Holds the documents to the files, functions and options that they name.

    check_documents.py PROGRAM

Links lead to files and headings that are there. A path between back quotes is a file of the repository, of src/ or of
src/morph/, and so are the files in architecture.md's table of rooms. A name that begins with mt_ or MT_ stands in src/ or
tests/. docs/guide.md has every command of PROGRAM and every option of each. The version is that of PROGRAM wherever it is named.
"""

import pathlib
import re
import subprocess
import sys

(PROGRAM,) = sys.argv[1:]
ROOT = pathlib.Path(__file__).resolve().parent.parent
DOCUMENTS = sorted([*ROOT.glob('*.md'), *(ROOT / 'docs').glob('*.md')])
PLACES = [ROOT, ROOT / 'src', ROOT / 'src' / 'morph', ROOT / 'docs']
PATH = re.compile(r'(?:[\w.-]+/)+(?:[\w.-]+\.(?:c|h|cpp|py|js|css|html|md|txt))?')


def prose_of(text):
    """The text without its blocks of code."""
    return re.sub(r'^(?:    |```).*$', '', text, flags=re.M)


def anchor_of(heading):
    """The anchor of a heading, as web pages of repositories make it."""
    return re.sub(r'[^\w\- ]', '', heading.lower().replace('`', '')).strip().replace(' ', '-')


def check_links(document, text):
    for target in re.findall(r'\]\(([^)\s]+)\)', text):
        if '://' in target:
            continue
        name, _, anchor = target.partition('#')
        path = (document.parent / name).resolve() if name else document
        if not path.exists():
            yield f'no file {target}'
        elif anchor:
            headings = re.findall(r'^#+ (.*)$', path.read_text(encoding='utf-8'), flags=re.M)
            if anchor not in map(anchor_of, headings):
                yield f'no heading {target}'


def check_paths(text):
    for name in re.findall(r'`([^`\n]+)`', text):
        is_path = PATH.fullmatch(name) and not name.startswith(('demo/', 'http'))
        if is_path and not any((place / name).exists() for place in PLACES):
            yield f'no file {name}'


def check_files(text):
    """The rows | room | files | purpose |, of which an empty room is that of the row above."""
    room = ''
    section = text.partition('\n## Files\n')[2].partition('\n## ')[0].partition('|---')[2]
    for first, files in re.findall(r'^\| ([^|]*) ?\| ([^|]+) \|[^|]+\|$', section, flags=re.M):
        room = re.sub('[`–]', '', first).strip() or room
        for name in re.findall(r'`([^`]+)`', files):
            stem = name.removeprefix(room).rstrip('/')
            if not [*(ROOT / 'src' / room).glob(f'{stem}*')]:
                yield f'no file {room}{stem}'


def check_names(text, source):
    for name in set(re.findall(r'\bmt_\w+|\bMT_\w+', text)):
        if not re.search(rf'\b{name}\b', source):
            yield f'no {name} in the source'


def help_of(*arguments):
    return subprocess.run([PROGRAM, *arguments, '--help'], capture_output=True, text=True, check=True).stdout


def check_guide(text):
    for command in re.findall(r'^  ([a-z]+)  ', help_of(), flags=re.M):
        if not re.search(rf'^\| \[`{command}`\]', text, flags=re.M):
            yield f'{command} is not in the table of commands'
        for option in re.findall(r'^ .*?(--[a-z-]+)', help_of(command), flags=re.M):
            if option != '--help' and f'`{option}' not in text and f', `{option}' not in text:
                yield f'{command} {option} is in no table'


# The newest version in each text that names it.
VERSIONS = {
    'CHANGELOG.md': r'^## (\S+)',
    'README.md': r'^Version ([\d.]+\d)',
    'debian/changelog': r'^morphotype \((.*?)\)',
}


def check_versions():
    version = subprocess.run([PROGRAM, '--version'], capture_output=True, text=True, check=True).stdout.split()[-1]
    for name, pattern in VERSIONS.items():
        found = re.search(pattern, (ROOT / name).read_text(encoding='utf-8'), flags=re.M)
        if not found or found[1] != version:
            yield f'{name}: its version is not that of the program, {version}'


sources = [*(ROOT / 'src').rglob('*.[ch]'), *(ROOT / 'src').rglob('*.cpp'), *(ROOT / 'tests').rglob('*.[ch]')]
source = '\n'.join(path.read_text(encoding='utf-8') for path in sources)
failures = [*check_versions()]
for document in DOCUMENTS:
    text = document.read_text(encoding='utf-8')
    found = [*check_links(document, text), *check_paths(prose_of(text)), *check_names(text, source)]
    if document.name == 'architecture.md':
        found += check_files(text)
    if document.name == 'guide.md':
        found += check_guide(text)
    failures += [f'{document.relative_to(ROOT)}: {failure}' for failure in found]
print('\n'.join(failures) or f'{len(DOCUMENTS)} documents name what is there')
sys.exit(bool(failures))
