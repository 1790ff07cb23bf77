
/* ---- the grid ----
 *
 * A list of options with one tab stop. Its cells stand in blocks of whole rows, whose height is known before they are
 * laid out, so that a browser need not look at those out of sight. */

const ROWS = 4;    /* in a block */
let sections = []; /* one for each script: {element, cells} */
let cells = [];    /* those that are shown, in their order */
let columns = 0;
let chosen = null; /* a cell */

/* A mark stands on a dotted circle, where the font has one. */
function shown(character) {
  if (!/\p{M}/u.test(character)) return character;
  return (characters.has('\u25cc') ? '\u25cc' : '\u00a0') + character;
}

function makeCell(character) {
  const cell = make('div', {className: 'cell face', textContent: shown(character), title: codeOf(character)});
  if (BLANK.test(character)) {
    cell.className = 'cell blank';
    cell.textContent = codeOf(character).slice(2);
  }
  mark(cell, character);
  cell.tabIndex = -1;
  cell.setAttribute('role', 'option');
  cell.setAttribute('aria-selected', false);
  cell.dataset.character = character;
  return cell;
}

function mark(cell, character) {
  if (flagged.has(character)) {
    cell.classList.add('flagged');
    cell.title += `: ${flagged.get(character).join('; ')}`;
  } else if (still.has(character)) {
    cell.classList.add('kept');
    cell.title += `: ${STILL}`;
  }
}

/* Scripts in the font's order; after them digits, signs and punctuation, which no script has for itself. */
function listGroups() {
  const isShared = group => group.script === 'Zyyy' || group.script === 'Zinh';
  const shared = data.groups.filter(isShared).flatMap(group => [...group.characters]);
  const isDigit = character => /\p{N}/u.test(character);
  return [
    ...data.groups.filter(group => !isShared(group)).map(group => [nameOfScript(group.script), [...group.characters]]),
    ['Figures', shared.filter(isDigit)],
    ['Punctuation and signs', shared.filter(character => !isDigit(character))],
  ].filter(([, list]) => list.length);
}

function makeSection([name, list]) {
  const heading = make('h3', {className: 'script', textContent: name});
  const element = make('div', {}, heading);
  heading.setAttribute('aria-hidden', true);
  element.setAttribute('role', 'group');
  element.setAttribute('aria-label', name);
  return {element, cells: list.map(makeCell)};
}

function fillGrid() {
  sections = listGroups().map(makeSection);
  at('grid').append(...sections.map(section => section.element));
  new ResizeObserver(arrange).observe(at('grid'));
  arrange();
}

/* Puts the cells into blocks for the grid's width. */
function arrange() {
  const style = getComputedStyle(root);
  const size = parseFloat(style.getPropertyValue('--cell')) * parseFloat(style.fontSize); /* --cell is in rem */
  const count = Math.max(1, Math.floor(at('grid').clientWidth / size));
  if (count === columns) return;
  columns = count;
  root.style.setProperty('--columns', columns);
  fillBlocks(size);
}

function makeBlock(size, list) {
  const block = make('div', {className: 'rows'}, ...list);
  block.setAttribute('role', 'presentation');
  block.style.containIntrinsicHeight = `${Math.ceil(list.length / columns) * size}px`;
  follow(block);
  return block;
}

function fillBlocks(size) {
  const onlyFlagged = at('only')?.checked, room = columns * ROWS;
  at('grid').querySelectorAll('.rows').forEach(forget);
  cells = [];
  for (const section of sections) {
    const kept = section.cells.filter(cell => !onlyFlagged || cell.classList.contains('flagged')), blocks = [];
    for (let i = 0; i < kept.length; i += room) blocks.push(makeBlock(size, kept.slice(i, i + room)));
    section.element.hidden = kept.length === 0;
    section.element.replaceChildren(section.element.firstChild, ...blocks);
    cells.push(...kept);
  }
  keepTabStop();
}

function rearrange() {
  columns = 0;
  arrange();
}

function keepTabStop() {
  const stop = cells.includes(chosen) ? chosen : cells[0];
  for (const cell of at('grid').querySelectorAll('[tabindex="0"]')) cell.tabIndex = -1;
  if (stop) stop.tabIndex = 0;
}

/* The cell that a key leads to from another one; undefined where it leads nowhere. */
function cellByKey(key, from) {
  const page = columns * ROWS;
  const steps = {ArrowLeft: -1, ArrowRight: 1, ArrowUp: -columns, ArrowDown: columns, PageUp: -page, PageDown: page};
  if (key in steps) return cells[clamp(cells.indexOf(from) + steps[key], 0, cells.length - 1)];
  if (key === 'Home') return cells[0];
  if (key === 'End') return cells.at(-1);
  if (key === 'Enter' || key === ' ') return from;
  return cells.find(cell => cell.dataset.character === key);
}

function moveInGrid(event) {
  const from = event.target.closest('.cell');
  if (!from || event.ctrlKey || event.metaKey || event.altKey) return;
  if (event.key === 'Escape') closeGlyph();
  const to = cellByKey(event.key, from);
  if (!to) return;
  event.preventDefault();
  openGlyph(to);
  to.focus();
}

function fillLegend() {
  const dot = className => make('span', {className});
  at('count').textContent = characters.size.toLocaleString('en');
  if (flagged.size) {
    const box = make('input', {type: 'checkbox', id: 'only', onchange: rearrange});
    const text = make('span', {}, dot('dot'), `Only what needs a look: ${flagged.size}`);
    at('legend').append(make('label', {className: 'legend'}, box, text));
  }
  if (still.size) {
    const text = make('span', {}, dot('dot still'), `${ONLY_IN}: ${still.size}`);
    at('legend').append(make('span', {className: 'legend'}, text));
  }
}
