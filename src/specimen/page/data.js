const counted = (count, word) => `${count.toLocaleString('en')} ${word}${count === 1 ? '' : 's'}`;

/* ---- characters ---- */

const characters = new Set(data.groups.flatMap(group => [...group.characters]));
const has = text => [...text].every(character => characters.has(character));
const codeOf = character => `U+${character.codePointAt(0).toString(16).toUpperCase().padStart(4, '0')}`;
const scriptNames = new Intl.DisplayNames(['en'], {type: 'script'});
const nameOfScript = script => script === 'Zzzz' ? 'Others' : scriptNames.of(script);

/* Spaces, controls of the text and the like, and what Unicode has no character for. */
const BLANK = /[\p{Z}\p{Cc}\p{Cf}\p{Cn}\u034f\u115f\u1160\u3164\uffa0\ufe00-\ufe0f]/u;

/* ---- the fonts ---- */

const nameOf = source => `${source.family} ${source.style}`;
const first = data.sources[0], last = data.sources.at(-1);

/* Places on the axis to stop at: the fonts' own where there are a few between the ends, otherwise quarters. */
const stops = data.sources.map((source, index) => Math.round(1000 * index / (data.sources.length - 1)) / 10);
const places = stops.length > 2 && stops.length < 8 ? stops : [0, 25, 50, 75, 100];

/* What is to be said of a character: what the reports flag, between which fonts where there are more than two. */
function reasonOf({step, reason}) {
  if (data.sources.length === 2) return reason;
  return `${nameOf(data.sources[step])} to ${nameOf(data.sources[step + 1])}: ${reason}`;
}

const flagged = new Map(data.flagged.map(glyph => [glyph.character, glyph.reasons.map(reasonOf)]));
const still = new Set(data.still);
const ONLY_IN = data.sources.length === 2 ? `only in ${nameOf(first)}` : 'not in all fonts';
const STILL = `${ONLY_IN}; it stays as it is`;
