"""The animations that players are compared on: letters, Han, words, icons and logos, two key frames each."""

import cli


def icon(content):
    return f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 24 24">{content}</svg>'


# Icons of our own, as they are drawn on a grid of 24.
ICONS = {
    'play': icon('<path d="M7 4l13 8-13 8z"/>'),
    'pause': icon('<rect x="6" y="4" width="4.5" height="16" rx="1"/><rect x="13.5" y="4" width="4.5" height="16" rx="1"/>'),
    'menu': icon('<path d="M3 5h18v3H3zM3 10.500h18v3H3zM3 16h18v3H3z"/>'),
    'close': icon('<path d="M5 3l7 7 7-7 2 2-7 7 7 7-2 2-7-7-7 7-2-2 7-7-7-7z"/>'),
    'ring': icon('<path fill-rule="evenodd" d="M12 2a10 10 0 1 0 0 20 10 10 0 1 0 0-20zM12 6a6 6 0 1 0 0 12 6 6 0 1 0 0-12z"/>'),
    'frame': icon('<path fill-rule="evenodd" d="M3 3h18v18H3zM7 7v10h10V7z"/>'),
    'sun': icon('<circle cx="12" cy="12" r="5"/>' + ''.join(
        f'<rect x="11" y="1" width="2" height="4" rx="1" transform="rotate({angle} 12 12)"/>' for angle in range(0, 360, 45))),
    'moon': icon('<path d="M20 14.500A8.500 8.500 0 0 1 9.500 4 8.500 8.500 0 1 0 20 14.500z"/>'),
    'house': icon('<path fill-rule="evenodd" d="M12 2L2 11h3v10h14V11h3zM10 21v-6h4v6z"/>'),
    'pin': icon('<path fill-rule="evenodd" d="M12 2a7 7 0 0 0-7 7c0 5 7 13 7 13s7-8 7-13a7 7 0 0 0-7-7zm0 4.500a2.500 2.500 0 1 1 0 5 2.500 2.500 0 0 1 0-5z"/>'),
}

SANS, SERIF = cli.SANS_BOLD, cli.SERIF
DOCS = cli.SOURCE / 'docs'

# The name of each pair, and its key frames: texts of fonts, names of icons, and drawings.
PAIRS = (
    ('A – B', f'{SERIF}=A', f'{SERIF}=B'),
    ('g – g', f'{SANS}=g', f'{SERIF}=g'),
    ('a – a', f'{cli.DEMO_SANS}=a', f'{cli.DEMO_SERIF}=a'),
    ('8 – S', f'{SANS}=8', f'{SERIF}=S'),
    ('R – k', f'{SANS}=R', f'{SANS}=k'),
    ('V – M', f'{SERIF}=V', f'{SERIF}=M'),
    ('o – i', f'{SANS}=o', f'{SANS}=i'),
    ('3 – four', f'{SANS}=3', f'{SANS}=/four'),
    ('永 – 永', f'{cli.ZENHEI}=永', f'{cli.UKAI}=永'),
    ('形 – 國', f'{cli.ZENHEI}=形', f'{cli.ZENHEI}=國'),
    ('あ – 安', f'{cli.ZENHEI}=あ', f'{cli.ZENHEI}=安'),
    ('star – heart', DOCS / 'star.svg', DOCS / 'heart.svg'),
    ('play – pause', 'play', 'pause'),
    ('menu – close', 'menu', 'close'),
    ('ring – frame', 'ring', 'frame'),
    ('sun – moon', 'sun', 'moon'),
    ('house – pin', 'house', 'pin'),
    ('logo – logo', DOCS / 'logo-six.svg', DOCS / 'logo-nine.svg'),
    ('type – Morph', f'{SANS}=type', f'{SERIF}=Morph'),
    ('water – 水', f'{SERIF}=water', f'{cli.ZENHEI}=水'),
)


def key_frames(pair, directory):
    """The pair's two key frames for the command line; icons are written into the directory."""
    keys = []
    for key in pair[1:]:
        if key in ICONS:
            (directory / f'{key}.svg').write_text(ICONS[key])
            key = f'{key}.svg'
        keys.append(key)
    return keys
