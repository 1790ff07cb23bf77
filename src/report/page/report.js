
/* ---- the report's glyphs, enlarged ---- */

function enlarge(strip) {
  at('dialog').showModal();
  showInEditor(data.glyphs[strip.dataset.glyph]);
}

/* By a click on the strip, or by its button, which keys reach. */
function makeLarge(strip) {
  const {name} = data.glyphs[strip.dataset.glyph];
  const button = make('button', {type: 'button', className: 'choice enlarge', textContent: 'Enlarge'});
  button.setAttribute('aria-label', `Enlarge ${name}, with hints by pointing`);
  strip.append(button);
  strip.addEventListener('click', () => enlarge(strip));
}

/* What is folded away would not be printed. */
addEventListener('beforeprint', () => {
  for (const details of document.querySelectorAll('details')) details.open = true;
});

at('editor').append(...makeEditor(data.names));
document.querySelectorAll('.strip').forEach(makeLarge);
