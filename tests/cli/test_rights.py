"""morphotype blend: what a font says of its origin, and what is said before it goes out."""

import os
import subprocess

import cli
from fontTools import ttLib


class Test(cli.Test):
    def changed(self, name, **changes):
        """DejaVu Serif's A with other names, by name id as nID, or another fsType."""
        cli.cut_font(self.path(name), 'A')
        font = ttLib.TTFont(self.path(name))
        for key, value in changes.items():
            if key == 'fs_type':
                font['OS/2'].fsType = value
            else:
                font['name'].setName(value, int(key[1:]), 3, 1, 0x409)
        font.save(self.path(name))
        return self.path(name)

    def names(self, name='x.ttf'):
        subprocess.run(['ots-sanitize', self.path(name)], check=True, stdout=subprocess.DEVNULL)
        table = ttLib.TTFont(self.path(name))['name']
        return {record.nameID: record.toUnicode() for record in table.names}


class Names(Test):
    def test_of_both_sources(self):
        a = self.changed('a.ttf', n0='(c) A', n7='A is a mark', n9='A. Designer', n13='Licence A', n14='https://a.example/')
        b = self.changed('b.ttf', n0='(c) B', n7='B is a mark', n9='B. Designer', n13='Licence B', n14='https://b.example/')
        self.made('blend', a, b, '--at', '0.25', '-o', 'x.ttf')
        names = self.names()
        for key, text in ((0, '(c) A\n(c) B'), (7, 'A is a mark\nB is a mark'), (9, 'A. Designer, B. Designer'),
                          (13, 'Licence A\nLicence B'), (14, 'https://a.example/ https://b.example/')):
            self.assertEqual(names[key], text)
        for text in ('DejaVu Serif Book, version 2.37', 'T = 0.25', 'Morphotype'):
            self.assertIn(text, names[10])

    def test_family_is_its_own(self):
        self.made('blend', cli.SANS_BOLD, cli.SERIF, '--text', 'A', '-o', 'x.ttf')
        names = self.names()
        for key in (1, 4, 6, 16):
            for word in ('dejavu', 'bitstream', 'vera', 'arev'):
                self.assertNotIn(word, names[key].lower())
        self.assertRegex(names[6], r'^[!-~]{1,63}$')

    def test_places_in_one_variable_font_differ(self):
        unique = set()
        for weight in (200, 800):
            self.made('blend', f'{cli.INTER}@wght={weight}', cli.SERIF, '-q', '--text', 'A', '-o', 'x.ttf')
            names = self.names()
            self.assertIn(f'@wght={weight}', names[10])
            unique.add((names[3], names[16]))
        self.assertEqual(len({u for u, _ in unique}), 2)
        self.assertEqual(len({family for _, family in unique}), 2)

    def test_dates(self):
        def dates(epoch):
            environment = {k: v for k, v in os.environ.items() if k != 'SOURCE_DATE_EPOCH'}
            environment.update({'SOURCE_DATE_EPOCH': epoch} if epoch else {})
            self.run_program('blend', cli.SANS_BOLD, cli.SERIF, '--text', 'A', '-o', 'x.ttf', env=environment)
            head = ttLib.TTFont(self.path('x.ttf'))['head']
            return head.created, head.modified
        newer = max(ttLib.TTFont(path)['head'].modified for path in (cli.SANS_BOLD, cli.SERIF))
        self.assertEqual(dates(None), (newer, newer))
        self.assertEqual(dates('1234567890'), (1234567890 + 2082844800, 1234567890 + 2082844800))


class Warnings(Test):
    def warnings(self, *arguments):
        return self.made('blend', *arguments, '-o', 'x.ttf')

    def test_nothing(self):
        a = self.changed('a.ttf')
        self.assertEqual(self.warnings(a, a), [])

    def test_embedding(self):
        a, b = self.changed('a.ttf', fs_type=2), self.changed('b.ttf', fs_type=0x104)
        said = self.warnings(a, b)
        self.assertEqual(len(said), 2, said)
        self.assertIn(f'{a} restricts its embedding (OS/2 fsType): restricted', said[0])
        self.assertIn(f'{b} restricts its embedding (OS/2 fsType): preview and print embedding only; no subsetting', said[1])
        self.assertEqual(self.warnings(a, b, '-q'), [])
        self.assertEqual(ttLib.TTFont(self.path('x.ttf'))['OS/2'].fsType, 0x102)

    def test_licence(self):
        a = self.changed('a.ttf', n13='Free of charge. This font may not be modified by anyone. Enjoy.')
        said = self.warnings(a, self.changed('b.ttf'))
        self.assertEqual(said, [f'morphotype: {a} may not permit a changed font; its licence has: '
                                '“… may not be modified by anyone …”'])

    def test_reserved_family(self):
        a = self.changed('a.ttf', n0="(c) 2020 X, with Reserved Font Name 'Foo'.", n1='Own', n16='Own')
        b = self.changed('b.ttf', n13='May be altered if renamed to names not containing the word "Vera".')
        self.assertEqual(self.warnings(a, b, '--family', 'Food Between'), [])
        for family, held, font in (('New Foo', 'Foo', a), ('own-Font', 'Own', a), ('Vera Light', 'Vera', b)):
            self.assertEqual(self.warnings(a, b, '--family', family),
                             [f'morphotype: the family name “{family}” has “{held}” in it, a name of {font}'])
            self.assertEqual(self.names()[16], family)

    def test_tables_left_out(self):
        said = self.warnings(cli.SANS_BOLD, cli.SERIF, '--text', 'A')
        self.assertEqual(said, [cli.NO_MATH])
        self.assertNotIn('MATH', ttLib.TTFont(self.path('x.ttf')))


if __name__ == '__main__':
    cli.main()
