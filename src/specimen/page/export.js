
/* ---- what goes on elsewhere: the font as a file, and the style as CSS ---- */

const fileName = () => data.family.replace(/[^\p{L}\p{N}]+/gu, '') || 'Font';

async function saveFont() {
  const packed = Uint8Array.from(atob(at('font').textContent.split(',')[1]), character => character.charCodeAt(0));
  const address = URL.createObjectURL(new Blob([packed], {type: 'font/woff2'}));
  make('a', {href: address, download: `${fileName()}.woff2`}).click();
  URL.revokeObjectURL(address);
  sayExported(`Saved as ${fileName()}.woff2.`);
}

/* A text in quotes, as CSS escapes it. */
const quoted = text => `"${text.replace(/["\\\n]/g, character => `\\${character.codePointAt(0).toString(16)} `)}"`;

function cssNow() {
  const family = quoted(data.family), tracking = Number(at('tracking').value), features = featureSettings();
  const rules = [`font-family: ${family};`, `font-variation-settings: "MORF" ${at('at').value};`];
  if (changedFeatures().length) rules.push(`font-feature-settings: ${features};`);
  if (tracking) rules.push(`letter-spacing: ${tracking / 1000}em;`);
  return `@font-face {\n  font-family: ${family};\n  src: url(${quoted(`${fileName()}.woff2`)}) format("woff2");\n}\n` +
    `.between {\n${rules.map(rule => `  ${rule}\n`).join('')}}\n`;
}

async function copyCss() {
  const css = cssNow();
  try {
    await navigator.clipboard.writeText(css);
    sayExported('The CSS is copied.');
  } catch { /* where the clipboard is not to be had, it can be read */
    at('css-text').textContent = css;
    at('css-text').hidden = false;
    sayExported('');
  }
}

function sayExported(text) {
  at('exported').textContent = text;
}

/* Both ends, in outline, over the large character. */
function toggleEnds() {
  const shown = at('stage').classList.toggle('ends');
  at('ends').setAttribute('aria-pressed', shown);
}
