"""--style and --axis: names of fonts, of their styles, and of the places on an axis; and the tables that go by them."""

import subprocess

import cli
from fontTools import designspaceLib, ttLib
from fontTools.varLib import instancer

SANS = cli.DEBIAN / 'truetype/dejavu/DejaVuSans.ttf'
OBLIQUE = cli.DEBIAN / 'truetype/dejavu/DejaVuSans-Oblique.ttf'
TEXT = 'HÅx.AVT'


class Test(cli.Test):
    def font(self, name='x.ttf'):
        subprocess.run(['ots-sanitize', self.path(name)], check=True, stdout=subprocess.DEVNULL)
        return ttLib.TTFont(self.path(name))

    @staticmethod
    def names(font):
        return {record.nameID: record.toUnicode() for record in font['name'].names}


class Styles(Test):
    def blend(self, style, *more):
        self.made('blend', SANS, cli.SANS_BOLD, '--text', 'A', '--family', 'Café Neu', '--style', style, '-o', 'x.ttf', *more)
        font = self.font()
        names = self.names(font)
        return [names.get(i) for i in (1, 2, 4, 6, 16, 17)], font

    def test_linked(self):
        for style, family, linked, selection, mac, weight in (
                ('Regular', '', 'Regular', 64, 0, 400), ('Bold', '', 'Bold', 32, 1, 700), ('Italic', '', 'Italic', 1, 2, 400),
                ('Bold Italic', '', 'Bold Italic', 33, 3, 700), ('SemiBold', ' SemiBold', 'Regular', 64, 0, 600),
                ('Light Italic', ' Light', 'Italic', 1, 2, 300), ('Condensed Bold', ' Condensed', 'Bold', 32, 1, 700)):
            names, font = self.blend(style)
            true = [None, None] if style == linked else ['Café Neu', style]
            postscript = f'CafeNeu-{style.replace(" ", "")}'
            self.assertEqual(names, [f'Café Neu{family}', linked, f'Café Neu {style}', postscript] + true)
            self.assertEqual((font['OS/2'].fsSelection & 0x61, font['head'].macStyle, font['OS/2'].usWeightClass),
                             (selection, mac, weight), style)
        self.assertEqual(font['OS/2'].usWidthClass, 3)

    def test_own_word_keeps_the_figures(self):
        names, font = self.blend('Display')
        self.assertEqual(names[4:], ['Café Neu', 'Display'])
        self.assertEqual(font['OS/2'].usWeightClass, 550)

    def test_one_for_each_place(self):
        self.made('blend', SANS, cli.SANS_BOLD, '--text', 'A', '--at', '0,0.5,1', '--style', 'Regular,Medium,Bold', '-o', 'x.ttf')
        for t, style in (('0', 'Regular'), ('0.5', 'Medium'), ('1', 'Bold')):
            names = self.names(self.font(f'x-{t}.ttf'))
            self.assertEqual(names.get(17, names[2]), style)
        self.refused(2, 'blend', SANS, cli.SANS_BOLD, '--at', '0,1', '--style', 'Bold', '-o', 'y.ttf', says=['--style', '1 name'])
        for style in ('', 'A,', ',A'):
            self.refused(2, 'blend', SANS, cli.SANS_BOLD, '--style', style, '-o', 'y.ttf', says=['--style'])

    def test_ufo(self):
        self.made('blend', SANS, cli.SANS_BOLD, '--text', 'A', '--family', 'Neu', '--style', 'Light Italic', '-o', 'x.ufo')
        info = (self.path('x.ufo') / 'fontinfo.plist').read_text()
        self.assertIn('<key>styleMapFamilyName</key><string>Neu Light</string>', ''.join(info.split('\n')).replace('  ', ''))
        self.assertIn('<string>italic</string>', info)

    def test_caret_leans_with_the_letters(self):
        for at, angle in ((0, 0), (0.5, -5.5), (1, -11)):
            self.made('blend', SANS, OBLIQUE, '--text', 'A', '--at', at, '-o', 'x.ttf')
            font = self.font()
            hhea = font['hhea']
            self.assertAlmostEqual(font['post'].italicAngle, angle, delta=0.01)
            run = {0: 0, 0.5: 0.0963, 1: 0.1944}[at]
            self.assertAlmostEqual(hhea.caretSlopeRun / hhea.caretSlopeRise, run, delta=0.001)


