
/* ---- names and notices ---- */

/* A name is set in the font where the font has all of it. */
const makeName = name => make('span', {className: has(name) ? 'face' : 'plain', textContent: name});

/* A letter for a font whose name cannot be set in it. */
function makeLetter() {
  const letter = ['a', '永', ...characters].find(character => characters.has(character) && !BLANK.test(character));
  const element = make('span', {className: 'face letter', textContent: letter});
  element.setAttribute('aria-hidden', true);
  return element;
}

function fillEnd(element, source, place) {
  element.append(makeName(nameOf(source)));
  if (!has(nameOf(source))) element.append(makeLetter());
  element.style.setProperty('--at', place);
}

function fillNames() {
  at('family').append(makeName(data.family));
  fillEnd(at('first'), first, 0);
  fillEnd(at('last'), last, 100);
}

/* The address of a licence: a link, where it is one of the web's. */
function makeAddress(text) {
  const url = URL.canParse(text) ? new URL(text) : null;
  if (!url || !/^https?:$/.test(url.protocol)) return text;
  return make('a', {href: url.href, rel: 'noopener noreferrer', textContent: text});
}

function makeSource(source) {
  const lines = [source.version, source.designer, source.copyright, source.trademark].filter(line => line);
  const entry = make('div', {}, make('h3', {textContent: nameOf(source)}));
  entry.append(...lines.map(line => make('p', {textContent: line})));
  if (source.license_url) entry.append(make('p', {}, makeAddress(source.license_url)));
  if (source.license) {
    const text = make('p', {textContent: source.license});
    entry.append(make('details', {}, make('summary', {textContent: 'Licence'}), text));
  }
  return entry;
}

function fillColophon() {
  const files = data.sources.map(source => source.file), end = files.pop();
  const size = `${Math.ceil(data.bytes / 1000).toLocaleString('en')} kB`;
  const lines = [
    `${data.family} was made by ${data.program} from ${files.join(', ')} and ${end}, by the method “${data.method}”.`,
    `It is one variable font, ${size} as WOFF2, with ${counted(characters.size, 'character')} and the axis MORF from 0`,
    `(${nameOf(first)}) to 100 (${nameOf(last)}).`,
  ];
  if (flagged.size) lines.push(`${counted(flagged.size, 'character')} flagged by its report: marked above.`);
  at('colophon').textContent = lines.join(' ');
}
