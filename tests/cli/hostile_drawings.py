"""Drawings that no designer would send, some of each kind, the same for the same seed."""

import math
import random


def svg(content, view='0 0 100 100', head='', more=''):
    return f'{head}<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" viewBox="{view}" {more}>{content}</svg>'


def count_to(source, most):
    """Mostly few."""
    return round(most ** source.uniform(0.2, 1))


def number(source):
    return source.choice((f'{source.uniform(-20, 120):.3f}', str(source.randint(0, 100)), '-0', '1e3', '.5.5'))


def bad_number(source):
    return source.choice(('NaN', 'nan', 'inf', '-Infinity', '1e999', '-1e308', '1e-400', '99999999999999999999', '0x10', '--1', '', '1e', '٣'))


def path(source, count, numbers=number):
    return 'M0 0' + ''.join(
        letter + ' '.join(numbers(source) for _ in range(arity))
        for letter, arity in (source.choice((('L', 2), ('h', 1), ('V', 1), ('c', 6), ('S', 4), ('q', 4), ('T', 2), ('z', 0), ('m', 2)))
                              for _ in range(count))) + f'A{numbers(source)} {numbers(source)} 30 1 0 9 9z'


def filled(data, rule='nonzero'):
    return f'<path fill-rule="{rule}" d="{data}"/>'


def tangle(source):
    points = [f'{source.uniform(0, 100):.2f} {source.uniform(0, 100):.2f}' for _ in range(count_to(source, 300) + 3)]
    return svg(filled('M' + 'L'.join(points) + 'z', source.choice(('nonzero', 'evenodd'))))


def nest(source):
    count = count_to(source, 1900)
    squares = (f'M{i * 50 / count:.3f} {i * 50 / count:.3f}h{100 - i * 100 / count:.3f}v{100 - i * 100 / count:.3f}h{i * 100 / count - 100:.3f}z'
               for i in range(count))
    return svg(filled(''.join(squares), 'evenodd'))


def dots(source):
    count, side = count_to(source, 1600), source.uniform(0.01, 3)
    return svg(''.join(f'<rect x="{source.uniform(0, 99):.2f}" y="{source.uniform(0, 99):.2f}" width="{side:.2f}" height="{side:.2f}"/>'
                       for _ in range(count)))


def comb(source):
    count = count_to(source, 3500)
    return svg(filled('M0 100' + ''.join(f'L{i * 100 / count:.3f} 0L{(i + .5) * 100 / count:.3f} {source.uniform(50, 99):.1f}'
                                         for i in range(count)) + 'L100 100z'))


def coast(source):
    count = count_to(source, 6000) + 3
    return svg(filled('M' + 'L'.join(
        f'{50 + source.uniform(38, 42) * math.cos(6.2832 * i / count):.3f} {50 + source.uniform(38, 42) * math.sin(6.2832 * i / count):.3f}'
        for i in range(count)) + 'z'))


def huge(source):
    return svg(filled(path(source, 20, lambda s: s.choice((number, bad_number))(s))), view=' '.join(
        source.choice((number, bad_number))(source) for _ in range(4)))


def not_a_number(source):
    shape = source.choice(('<rect x="{}" y="{}" width="{}" height="{}" rx="{}"/>', '<circle cx="{}" cy="{}" r="{}"/>',
                           '<ellipse rx="{}" ry="{}"/>', '<polygon points="{} {} {} {} {}"/>'))
    values = [source.choice((number, bad_number))(source) for _ in range(5)]
    return svg(f'<g transform="{source.choice(("matrix", "scale", "rotate", "skewX"))}({values[0]},{values[1]})">{shape.format(*values)}</g>')


def script(source):
    return svg(source.choice(('<script>while(1);</script>', '<script xlink:href="http://example.org/x.js"/>', '')) +
               f'<rect onload="x()" onclick="y()" width="{number(source)}" height="9"/>' +
               '<foreignObject><body xmlns="http://www.w3.org/1999/xhtml"><script>1</script></body></foreignObject>')


