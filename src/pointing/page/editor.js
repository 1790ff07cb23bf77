
/* ---- a glyph between two fonts ----
 *
 * Both drawings side by side, in thousandths of the em, and between them what they become. Along a boundary the colours run
 * through the rainbow: what has one colour goes together. A place pointed at on each side makes a hint. */

const NEAR = 14;     /* pixels within which a node is meant */
const SAMPLES_A_SEGMENT = 12;
const TOGETHER = 4;  /* thousandths of the em within which two places go together already */
const PAD = 60;      /* around the drawing, thousandths of the em */

const editor = {glyph: null, picks: {}, hints: new Map(), files: {}};

function draw(tag, attributes, ...children) {
  const element = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.append(...children);
  return element;
}

/* ---- contours: arrays of segments, each of controls and an end, x and y in turn ---- */

const endOf = segment => segment.slice(-2);
const startOf = (contour, index) => endOf(contour.at(index - 1));
const mix = (one, other, t) => one + (other - one) * t;
const distance = (one, other) => Math.hypot(one[0] - other[0], one[1] - other[1]);

function turned([x, y], [cx, cy], degrees) {
  const angle = degrees * Math.PI / 180, cosine = Math.cos(angle), sine = Math.sin(angle);
  return [cx + cosine * (x - cx) - sine * (y - cy), cy + sine * (x - cx) + cosine * (y - cy)];
}

/* A segment with each of its places made another one. */
function mapped(segment, map) {
  const made = [];
  for (let i = 0; i < segment.length; i += 2) made.push(...map([segment[i], segment[i + 1]]));
  return made;
}

/* What moves, at T: straight from A's place to B's, by way of a displacement, and turned. */
function contoursAt(glyph, t) {
  const {degrees, a, b} = glyph.turn, middle = [mix(a[0], b[0], t), mix(a[1], b[1], t)];
  const away = 1 - Math.abs(2 * t - 1);
  const place = degrees ? point => turned(point, middle, degrees * t) : point => point;
  return glyph.moving.map(contour => contour.a.map((segment, i) => mapped(
    segment.map((value, k) => mix(value, contour.b[i][k], t) + away * contour.by[k % 2]), place)));
}

/* A font's own drawing, from its units. */
function drawingOf(side) {
  const scale = 1000 / side.units;
  return side.drawing.map(contour => contour.map(segment => segment.map(value => value * scale)));
}

const svgPlace = (x, y) => `${x.toFixed(1)} ${(-y).toFixed(1)}`;

function segmentPath(segment) {
  const places = [];
  for (let i = 0; i < segment.length; i += 2) places.push(svgPlace(segment[i], segment[i + 1]));
  return 'LQC'[places.length - 1] + places.join(' ');
}

const startPath = (contour, index) => `M${svgPlace(...startOf(contour, index))}`;
const pathOf = contours =>
  contours.map(contour => startPath(contour, 0) + contour.map(segmentPath).join('') + 'z').join('');

/* Where a segment is, u of the way along: by the construction of de Casteljau. */
function placeOn(contour, index, u) {
  const segment = contour[index];
  let places = [startOf(contour, index)];
  for (let i = 0; i < segment.length; i += 2) places.push([segment[i], segment[i + 1]]);
  while (places.length > 1)
    places = places.slice(1).map((place, i) => [mix(places[i][0], place[0], u), mix(places[i][1], place[1], u)]);
  return places[0];
}

/* The nearest place on contours: {contour, index, u, place, far}. */
function nearestOn(contours, wanted) {
  let best = {far: Infinity};
  const look = (contour, index, u) => {
    const place = placeOn(contours[contour], index, u), far = distance(place, wanted);
    if (far < best.far) best = {contour, index, u, place, far};
  };
  contours.forEach((segments, contour) => segments.forEach((_, index) => {
    for (let i = 0; i <= SAMPLES_A_SEGMENT; i++) look(contour, index, i / SAMPLES_A_SEGMENT);
  }));
  if (best.far < Infinity)
    for (let step = 0.5 / SAMPLES_A_SEGMENT; step > 1e-4; step /= 2)
      for (const u of [best.u - step, best.u + step]) look(best.contour, best.index, clamp(u, 0, 1));
  return best;
}

/* What goes with a place on one side, on the other; undefined where nothing moves. */
function counterpart(key, wanted) {
  const t = key === 'a' ? 0 : 1;
  const found = nearestOn(contoursAt(editor.glyph, t), wanted);
  if (found.far < Infinity) return placeOn(contoursAt(editor.glyph, 1 - t)[found.contour], found.index, found.u);
}