class Axis(Test):
    def variable(self, *arguments, fonts=(SANS, cli.SANS_BOLD), output='x.ttf', text=TEXT):
        self.made('variable', *fonts, '--text', text, '--family', 'Neu', '-o', output, *arguments)
        return self.font(output)

    def test_weight(self):
        font = self.variable('--axis', 'wght=400..900')
        axis, names = font['fvar'].axes[0], self.names(font)
        self.assertEqual((axis.axisTag, axis.minValue, axis.defaultValue, axis.maxValue, names[axis.axisNameID]),
                         ('wght', 400, 400, 900, 'Weight'))
        places = {400: 'Regular', 500: 'Medium', 600: 'SemiBold', 700: 'Bold', 800: 'ExtraBold', 900: 'Black'}
        self.assertEqual({i.coordinates['wght']: names[i.subfamilyNameID] for i in font['fvar'].instances}, places)
        self.assertEqual({i.coordinates['wght']: names[i.postscriptNameID] for i in font['fvar'].instances},
                         {value: f'Neu-{name}' for value, name in places.items()})
        self.assertEqual([names.get(i) for i in (1, 2, 4, 6, 16, 25)], ['Neu', 'Regular', 'Neu Regular', 'Neu-Regular', None, 'Neu'])
        self.assertEqual(font['OS/2'].usWeightClass, 400)
        values = font['STAT'].table.AxisValueArray.AxisValue
        self.assertEqual([(v.Value, names[v.ValueNameID], v.Flags, v.Format) for v in values],
                         [(value, name, 2 if value == 400 else 0, 3 if value == 400 else 1) for value, name in places.items()])
        self.assertEqual(values[0].LinkedValue, 700)

    def test_instances_take_weight_and_name(self):
        font = self.variable('--axis', 'wght=400..900')
        made = instancer.instantiateVariableFont(font, {'wght': 700}, updateFontNames=True)
        names = self.names(made)
        self.assertEqual((made['OS/2'].usWeightClass, names[1], names[2], names[6]), (700, 'Neu', 'Bold', 'Neu-Bold'))

    def test_weights_of_fonts_between(self):
        font = self.variable('--axis', 'wght=250..750', fonts=(SANS, cli.SANS_BOLD, cli.SERIF))
        names = self.names(font)
        self.assertEqual([names[i.subfamilyNameID] for i in font['fvar'].instances],
                         ['Weight 250', 'Light', 'Regular', 'Medium', 'SemiBold', 'Bold', 'Weight 750'])
        self.assertEqual(names[17], 'Weight 250')
        self.assertIn('(wght = 250)', names[10])

    def test_width(self):
        font = self.variable('--axis', 'wdth=75..100')
        names = self.names(font)
        self.assertEqual([names[i.subfamilyNameID] for i in font['fvar'].instances], ['Condensed', 'SemiCondensed', 'Regular'])
        self.assertEqual(font['OS/2'].usWidthClass, 3)

    def same(self, instance, other):
        """Outlines, advances and kerning of two instances are the same."""
        for name in instance.getGlyphOrder():
            self.assertEqual(instance['glyf'][name].getCoordinates(instance['glyf'])[0],
                             other['glyf'][name].getCoordinates(other['glyf'])[0])
        self.assertEqual(instance['hmtx'].metrics, other['hmtx'].metrics)
        self.assertEqual(instance['GPOS'].compile(instance), other['GPOS'].compile(other))
        for key in ('sxHeight', 'sTypoAscender', 'yStrikeoutPosition'):
            self.assertEqual(getattr(instance['OS/2'], key), getattr(other['OS/2'], key))

    def test_downwards(self):
        """From more to less: the same fonts at the same places."""
        for more in ((), ('--avar', '20:50')):
            fonts = (cli.SANS_BOLD, SANS, cli.SERIF)
            self.variable(*more, fonts=fonts, output='up.ttf')
            font = self.variable('--axis', 'wght=900..400', *more, fonts=fonts, output='down.ttf')
            axis = font['fvar'].axes[0]
            self.assertEqual((axis.minValue, axis.defaultValue, axis.maxValue), (400, 900, 900))
            self.assertEqual(self.names(font)[17], 'Black')
            for place in (0, 10, 25, 50, 60, 75, 100):
                self.same(instancer.instantiateVariableFont(self.font('up.ttf'), {'MORF': place}),
                          instancer.instantiateVariableFont(self.font('down.ttf'), {'wght': 900 - 5 * place}))

    def test_slant(self):
        font = self.variable('--axis', 'slnt=0..-11', fonts=(SANS, OBLIQUE))
        axis, names = font['fvar'].axes[0], self.names(font)
        self.assertEqual((axis.minValue, axis.defaultValue, axis.maxValue), (-11, 0, 0))
        self.assertEqual({i.coordinates['slnt']: names[i.subfamilyNameID] for i in font['fvar'].instances},
                         {-11: 'Oblique', 0: 'Regular'})
        for angle, run in ((0, 0), (-5.5, 0.0972), (-11, 0.1944)):
            made = instancer.instantiateVariableFont(self.font(), {'slnt': angle})
            self.assertAlmostEqual(made['hhea'].caretSlopeRun / made['hhea'].caretSlopeRise, run, delta=0.001)
            self.assertEqual(made['post'].italicAngle, angle)

    def test_caret_without_a_slant_axis(self):
        self.variable(fonts=(OBLIQUE, SANS))
        for place, run in ((0, 0.1944), (50, 0.0972), (100, 0)):
            made = instancer.instantiateVariableFont(self.font(), {'MORF': place})
            self.assertAlmostEqual(made['hhea'].caretSlopeRun / made['hhea'].caretSlopeRise, run, delta=0.001)

    def test_upright_fonts_keep_their_caret(self):
        font = self.variable(fonts=(SANS, cli.SERIF))
        self.assertEqual((font['hhea'].caretSlopeRise, font['hhea'].caretSlopeRun), (1, 0))
        self.assertNotIn('hcrn', [r.ValueTag for r in font['MVAR'].table.ValueRecord])

    def test_own_axis(self):
        font = self.variable('--axis', 'MIX2=-1..1')
        names = self.names(font)
        self.assertEqual(names[font['fvar'].axes[0].axisNameID], 'MIX2')
        self.assertEqual([names[i.subfamilyNameID] for i in font['fvar'].instances],
                         ['MIX2 -1', 'MIX2 -0.5', 'MIX2 0', 'MIX2 0.5', 'MIX2 1'])

    def test_style(self):
        names = self.names(self.variable('--style', 'Bold'))
        self.assertEqual((names[1], names[2], names[6]), ('Neu', 'Bold', 'Neu-Bold'))

    def test_designspace(self):
        self.made('variable', cli.SANS_BOLD, SANS, '--text', 'A', '--axis', 'wght=700..400', '--avar', '50:25', '-o', 'x.designspace')
        document = designspaceLib.DesignSpaceDocument.fromfile(self.path('x.designspace'))
        axis = document.axes[0]
        self.assertEqual((axis.tag, axis.name, axis.minimum, axis.default, axis.maximum), ('wght', 'Weight', 400, 700, 700))
        self.assertEqual(axis.map, [(400, 400), (550, 625), (700, 700)])
        self.assertEqual([s.location['Weight'] for s in document.sources], [700, 400])
        self.assertEqual({i.styleName: i.location['Weight'] for i in document.instances},
                         {'Regular': 400, 'Medium': 550, 'SemiBold': axis.map_forward(600), 'Bold': 700})
        infos = [(self.directory / s.path / 'fontinfo.plist').read_text() for s in document.sources]
        for info, weight in zip(infos, (700, 400)):
            self.assertIn(f'<integer>{weight}</integer>', info.partition('WeightClass')[2][:40])

    def test_usage(self):
        for axis in ('wgth', 'wght=400', 'wght=400..', 'wght=..900', 'wght=400..400', 'wght=0..900', 'wght=400..1001', 'foob=0..1',
                     'WIDE=0..', 'ital=0..2', 'A=0..1', 'TOOLONG=0..1', 'wght=400...900', '1ABC=0..1', 'WIDE=0..99999', ''):
            self.refused(2, 'variable', SANS, cli.SANS_BOLD, '--axis', axis, '-o', 'x.ttf', says=['--axis'])
        self.refused(2, 'blend', SANS, cli.SANS_BOLD, '--axis', 'wght=1..2', '-o', 'x.ttf', says=['--axis'])
        self.refused(2, 'variable', SANS, cli.SANS_BOLD, '--style', 'A,B', '-o', 'x.ttf', says=['--style'])


if __name__ == '__main__':
    cli.main()
