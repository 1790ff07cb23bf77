
/* ---- the beginning ---- */

function listen() {
  const heard = [
    ['at', 'input', () => movePlace(at('at').value)], ['at', 'keydown', moveByKey], ['play', 'click', togglePlay],
    ['text', 'input', showText], ['size', 'input', showSize], ['tracking', 'input', showTracking],
    ['vertical', 'click', toggleVertical], ['paragraph', 'click', toggleParagraph], ['ends', 'click', toggleEnds],
    ['css', 'click', copyCss], ['woff2', 'click', saveFont],
    ['show-features', 'click', showFeatures], ['grid', 'keydown', moveInGrid], ['close', 'click', closeGlyph],
  ];
  for (const [id, event, listener] of heard) at(id).addEventListener(event, listener);
  for (const [id, event] of [['text', 'input'], ['size', 'change'], ['tracking', 'change'], ['vertical', 'click'], ['paragraph', 'click']])
    at(id).addEventListener(event, writeAddress);
  addEventListener('hashchange', () => {
    stop();
    followAddress();
  });
  addEventListener('beforeprint', showForPrint);
  at('grid').addEventListener('click', event => {
    const cell = event.target.closest('.cell');
    if (cell) openGlyph(cell);
  });
}

function fillText() {
  const samples = findSamples();
  makeEditable();
  fillFeatures();
  fillSamples(samples);
  fillWaterfall();
  at('vertical').hidden = !isForColumns([...characters].join(''));
  at('size').value = wayOf(clamp(innerWidth / 12, 40, 104));
  showSize();
  setText(firstText(samples));
}

function fillCharacters() {
  fillLegend();
  fillPlaces();
  fillGrid();
  if (cells.length) choose(cells.find(cell => cell.classList.contains('flagged')) ?? cells[0]);
}

async function loadFont() {
  const face = new FontFace('Specimen', `url(${at('font').textContent})`);
  document.fonts.add(await face.load());
  fitGlyph();
  for (const control of [at('at'), at('play')]) control.disabled = false;
}

try {
  fillNames();
  fillTicks();
  fillText();
  fillCharacters();
  at('sources').append(...data.sources.map(makeSource));
  fillColophon();
  listen();
  followAddress();
  for (const id of ['family', 'text', 'waterfall', 'glyph']) follow(at(id));
  await loadFont();
} catch (error) {
  at('problem').textContent = `The specimen cannot be shown: ${error.message}`;
  at('problem').hidden = false;
}
