
/* ---- the text ---- */

const SAMPLES = {
  Latn: ['The fonts between two fonts', 'between two fonts'],
  Grek: ['Ξεσκεπάζω την ψυχοφθόρα βδελυγμία', 'ξεσκεπαζω την ψυχοφθορα'],
  Cyrl: ['Съешь же ещё этих мягких французских булок'],
  Hira: ['いろはにほへと ちりぬるを'],
  Kana: ['イロハニホヘト チリヌルヲ'],
  Hang: ['다람쥐 헌 쳇바퀴에 타고파'],
  Hebr: ['דג סקרן שט בים מאוכזב'],
  Arab: ['نص حكيم له سر قاطع'],
  Armn: ['Կրնամ ապակի ուտել'],
  Geor: ['მინას ვჭამ და არა მტკივა'],
  Deva: ['मैं काँच खा सकता हूँ'],
  Thai: ['เป็นมนุษย์สุดประเสริฐ'],
};
/* Characters that need no neighbours: of these, as many as the font has. */
const HAN = '永和九年歲岁在癸丑暮春之初天地玄黃黄宇宙洪荒日月盈昃辰宿列張张形國国一二三';

/* For each script that the font has a sample of, the largest first: its name and the sample. */
function findSamples() {
  const size = script => data.groups.find(group => group.script === script)?.characters.length ?? 0;
  const han = [...HAN].filter(character => characters.has(character)).slice(0, 12).join('');
  return Object.entries({...SAMPLES, Hani: [han]})
    .map(([script, texts]) => [nameOfScript(script), texts.find(has), size(script)])
    .filter(([, text]) => text)
    .sort((one, other) => other[2] - one[2]);
}

/* The text of the command line, else a sample, else the first characters that can be seen. */
function firstText(samples) {
  if (data.text) return data.text;
  if (samples.length) return samples[0][1];
  return [...characters].filter(character => !BLANK.test(character)).slice(0, 24).join('');
}

const textNow = () => at('text').innerText.replace(/\n$/, '');

function showText() {
  const text = textNow(), line = text.split('\n').find(part => part.trim()) ?? '';
  const missing = [...new Set(text)].filter(character => /\S/.test(character) && !characters.has(character));
  if (!text) at('text').replaceChildren();
  for (const span of at('waterfall').querySelectorAll('span')) span.textContent = line;
  at('missing').textContent = missing.length ? `Not in the font: ${missing.slice(0, 12).join(' ')}` : '';
  if (missing.length > 12) at('missing').append(' …');
}

function setText(text) {
  at('text').textContent = text;
  showText();
}

function fillSamples(samples) {
  if (samples.length < 2) return;
  at('samples').append(...samples.map(([name, text]) =>
    make('button', {type: 'button', className: 'choice', textContent: name, onclick: () => {
      setText(text);
      writeAddress();
    }})));
}

/* Browsers that know no plain text to edit take any, which comes out as plain text. */
function makeEditable() {
  if (at('text').contentEditable !== 'plaintext-only') at('text').contentEditable = 'true';
}

function toggleVertical() {
  const vertical = at('text').classList.toggle('upright');
  at('vertical').setAttribute('aria-pressed', vertical);
}

/* Set as a paragraph is: small, in a measure, with room between the lines; the text is repeated until it is one. */
const PARAGRAPH_SIZE = 18, PARAGRAPH_LENGTH = 480; /* pixels, characters */

let beforeParagraph; /* text and size, and the paragraph made of the text */

function beginParagraph(text) {
  const times = text && text.length < PARAGRAPH_LENGTH ? Math.ceil(PARAGRAPH_LENGTH / text.length) : 1;
  beforeParagraph = {text, size: at('size').value, made: Array(times).fill(text).join(' ')};
  at('size').value = wayOf(PARAGRAPH_SIZE);
  setText(beforeParagraph.made);
}

/* What was typed since then stays. */
function endParagraph() {
  at('size').value = beforeParagraph.size;
  if (textNow() === beforeParagraph.made) setText(beforeParagraph.text);
}

function toggleParagraph() {
  const paragraph = at('text').classList.toggle('paragraph');
  at('paragraph').setAttribute('aria-pressed', paragraph);
  if (paragraph) beginParagraph(textNow().trim());
  else endParagraph();
  showSize();
}

/* Scripts that are set in columns too. */
const isForColumns = text => /[\p{Script=Han}\p{Script=Hiragana}\p{Script=Katakana}\p{Script=Hangul}]/u.test(text);

/* ---- its size: the slider's way is even in the logarithm ---- */