/* ---- hints ---- */

const sideOf = key => editor.glyph[key];
const hintsOf = glyph => editor.hints.get(glyph.label) ?? [];
const isPlain = name => /^[\p{L}\p{N}]$/u.test(name);
const tidy = value => String(Math.round(value * 1000) / 1000);
const written = ([x, y]) => `${tidy(x)},${tidy(y)}`;
const lineOf = hint => `${hint.kind} ${written(hint.a)} ${written(hint.b)}`;
const headOf = glyph => `glyph ${isPlain(glyph.name) ? glyph.name : glyph.label}`;

/* The file of hints: of all glyphs that have some. */
function fileOfHints() {
  const parts = data.glyphs.filter(glyph => glyph && hintsOf(glyph).length)
    .map(glyph => [headOf(glyph), ...hintsOf(glyph).map(lineOf)].join('\n'));
  return parts.length ? parts.join('\n\n') + '\n' : '';
}

/* Why a new hint would change nothing; undefined where it may. */
function idleReason(glyph, hint) {
  if (hint.idle) return 'changes nothing';
  if (hint.idle === false) return undefined;
  if (hint.kind === 'component')
    return glyph.a.components === 1 && glyph.b.components === 1 ? 'each side has one component: it changes nothing' : undefined;
  const scaled = key => hint[key].map(value => value * 1000 / glyph[key].units);
  const other = counterpart('a', scaled('a'));
  return other && distance(other, scaled('b')) < TOGETHER ? 'they go together already: it changes nothing' : undefined;
}

function say(text) {
  at('say').textContent = text;
}

function addHint() {
  const {a, b} = editor.picks, {glyph} = editor;
  const hint = {kind: at('components').checked ? 'component' : 'point', a, b};
  editor.hints.set(glyph.label, [...hintsOf(glyph), hint]);
  editor.picks = {};
  showHints();
  const reason = idleReason(glyph, hint);
  say(`${headOf(glyph)}: ${lineOf(hint)}${reason ? `: ${reason}` : ''}`);
}

function removeHint(index) {
  editor.hints.set(editor.glyph.label, hintsOf(editor.glyph).filter((_, i) => i !== index));
  showHints();
}

function makeHint(hint, index) {
  const reason = idleReason(editor.glyph, hint);
  const entry = make('li', {}, make('code', {textContent: lineOf(hint)}), ' ');
  if (reason) entry.append(make('small', {className: 'idle', textContent: reason}), ' ');
  const button = make('button', {type: 'button', className: 'choice', textContent: 'Remove', onclick: () => removeHint(index)});
  button.setAttribute('aria-label', `Remove hint ${index + 1}`);
  entry.append(button);
  return entry;
}

function showHints() {
  const text = fileOfHints();
  at('hints').replaceChildren(...hintsOf(editor.glyph).map(makeHint));
  at('lines').value = text;
  at('lines').rows = Math.max(2, text.split('\n').length);
  for (const id of ['copy', 'save']) at(id).disabled = !text;
  showMarks();
}

async function copyHints() {
  const text = at('lines').value;
  try {
    await navigator.clipboard.writeText(text);
  } catch { /* where the clipboard is not to be had by itself, the selection is */
    at('lines').select();
    document.execCommand('copy');
  }
  say('Copied.');
}

function saveHints() {
  const address = URL.createObjectURL(new Blob([at('lines').value], {type: 'text/plain'}));
  make('a', {href: address, download: 'hints.txt'}).click();
  URL.revokeObjectURL(address);
  say('Saved as hints.txt: the commands take it by --hints hints.txt.');
}

/* ---- pointing ---- */

const picture = key => at(key === 'a' ? 'side-a' : 'side-b');
const nodesOf = contours => contours.flatMap(contour => contour.map(endOf));

/* Thousandths of the em a pixel. */
const pixelOf = svg => svg.viewBox.baseVal.width / svg.getBoundingClientRect().width;

function placeOfEvent(svg, event) {
  const place = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
  return [place.x, -place.y];
}

/* The place that is meant: of a component any, else a node that is near, else the nearest on the boundary. */
function meant(key, place) {
  if (at('components').checked) return place;
  const contours = editor.drawings[key], near = NEAR * pixelOf(picture(key));
  const node = nodesOf(contours).reduce((best, each) => distance(each, place) < distance(best, place) ? each : best, [Infinity, 0]);
  return distance(node, place) <= near ? node : nearestOn(contours, place).place ?? place;
}

/* In the font's own whole units. */
const inUnits = (key, place) => place.map(value => Math.round(value * sideOf(key).units / 1000));

