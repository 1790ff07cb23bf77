
/* ---- the address: place, text, features and settings after its #, so that what is seen can be sent ---- */

const MIDDLE = 50; /* where a page opens whose address names no place */

/* page.html#25 is a place alone. */
function readAddress() {
  const text = location.hash.slice(1), place = parseFloat(text);
  return /^[\d.]+$/.test(text) ? new URLSearchParams({at: place}) : new URLSearchParams(text);
}

function numberOf(wishes, name, otherwise) {
  const value = parseFloat(wishes.get(name));
  return Number.isFinite(value) ? value : otherwise;
}

/* Without an entry in the browser's history for each. */
function writeAddress() {
  const wishes = new URLSearchParams({at: at('at').value, size: sizeOf(at('size').value), text: textNow()});
  if (changedFeatures().length) wishes.set('features', changedFeatures().join(','));
  if (Number(at('tracking').value)) wishes.set('tracking', at('tracking').value);
  for (const name of ['paragraph', 'vertical']) if (isPressed(at(name))) wishes.set(name, 1);
  const hash = `#${wishes}`;
  if (hash !== location.hash) history.replaceState(null, '', hash);
}

/* What an address says, shown; what it leaves out stays as it is. */
function followAddress() {
  const wishes = readAddress();
  for (const [name, toggle] of [['paragraph', toggleParagraph], ['vertical', toggleVertical]])
    if (wishes.has(name) && !isPressed(at(name)) && !at(name).hidden) toggle();
  if (wishes.has('text')) setText(wishes.get('text'));
  if (wishes.has('size')) at('size').value = wayOf(clamp(numberOf(wishes, 'size', 60), SMALLEST, LARGEST));
  if (wishes.has('tracking')) at('tracking').value = numberOf(wishes, 'tracking', 0);
  if (wishes.has('features')) setFeatures(wishes.get('features').split(','));
  showSize();
  showTracking();
  showPlace(clamp(numberOf(wishes, 'at', MIDDLE), 0, 100));
}
