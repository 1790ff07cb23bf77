"""A glyph takes no more work and memory than it may: kinds that once took minutes and gigabytes."""

import os
import random
import resource
import subprocess

import cli
import odd_glyphs
from fontTools.pens.ttGlyphPen import TTGlyphPen

GLYPHS = int(os.environ.get('MT_ODD_GLYPHS', 14))
SANITIZED = 'ASAN_OPTIONS' in os.environ or 'UBSAN_OPTIONS' in os.environ


class Effort(cli.Test):
    """Processor time is bounded loosely, by a limit of the system, and memory where no sanitizer adds its own."""

    def font(self, name, glyphs):
        """A font of these glyphs, from A on."""
        font = odd_glyphs.built(glyphs, ord('A'), calcGlyphBounds=False)
        font.recalcBBoxes = False # which would follow every reference
        font['maxp'].maxComponentDepth = len(glyphs)
        for glyph in glyphs.values():
            glyph.xMin, glyph.yMin, glyph.xMax, glyph.yMax = 0, 0, 1000, 1000
        font.save(self.path(name))
        return self.path(name)

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
        font = self.font('star.ttf', {'star': odd_glyphs.drawn(odd_glyphs.star(random.Random(4), 1001))})
        said = self.blend(font)
        self.assertIn('effort', said)
        again = self.path('x.ttf').read_bytes()
        self.blend(font, '-j', '3')
        self.assertEqual(self.path('x.ttf').read_bytes(), again)

    def test_nest(self):
        squares = [[(-r, -r), (r, -r), (r, r), (-r, r)][::1 if r % 2 else -1] for r in range(1, 1001)]
        font = self.font('nest.ttf', {'nest': odd_glyphs.drawn(squares)})
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
        glyphs = {'end': odd_glyphs.drawn([[(0, 0), (500, 0), (250, 700)]])}
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
        said = self.bounded('blend', *fonts, '-o', 'x.ttf', '-j', '2', seconds=60 + 20 * GLYPHS)
        self.assertNotIn('convex pieces', said)
        subprocess.run(['ots-sanitize', self.path('x.ttf')], check=True, stdout=subprocess.DEVNULL)


if __name__ == '__main__':
    cli.main()
