
/* ---- the fonts ---- */

const ids = ['first', 'second'];
const fonts = [null, null];

function take(index, file) {
  fonts[index] = file;
  at(`${ids[index]}-name`).textContent = file ? file.name : 'None yet';
  at('make').disabled = !(fonts[0] && fonts[1]);
}

function choose(index) {
  const [file] = at(ids[index]).files;
  if (file) take(index, file);
}

/* Two at once are both; one is the first that is missing, or else the second. */
function drop(event) {
  event.preventDefault();
  document.body.classList.remove('dragged');
  const files = [...event.dataTransfer.files];
  if (files.length > 1) ids.forEach((_, index) => take(index, files[index]));
  else if (files.length === 1) take(fonts[0] ? 1 : 0, files[0]);
}

function takeDemo() {
  data.demo.forEach(({name, base64}, index) => {
    const bytes = Uint8Array.from(atob(base64), character => character.charCodeAt(0));
    take(index, new File([bytes], name));
  });
  makeFont();
}

/* ---- the work ---- */

let worker = null, made = [];

/* What the policy wants of an address that a script is read from; a browser without it takes any. */
const scripts = self.trustedTypes?.createPolicy('engine', {createScriptURL: address => address});

function startWorker() {
  const address = URL.createObjectURL(new Blob([at('engine').textContent], {type: 'text/javascript'}));
  const started = new Worker(scripts ? scripts.createScriptURL(address) : address);
  URL.revokeObjectURL(address);
  return started;
}

function showBusy(busy) {
  at('work').hidden = !busy;
  at('bar').value = 0;
  at('make').disabled = busy || !(fonts[0] && fonts[1]);
  for (const id of ['demo', 'designspace', ...ids]) at(id).disabled = busy;
}

function endWork() {
  worker?.terminate();
  worker = null;
  showBusy(false);
}

const plain = line => line.replace(/^morphotype: /, '');

/* Where it comes to nothing the last line says why; the others are to be known. */
function showLines(lines, failed) {
  at('problem').textContent = failed ? plain(lines.at(-1) ?? 'the engine has stopped') : '';
  const notes = failed ? lines.slice(0, -1) : lines;
  at('lines').replaceChildren(...notes.map(line => make('li', {textContent: plain(line)})));
  at('notes').hidden = notes.length === 0;
}

/* Has a worker do a task; `whenDone` gets the files. */
function work(task, words, whenDone) {
  endWork();
  showBusy(true);
  showLines([], false);
  at('status').textContent = words;
  worker = startWorker();
  worker.onerror = event => answer({code: 1, lines: [event.message || 'the engine has stopped'], files: []});
  worker.onmessage = event => answer(event.data);
  function answer({done, all, code, lines, files}) {
    if (all) {
      at('bar').value = 100 * done / all;
      return;
    }
    endWork();
    at('status').textContent = '';
    showLines(lines, code !== 0);
    if (code === 0) whenDone(files);
  }
  worker.postMessage(task);
}

function cancel() {
  endWork();
  at('status').textContent = 'Cancelled.';
  at('make').focus();
}

/* ---- what is made ---- */

const TYPES = {ttf: 'font/ttf', woff2: 'font/woff2', html: 'text/html'};
const stemOf = file => file.name.replace(/\.[^.]*$/, '').replace(/[^\p{L}\p{N}]+/gu, '') || 'Font';
const blobOf = type => new Blob([made.find(file => file.name.endsWith(`.${type}`)).bytes], {type: TYPES[type]});

function save(blob, name) {
  const address = URL.createObjectURL(blob);
  make('a', {href: address, download: name}).click();
  setTimeout(() => URL.revokeObjectURL(address), 60000);
  at('status').textContent = `Saved as ${name}.`;
}

function show(task, files, seconds) {
  made = files;
  if (at('specimen').src) URL.revokeObjectURL(at('specimen').src);
  at('specimen').src = URL.createObjectURL(blobOf('html'));
  at('result').hidden = false;
  at('status').textContent = `Made in ${seconds.toFixed(1)} seconds.`;
  at('result-heading').focus();
  for (const type of Object.keys(TYPES)) at(type).onclick = () => save(blobOf(type), `${task.stem}.${type}`);
  at('designspace').onclick = () => work({...task, masters: true}, 'Making the masters …', files =>
    save(zip(files), `${task.stem}.zip`));
}

function makeFont() {
  const task = {fonts: [...fonts], stem: fonts.map(stemOf).join('-')}, start = performance.now();
  at('result').hidden = true;
  work(task, 'Making the font …', files => show(task, files, (performance.now() - start) / 1000));
}

/* ---- the beginning ---- */

ids.forEach((id, index) => at(id).addEventListener('change', () => choose(index)));
at('fonts').addEventListener('submit', event => {
  event.preventDefault();
  makeFont();
});
at('demo').addEventListener('click', takeDemo);
at('cancel').addEventListener('click', cancel);
addEventListener('dragover', event => {
  event.preventDefault();
  document.body.classList.add('dragged');
});
addEventListener('dragleave', event => {
  if (!event.relatedTarget) document.body.classList.remove('dragged');
});
addEventListener('drop', drop);
