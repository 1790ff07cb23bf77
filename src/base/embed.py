"""Writes a page as C: its markup cut at its slots, with the style, the script and the policy in it.

    embed.py OUT.c NAME PAGE.html HEAD.html STYLE.css… SCRIPT.js…

NAME is that of the array of parts, and HEAD what the heads of all pages have. Styles become one, and scripts, in the order given. The policy lets in this style and this
script, by their digests (Content Security Policy, section 2.3.1), fonts and the icon as data: URLs, and nothing else.
"""

import base64
import hashlib
import pathlib
import re
import sys

# What may be filled in when a page is made; base/page.h has the same names.
SLOTS = {'version', 'title', 'body', 'data', 'font'}


def read(name):
    return pathlib.Path(name).read_text(encoding='utf-8')


def digest(text):
    return f"'sha256-{base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()}'"


def policy(styles, scripts, *others):
    """Lets in these styles and scripts, and what the other rules say."""
    rules = ("default-src 'none'", ' '.join(['style-src', *map(digest, styles)]), ' '.join(['script-src', *map(digest, scripts)]),
             'font-src data:', 'img-src data:', "base-uri 'none'", "form-action 'none'", "require-trusted-types-for 'script'")
    return '; '.join((*rules, *others))


def check(name, text, end):
    """Text that would end its element, or that a browser would read otherwise than it stands here."""
    if end in text.lower() or '<!--' in text or '{{' in text:
        sys.exit(f'{name}: has {end}, <!-- or {{{{ in it')


def fill(page, contents):
    for name, text in contents.items():
        if page.count('{{%s}}' % name) != 1:
            sys.exit(f'the page: {name} is wanted once')
        page = page.replace('{{%s}}' % name, text)
    return page


def cut(page):
    """The markup before each slot, with the slot's name; the last has none."""
    pieces = re.split(r'\{\{(\w+)\}\}', page)
    slots = pieces[1::2]
    if len(set(slots)) < len(slots) or set(slots) - SLOTS:
        sys.exit(f'the page: each of {", ".join(sorted(SLOTS))} may stand in it once')
    return list(zip(pieces[0::2], [*pieces[1::2], 'end']))


def array(index, text):
    data = text.encode()
    rows = (', '.join(map(str, data[i:i + 24])) for i in range(0, len(data), 24))
    return f'static const uint8_t part_{index}[] = {{\n    ' + ',\n    '.join(rows) + ',\n};\n'


def source(name, parts):
    arrays = ''.join(array(index, text) for index, (text, _) in enumerate(parts))
    rows = ''.join(f'    {{part_{index}, sizeof part_{index}, MT_SLOT_{slot.upper()}}},\n'
                   for index, (_, slot) in enumerate(parts))
    return ('/* Made by base/embed.py. */\n#include "base/page.h"\n\n' + arrays +
            f'extern const mt_page_part {name}[];\nconst mt_page_part {name}[] = {{\n' + rows + '};\n')


def join(files):
    """All styles as one, and all scripts."""
    style, script = (''.join(read(file) for file in files if file.endswith(end)) for end in ('.css', '.js'))
    check('the style', style, '</style')
    check('the script', script, '</script')
    return style, script


def main():
    out, name, page, head, *files = sys.argv[1:]
    style, script = join(files)
    page = fill(read(page), {'head': read(head), 'policy': policy([style], [script]), 'style': style, 'script': script})
    pathlib.Path(out).write_text(source(name, cut(page)), encoding='utf-8')


if __name__ == '__main__':
    main()
