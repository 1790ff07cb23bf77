"""A glyph takes no more work and memory than it may: kinds that once took minutes and gigabytes."""

import os
import random
import resource
import subprocess

import cli
import odd_glyphs
from fontTools.fontBuilder import FontBuilder
from fontTools.pens.ttGlyphPen import TTGlyphPen

GLYPHS = int(os.environ.get('MT_ODD_GLYPHS', 14))
SANITIZED = 'ASAN_OPTIONS' in os.environ or 'UBSAN_OPTIONS' in os.environ


class Effort(cli.Test):
    """Processor time is bounded loosely, by a limit of the system, and memory where no sanitizer adds its own."""

    def font(self, name, glyphs):
        """A font of these glyphs, from A on."""
        builder = FontBuilder(1000, isTTF=True)
        order = ['.notdef', *glyphs]
        builder.setupGlyphOrder(order)
        builder.setupCharacterMap({ord('A') + i: glyph for i, glyph in enumerate(glyphs)})
        builder.setupGlyf({'.notdef': TTGlyphPen(None).glyph(), **glyphs}, calcGlyphBounds=False)
        builder.setupHorizontalMetrics({glyph: (1000, 0) for glyph in order})
        builder.setupHorizontalHeader(ascent=800, descent=-200)
        builder.setupNameTable({'familyName': 'Bounded', 'styleName': 'Regular'})
        builder.setupOS2()
        builder.setupPost()
        builder.font.recalcBBoxes = False # which would follow every reference
        builder.font['maxp'].maxComponentDepth = len(glyphs)
        for glyph in glyphs.values():
            glyph.xMin, glyph.yMin, glyph.xMax, glyph.yMax = 0, 0, 1000, 1000
        builder.save(self.path(name))
        return self.path(name)

    @staticmethod
    def drawn(contours):
        pen = TTGlyphPen(None)
        for contour in contours:
            placed = [(round(x), round(y)) for x, y in contour]
            pen.moveTo(placed[0])
            for p in placed[1:]:
                pen.lineTo(p)
            pen.closePath()
        return pen.glyph()

    def bounded(self, *arguments, seconds=60):
        """Runs it, expects success, and gives stderr; a GiB of addresses suffices."""
        def limit():
            resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds))
            if not SANITIZED:
                resource.setrlimit(resource.RLIMIT_AS, (1 << 30, 1 << 30))
        result = self.run_program(*arguments, preexec_fn=limit)
        self.assertEqual(result.returncode, 0, result.stderr.decode())
        return result.stderr.decode()

    def blend(self, font, *options):
        return self.bounded('blend', font, cli.SERIF, '--text', 'A', '-j', '1', '-o', 'x.ttf', *options)

    def test_star(self):
        font = self.font('star.ttf', {'star': self.drawn(odd_glyphs.star(random.Random(4), 1001))})
        said = self.blend(font)
        self.assertIn('effort', said)
        again = self.path('x.ttf').read_bytes()
        self.blend(font, '-j', '3')
        self.assertEqual(self.path('x.ttf').read_bytes(), again)

    def test_nest(self):
        squares = [[(-r, -r), (r, -r), (r, r), (-r, r)][::1 if r % 2 else -1] for r in range(1, 1001)]
        font = self.font('nest.ttf', {'nest': self.drawn(squares)})
        self.assertIn('than a glyph may', self.blend(font))

    def test_effort_is_settable(self):
        said = self.bounded('blend', cli.ZENHEI, cli.UKAI, '--text', '龜龍', '--effort', '0.1', '-o', 'x.ttf')
        self.assertIn('2 glyphs took', said)
        self.assertIn('effort', said)
        said = self.bounded('blend', cli.ZENHEI, cli.UKAI, '--text', 'A', '-o', 'x.ttf')
        self.assertNotIn('effort', said)
        self.refused(2, 'blend', cli.SANS_BOLD, cli.SERIF, '--effort', '0', '-o', 'y.ttf', says=['--effort'])

    def references(self, name, depth, names_twice):
        """Glyphs of which each names the next one, the last a triangle."""
        glyphs = {'end': self.drawn([[(0, 0), (500, 0), (250, 700)]])}
        for i in range(depth):
            pen = TTGlyphPen({glyph: None for glyph in glyphs})
            for k in range(1 + names_twice):
                pen.addComponent(list(glyphs)[-1], (1, 0, 0, 1, k, 0))
            glyphs[f'step{i}'] = pen.glyph()
        return self.font(name, dict(reversed(glyphs.items())))

    def test_references_that_double(self):
        self.assertIn('too large', self.blend(self.references('double.ttf', 26, True)))

    def test_references_that_do_not(self):
        self.assertNotIn('not blended', self.blend(self.references('chain.ttf', 12, False)))

    def test_odd_glyphs(self):
        fonts = [odd_glyphs.font(self.path(f'odd{i}.ttf'), GLYPHS, i, 30000) for i in (1, 2)]
        self.bounded('blend', *fonts, '-o', 'x.ttf', '-j', '2', seconds=60 + 20 * GLYPHS)
        subprocess.run(['ots-sanitize', self.path('x.ttf')], check=True, stdout=subprocess.DEVNULL)


if __name__ == '__main__':
    cli.main()