function pick(key, place) {
  editor.picks[key] = inUnits(key, place);
  if (editor.picks.a && editor.picks.b) addHint();
  else showMarks();
}

function hover(key, place) {
  const other = key === 'a' ? 'b' : 'a';
  editor.hover = {[key]: place, [other]: at('components').checked ? undefined : counterpart(key, place)};
  showReadout();
  showMarks();
}

function unhover() {
  editor.hover = undefined;
  showReadout();
  showMarks();
}

/* By keys: the nodes one after the other, and Enter for the one that is shown. */
function walk(key, event) {
  const nodes = nodesOf(editor.drawings[key]);
  const step = {ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1}[event.key];
  if (step === undefined && event.key !== 'Enter' && event.key !== ' ') return;
  event.preventDefault();
  if (step) editor.walked[key] = (editor.walked[key] + step + nodes.length) % nodes.length;
  const node = nodes[Math.max(editor.walked[key], 0)];
  if (!node) return;
  if (step) hover(key, node);
  else pick(key, node);
}

function showReadout() {
  for (const key of ['a', 'b']) {
    const place = editor.hover?.[key] ?? null;
    at(`read-${key}`).value = place ? inUnits(key, place).join(', ') : '';
  }
}

/* ---- pictures ---- */

function boxOf(glyph, drawings) {
  const xs = [0], ys = [0];
  for (const key of ['a', 'b']) {
    xs.push(glyph[key].advance * 1000 / glyph[key].units);
    for (const segment of drawings[key].flat())
      for (let i = 0; i < segment.length; i += 2) {
        xs.push(segment[i]);
        ys.push(segment[i + 1]);
      }
  }
  const least = list => list.reduce((a, b) => Math.min(a, b)), most = list => list.reduce((a, b) => Math.max(a, b));
  return {left: least(xs) - PAD, right: most(xs) + PAD, bottom: least(ys) - PAD, top: most(ys) + PAD};
}

function makeGrid({left, right, bottom, top}) {
  const grid = draw('g', {class: 'grid-lines'});
  const line = (x1, y1, x2, y2, name) => grid.append(draw('line', {x1, y1: -y1, x2, y2: -y2, class: name}));
  for (let x = Math.ceil(left / 100) * 100; x <= right; x += 100) line(x, bottom, x, top, x === 0 ? 'axis' : '');
  for (let y = Math.ceil(bottom / 100) * 100; y <= top; y += 100) line(left, y, right, y, y === 0 ? 'axis' : '');
  return grid;
}

/* What moves, as it stands on this side: each segment in the colour of its place along the contour. */
function makeRainbow(contours) {
  return draw('g', {class: 'rainbow'}, ...contours.flatMap(contour => contour.map((segment, i) => draw('path', {
    d: startPath(contour, i) + segmentPath(segment), stroke: `hsl(${Math.round(360 * i / contour.length)} 75% 45%)`}))));
}

function makeHandles(contour, index) {
  const segment = contour[index], start = startOf(contour, index), end = endOf(segment), parts = [];
  for (let i = 0; i < segment.length - 2; i += 2) {
    const control = [segment[i], segment[i + 1]], from = i === 0 ? [start] : [];
    if (i === segment.length - 4) from.push(end);
    for (const [x, y] of from) parts.push(draw('line', {x1: x, y1: -y, x2: control[0], y2: -control[1]}));
    parts.push(draw('circle', {cx: control[0], cy: -control[1], r: 4}));
  }
  return parts;
}

function makeNodes(contours) {
  const nodes = draw('g', {class: 'nodes'});
  for (const contour of contours) {
    contour.forEach((_, index) => nodes.append(...makeHandles(contour, index)));
    for (const [x, y] of contour.map(endOf)) nodes.append(draw('rect', {x: x - 5, y: -y - 5, width: 10, height: 10}));
  }
  return nodes;
}

function showSide(key) {
  const contours = editor.drawings[key], advance = sideOf(key).advance * 1000 / sideOf(key).units;
  const {bottom, top} = editor.box;
  picture(key).replaceChildren(
    makeGrid(editor.box),
    draw('line', {x1: advance, y1: -bottom, x2: advance, y2: -top, class: 'advance'}),
    draw('path', {d: pathOf(contours), class: 'ink'}),
    makeRainbow(contoursAt(editor.glyph, key === 'a' ? 0 : 1)),
    makeNodes(contours),
    draw('g', {class: 'marks'}));
}

