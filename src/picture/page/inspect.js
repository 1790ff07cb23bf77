
/* ---- the glyphs of an inspection ---- */

function choose(index) {
  [...at('glyphs').children].forEach((button, i) => button.setAttribute('aria-pressed', i === index));
  showInEditor(data.glyphs[index]);
}

/* page.html#2 begins with the third glyph. */
const indexOfAddress = () => clamp(parseInt(location.hash.slice(1), 10) || 0, 0, data.glyphs.length - 1);

function fillGlyphs() {
  at('glyphs').hidden = data.glyphs.length < 2;
  at('glyphs').append(...data.glyphs.map((glyph, index) => make('button', {
    type: 'button', className: 'choice', textContent: glyph.name, title: glyph.label, onclick: () => choose(index)})));
}

at('editor').append(...makeEditor(data.names));
fillGlyphs();
for (const glyph of data.glyphs) editor.hints.set(glyph.label, glyph.hints);
choose(indexOfAddress());