def entities(source):
    levels = source.randint(1, 12)
    declared = '<!ENTITY a0 "ha">' + ''.join(f'<!ENTITY a{i} "{f"&a{i - 1};" * 10}">' for i in range(1, levels))
    outer = source.choice(('', '<!ENTITY x SYSTEM "file:///etc/passwd">', '<!ENTITY % p SYSTEM "http://example.org/p.dtd">%p;'))
    return svg(f'<text>&a{levels - 1};&x;</text><rect width="9" height="9"/>', head=f'<!DOCTYPE svg [{declared}{outer}]>')


def links(source):
    place = source.choice(('http://example.org/a.svg#b', 'file:///etc/passwd', '//example.org/a', 'data:image/png;base64,AAAA', 'other.svg#x'))
    return svg(f'<use xlink:href="{place}"/><image href="{place}" width="9" height="9"/><style>@import url("{place}");</style>'
               f'<rect width="9" height="9" fill="url({place})" style="filter:url({place})"/><a href="{place}"><circle r="4"/></a>',
               head=f'<?xml-stylesheet href="{place}"?><!DOCTYPE svg SYSTEM "{place}">')


def deep(source):
    levels = source.choice((50, 99, 100, 101, 5000, 60000))
    return svg('<g transform="rotate(3)">' * levels + '<rect width="9" height="9"/>' + '</g>' * source.choice((levels, levels, 0)))


def loops(source):
    count = source.randint(1, 40)
    uses = ''.join(f'<g id="a{i}">' + f'<use href="#a{(i + 1) % count if source.random() < .3 else i + 1}"/>' * source.randint(1, 8) + '</g>'
                   for i in range(count))
    return svg(f'{uses}<rect id="a{count}" width="3" height="3"/><use href="#a0"/><symbol id="s"><use href="#s"/></symbol><use href="#s"/>')


def styles(source):
    rules = ''.join(f'{source.choice((".a", "#b", "rect", "*", "a>b", "@media x{.a", ":root", ".a.b"))}'
                    f'{{fill:{source.choice(("red", "inherit", "var(--a)", "currentColor", "url(#g)", "rgb(1,2"))};--a:var(--a)}}'
                    for _ in range(source.choice((1, 5, 900, 1500))))
    return svg(f'<style>{rules}</style><g class="a" id="b" style="color:inherit;fill:currentColor;;:;a:b:c"><rect class="{"a " * 500}" width="9" height="9"/></g>')


def empty(source):
    return source.choice(('', ' ', '<', '<svg', '\ufeff', '\x00', svg(''), svg('<defs><rect width="9" height="9"/></defs>'), svg('<path d=""/>'),
                          svg('<rect width="9" height="9" fill="none"/>'), svg(filled('M5 5L5 5z')), svg(filled('M0 0L50 50L100 100z')),
                          '<svg xmlns="http://example.org/none"/>', '<html/>'))


def broken(source):
    text = bytearray(svg(filled(path(source, 10)) + '<circle r="9"/><!-- é --><![CDATA[ ]]>', head='<?xml version="1.0" encoding="UTF-8"?>').encode())
    for _ in range(source.randint(1, 12)):
        at = source.randrange(len(text))
        kind = source.random()
        if kind < .4:
            text[at] = source.randrange(256)
        elif kind < .7:
            del text[at:at + source.randint(1, 40)]
        else:
            text[at:at] = source.choice((b'\xff\xfe', b'\xc0\x80', b'\xed\xa0\x80', b']]>', b'&', b'&#0;', b'&#xD800;', b'<', b'"', b'\x00'))
    return bytes(text)


def random_path(source):
    return svg(filled(path(source, count_to(source, 400)), source.choice(('nonzero', 'evenodd'))))


KINDS = (tangle, nest, dots, comb, coast, huge, not_a_number, script, entities, links, deep, loops, styles, empty, broken, random_path)


def drawings(count, seed):
    """Bytes of so many drawings, with the names of their kinds."""
    source = random.Random(seed)
    for i in range(count):
        kind = KINDS[i % len(KINDS)]
        made = kind(source)
        yield kind.__name__, made if isinstance(made, bytes) else made.encode()
