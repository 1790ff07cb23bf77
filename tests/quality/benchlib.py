"""Shared helpers of the bench (python3-fonttools 4.38 of Debian 12)."""
import sys, os, math, re
from fontTools.ttLib import TTFont, woff2
from fontTools.pens.recordingPen import DecomposingRecordingPen, RecordingPen
from fontTools.pens.basePen import BasePen

# --- fontTools 4.38 cannot read WOFF2 with the overlapSimple bitmap (WOFF2 erratum 2022): cut the trailing bitmap off.
_orig_reconstruct = woff2.WOFF2GlyfTable.reconstruct
def _reconstruct(self, data, ttFont):
    import struct
    sizes = struct.unpack('>7L', data[8:8 + 28])
    return _orig_reconstruct(self, data[:36 + sum(sizes)], ttFont)
woff2.WOFF2GlyfTable.reconstruct = _reconstruct

LATIN = ''.join(map(chr, list(range(0x41, 0x5B)) + list(range(0x61, 0x7B)) + list(range(0x30, 0x3A))))
HAN = '一二人十口日月木水火土田山石金言門車馬魚鳥风龍国学永東書春夏秋冬愛心手足目耳花草雨雪電龜鬱響驚體觀讓鷹的是不了在有我他这中大来上个'

HANGUL = '가각간갈감강개거건게경고과관구국그근글기김나날남내너네노누는니다단달당대더도동되두들등디라람래로를리마만말면명모무문물미바발방배법보부분비사산상새생서선성세소수스시식신실심아안앞애야어언업없에여역연영예오온와왕외요용우운원월위유은을의이인일있자작잔장저적전정제조종주중지진집차창책처천체초추출치카코크타터통투트특파판평포표품피하학한할함합해행향현형호화환활황회획효후흑희힘'


class FlattenPen(BasePen):
    """Flattens to polylines: list of contours, each a list of (x, y)."""
    def __init__(self, glyphSet, tol=0.5):
        super().__init__(glyphSet)
        self.tol, self.contours, self.cur = tol, [], None
    def _moveTo(self, p): self.cur = [p]
    def _lineTo(self, p): self.cur.append(p)
    def _curveToOne(self, p1, p2, p3):
        p0 = self.cur[-1]
        d = max(math.hypot(p0[0] - 2 * p1[0] + p2[0], p0[1] - 2 * p1[1] + p2[1]),
                math.hypot(p1[0] - 2 * p2[0] + p3[0], p1[1] - 2 * p2[1] + p3[1]))
        n = max(1, math.ceil(math.sqrt(0.75 * d / self.tol)))
        for i in range(1, n + 1):
            t = i / n; s = 1 - t
            self.cur.append((s*s*s*p0[0] + 3*s*s*t*p1[0] + 3*s*t*t*p2[0] + t*t*t*p3[0],
                             s*s*s*p0[1] + 3*s*s*t*p1[1] + 3*s*t*t*p2[1] + t*t*t*p3[1]))
    def _qCurveToOne(self, p1, p2):
        p0 = self.cur[-1]
        d = math.hypot(p0[0] - 2 * p1[0] + p2[0], p0[1] - 2 * p1[1] + p2[1])
        n = max(1, math.ceil(math.sqrt(0.25 * d / self.tol)))
        for i in range(1, n + 1):
            t = i / n; s = 1 - t
            self.cur.append((s*s*p0[0] + 2*s*t*p1[0] + t*t*p2[0], s*s*p0[1] + 2*s*t*p1[1] + t*t*p2[1]))
    def _closePath(self):
        c = self.cur
        if c:
            o = [c[0]]
            for p in c[1:]:
                if p != o[-1]: o.append(p)
            if len(o) > 1 and o[0] == o[-1]: o.pop()
            if len(o) > 2: self.contours.append(o)
        self.cur = None
    _endPath = _closePath


def area(c):
    return 0.5 * sum(c[i - 1][0] * c[i][1] - c[i][0] * c[i - 1][1] for i in range(len(c)))


def nonzero_union(contours, scale=64, even_odd=False):
    """Overlap-free contours: outer counter-clockwise (area>0), holes clockwise."""
    import pyclipper
    pc = pyclipper.Pyclipper()
    pc.StrictlySimple = True
    n = 0
    for c in contours:
        q = [(round(x * scale), round(y * scale)) for x, y in c]
        try:
            pc.AddPath(q, pyclipper.PT_SUBJECT, True); n += 1
        except pyclipper.ClipperException:
            pass
    if not n: return []
    ft = pyclipper.PFT_EVENODD if even_odd else pyclipper.PFT_NONZERO
    sol = pc.Execute(pyclipper.CT_UNION, ft, ft)
    out = [[(x / scale, y / scale) for x, y in p] for p in sol]
    return [c for c in out if abs(area(c)) > 2]


def glyph_polys(font, gs, name, tol=0.5, clean=True):
    pen = FlattenPen(gs, tol)
    gs[name].draw(pen)
    return nonzero_union(pen.contours) if clean else pen.contours


def svg_write(path, d, upem, advance, fill_rule='nonzero'):
    with open(path, 'w') as f:
        f.write(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 {-upem} {max(1, round(advance))} {round(1.3 * upem)}" '
                f'data-upem="{upem}" data-advance="{advance}">'
                f'<path transform="scale(1 -1)" fill-rule="{fill_rule}" d="{d}"/></svg>\n')


def svg_read(path):
    s = open(path).read()
    d = re.search(r'\sd="([^"]*)"', s).group(1)
    fr = re.search(r'fill-rule="(\w+)"', s)
    upem = float(re.search(r'data-upem="([^"]+)"', s).group(1))
    adv = re.search(r'data-advance="([^"]+)"', s)
    return d, (fr.group(1) if fr else 'nonzero'), upem, (float(adv.group(1)) if adv else None)


def polys_to_d(polys, nd=2):
    return ''.join('M' + 'L'.join(f'{x:.{nd}f},{y:.{nd}f}' for x, y in c) + 'Z' for c in polys)


def chars_of(arg):
    if arg == 'latin': return LATIN
    if arg == 'han': return HAN
    if arg == 'hangul': return HANGUL[::3]
    if os.path.exists(arg): return open(arg).read().strip()
    return arg