function makeMark(key, place, name, text) {
  const [x, y] = place, size = pixelOf(picture(key));
  const mark = draw('g', {class: name}, draw('circle', {cx: x, cy: -y, r: 7 * size}));
  if (text) mark.append(draw('text', {x: x + 10 * size, y: -y - 6 * size, 'font-size': 14 * size}));
  if (text) mark.lastChild.textContent = text;
  return mark;
}

/* Hints with their numbers, the place picked, and the one pointed at with its counterpart. */
function showMarks() {
  for (const key of ['a', 'b']) {
    const scaled = place => place.map(value => value * 1000 / sideOf(key).units);
    const marks = hintsOf(editor.glyph).map((hint, i) => makeMark(key, scaled(hint[key]), `hint ${hint.kind}`, String(i + 1)));
    if (editor.picks[key]) marks.push(makeMark(key, scaled(editor.picks[key]), 'pick', '?'));
    if (editor.hover?.[key]) marks.push(makeMark(key, editor.hover[key], 'hover'));
    picture(key).querySelector('.marks').replaceChildren(...marks);
  }
}

function showBetween() {
  const t = Number(at('between-at').value) / 100;
  at('between-value').value = `T = ${t}`;
  at('between').replaceChildren(draw('path', {d: pathOf(contoursAt(editor.glyph, t)), class: 'ink'}));
}

/* ---- the editor as a whole ---- */

function showInEditor(glyph) {
  Object.assign(editor, {
    glyph, picks: {}, hover: undefined, walked: {a: -1, b: -1}, drawings: {a: drawingOf(glyph.a), b: drawingOf(glyph.b)}});
  if (!editor.hints.has(glyph.label)) editor.hints.set(glyph.label, glyph.hints);
  editor.box = boxOf(glyph, editor.drawings);
  const {left, right, bottom, top} = editor.box;
  for (const id of ['side-a', 'between', 'side-b']) at(id).setAttribute('viewBox', `${left} ${-top} ${right - left} ${top - bottom}`);
  at('editor-name').textContent = glyph.name === glyph.label ? glyph.name : `${glyph.name} ${glyph.label}`;
  for (const key of ['a', 'b']) showSide(key);
  showBetween();
  showReadout();
  showHints();
  say('');
}

function makeSide(key, name) {
  const svg = draw('svg', {id: `side-${key}`, class: 'side', tabindex: 0, role: 'application',
    'aria-label': `${name}: arrow keys go along its nodes, Enter points at one`});
  svg.addEventListener('pointermove', event => hover(key, meant(key, placeOfEvent(svg, event))));
  svg.addEventListener('pointerleave', unhover);
  svg.addEventListener('click', event => pick(key, meant(key, placeOfEvent(svg, event))));
  svg.addEventListener('keydown', event => walk(key, event));
  const readout = make('output', {id: `read-${key}`, className: 'readout'});
  return make('figure', {}, make('figcaption', {}, make('span', {textContent: name}), readout), svg);
}

function makeBetween() {
  const slider = make('input', {id: 'between-at', type: 'range', min: 0, max: 100, step: 1, value: 50, oninput: showBetween});
  slider.setAttribute('aria-label', 'Place between the fonts');
  const svg = draw('svg', {id: 'between', class: 'side', role: 'img', 'aria-label': 'The glyph in between'});
  return make('figure', {}, make('figcaption', {}, make('output', {id: 'between-value'})), svg, slider);
}

function makeKinds() {
  const kind = (id, text, checked) =>
    make('label', {className: 'kind'}, make('input', {type: 'radio', name: 'kind', id, checked, onchange: unhover}), ` ${text}`);
  const kinds = make('fieldset', {className: 'kinds'}, make('legend', {textContent: 'A click on each side makes a hint for'}));
  kinds.append(kind('points', 'places on the boundary', true), kind('components', 'components', false));
  return kinds;
}

/* The editor's elements, for a glyph of fonts of these names. */
function makeEditor(names) {
  const lines = make('textarea', {id: 'lines', readOnly: true, rows: 2, spellcheck: false});
  lines.setAttribute('aria-label', 'The file of hints');
  const button = (id, text, onclick) => make('button', {id, type: 'button', className: 'choice', textContent: text, onclick});
  const say = make('p', {id: 'say', className: 'note'});
  say.setAttribute('role', 'status');
  return [
    make('h2', {id: 'editor-name'}),
    make('div', {className: 'sides'}, makeSide('a', names.a), makeBetween(), makeSide('b', names.b)),
    makeKinds(), say,
    make('ol', {id: 'hints'}), lines,
    make('div', {className: 'choices'}, button('copy', 'Copy', copyHints), button('save', 'Save', saveHints)),
  ];
}
