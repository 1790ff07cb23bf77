
/* ---- the chosen character ---- */

function choose(cell) {
  chosen?.setAttribute('aria-selected', false);
  cell.setAttribute('aria-selected', true);
  chosen = cell;
  keepTabStop();
  showGlyph(cell.dataset.character);
}

/* On a narrow screen the sheet comes up, and must not lie on the cell. */
function openGlyph(cell) {
  at('glyph').classList.remove('closed');
  choose(cell);
  cell.scrollIntoView({block: 'nearest'});
}

function closeGlyph() {
  at('glyph').classList.add('closed');
  chosen?.focus({preventScroll: true});
}

function showGlyph(character) {
  const reasons = (flagged.get(character) ?? []).map(reason => make('li', {textContent: reason}));
  if (still.has(character)) reasons.push(make('li', {className: 'still', textContent: STILL}));
  for (const id of ['large', 'large-first', 'large-last']) at(id).textContent = shown(character);
  at('code').textContent = codeOf(character);
  at('reasons').replaceChildren(...reasons);
  for (const place of at('places').querySelectorAll('.face')) place.textContent = shown(character);
  fitGlyph();
}

/* A wide one is made smaller, with room for what it grows by on the way. */
function fitGlyph() {
  at('body').style.fontSize = '';
  const room = 0.8 * at('stage').clientWidth, width = at('body').offsetWidth;
  if (width > room) at('body').style.fontSize = `${100 * room / width}%`;
}

function makePlace(value) {
  const face = make('span', {className: 'face'}), label = make('small', {textContent: value});
  const button = make('button', {type: 'button', className: 'place', onclick: () => movePlace(value)}, face, label);
  face.setAttribute('aria-hidden', true);
  face.style.setProperty('--at', value);
  return button;
}

function fillPlaces() {
  at('places').style.setProperty('--places', places.length);
  at('places').append(...places.map(makePlace));
}
