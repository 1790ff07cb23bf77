
/* ---- what runs in the worker, behind the engine ---- */

/* A folder of the engine's memory, with all files below it: their names from there and their bytes. */
function filesBelow(fs, folder, inside = '') {
  return fs.readdir(folder).filter(name => name !== '.' && name !== '..').flatMap(name => {
    const path = `${folder}/${name}`;
    return fs.isDir(fs.stat(path).mode) ? filesBelow(fs, path, `${inside}${name}/`) : [{name: inside + name, bytes: fs.readFile(path)}];
  });
}

/* Both fonts lie in a folder of their own, where they have their own names; two of one name are told apart by a number. */
async function layDown(fs, fonts) {
  const names = fonts.map(font => font.name);
  if (names[0] === names[1]) names[1] = `2-${names[1]}`;
  fs.mkdir('/fonts');
  fs.mkdir('/made');
  fs.chdir('/fonts');
  for (const [index, font] of fonts.entries()) fs.writeFile(names[index], new Uint8Array(await font.arrayBuffer()));
  return names;
}

/* One task a worker: {fonts, stem, masters}. Progress goes back as {done, all}, and in the end {code, lines, files}. */
onmessage = async ({data: task}) => {
  const lines = [];
  try {
    const engine = await Engine({
      printErr: line => lines.push(line),
      progress: (done, all) => postMessage({done, all}),
    });
    const names = await layDown(engine.FS, task.fonts);
    const [call, output] = task.masters ? ['web_make_masters', `${task.stem}.designspace`] : ['web_make', task.stem];
    const code = engine.ccall(call, 'number', ['string', 'string', 'string'], [...names, `/made/${output}`]);
    const files = code === 0 ? filesBelow(engine.FS, '/made') : [];
    postMessage({code, lines, files}, files.map(file => file.bytes.buffer));
  } catch (error) {
    postMessage({code: 1, lines: [...lines, `morphotype: ${error.message}`], files: []});
  }
};