const SMALLEST = 12, LARGEST = 400; /* pixels */
const sizeOf = way => Math.round(SMALLEST * (LARGEST / SMALLEST) ** (way / 100));
const wayOf = size => 100 * Math.log(size / SMALLEST) / Math.log(LARGEST / SMALLEST);

function showSize() {
  const size = sizeOf(at('size').value);
  at('text').style.fontSize = `${size}px`;
  at('pixels').value = `${size} px`;
  at('size').setAttribute('aria-valuetext', `${size} pixels`);
}

/* Between letters, thousandths of the em. */
function showTracking() {
  const tracking = Number(at('tracking').value);
  at('text').style.letterSpacing = tracking ? `${tracking / 1000}em` : '';
  at('tracked').value = tracking > 0 ? `+${tracking}` : String(tracking).replace('-', '−');
}

/* ---- all sizes ---- */

const WATERFALL = [12, 14, 16, 18, 21, 24, 30, 36, 48, 60, 72, 96];

function fillWaterfall() {
  for (const size of WATERFALL) {
    const span = make('span', {className: 'face'}), line = make('div', {className: 'line'}, span);
    line.dataset.size = size;
    span.style.fontSize = `${size}px`;
    at('waterfall').append(line);
  }
  const range = `${WATERFALL[0]} to ${WATERFALL.at(-1)}`;
  at('waterfall').setAttribute('aria-label', `The text’s first line at sizes from ${range} pixels`);
}

/* ---- features ---- */

const FEATURES = {
  kern: 'Kerning', liga: 'Ligatures', calt: 'Contextual alternates', dlig: 'Discretionary ligatures',
  hlig: 'Historical ligatures', smcp: 'Small capitals', c2sc: 'Capitals to small capitals',
  case: 'Case-sensitive forms', onum: 'Old-style figures', lnum: 'Lining figures', tnum: 'Tabular figures',
  pnum: 'Proportional figures', frac: 'Fractions', zero: 'Slashed zero', ordn: 'Ordinals', sups: 'Superscript',
  subs: 'Subscript', sinf: 'Inferiors', salt: 'Alternates', swsh: 'Swashes', titl: 'Titling',
  hist: 'Historical forms', fwid: 'Full widths', hwid: 'Half widths', pwid: 'Proportional widths',
  palt: 'Proportional alternates', trad: 'Traditional forms', smpl: 'Simplified forms', ruby: 'Ruby',
  hkna: 'Horizontal kana',
};
const ON_BY_THEMSELVES = ['kern', 'liga', 'calt'];

/* Of those that a person may choose; of others nothing. */
function featureName(tag) {
  const numbered = /^(ss|cv)(\d\d)$/.exec(tag);
  if (numbered) return `${numbered[1] === 'ss' ? 'Set' : 'Variant'} ${Number(numbered[2])}`;
  return FEATURES[tag];
}

const isPressed = button => button.getAttribute('aria-pressed') === 'true';

const featureButtons = () => [...at('features').children];

/* As CSS has them: "liga" 0, "smcp" 1. */
const featureSettings = () => featureButtons().map(button => `"${button.dataset.tag}" ${isPressed(button) ? 1 : 0}`).join(', ');

function toggleFeature(event) {
  event.currentTarget.setAttribute('aria-pressed', !isPressed(event.currentTarget));
  root.style.setProperty('--features', featureSettings());
  writeAddress();
}

/* Those that are not as they are by themselves: smcp, -liga. */
const changedFeatures = () => featureButtons().filter(button => isPressed(button) !== ON_BY_THEMSELVES.includes(button.dataset.tag))
  .map(button => (isPressed(button) ? '' : '-') + button.dataset.tag);

function setFeatures(changed) {
  for (const button of featureButtons()) {
    const {tag} = button.dataset;
    button.setAttribute('aria-pressed', changed.includes(tag) || ON_BY_THEMSELVES.includes(tag) && !changed.includes(`-${tag}`));
  }
  root.style.setProperty('--features', featureSettings());
}

function makeFeature(tag) {
  const name = featureName(tag);
  const button = make('button', {type: 'button', className: 'choice', textContent: name, title: tag});
  button.dataset.tag = tag;
  button.setAttribute('aria-pressed', ON_BY_THEMSELVES.includes(tag));
  button.addEventListener('click', toggleFeature);
  return button;
}

function fillFeatures() {
  const known = data.features.filter(featureName);
  at('show-features').hidden = known.length === 0;
  at('features').append(...known.map(makeFeature));
}

function showFeatures() {
  at('features').hidden = !at('features').hidden;
  at('show-features').setAttribute('aria-expanded', !at('features').hidden);
}
