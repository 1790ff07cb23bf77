// node union.mjs < MESHES: the union of closed meshes by Manifold. MESHES is JSON, a list of solids, each a list of
// {"points": [x, y, z, x, …], "triangles": [a, b, c, a, …]}. Prints for each solid its volume, the genus and the volume of each of its parts.
import fs from 'node:fs';
import createModule from 'manifold-3d';

const wasm = await createModule();
wasm.setup(); // makes the classes
const { Manifold, Mesh } = wasm;

function manifoldOf({ points, triangles }) {
  return new Manifold(new Mesh({
    numProp: 3,
    vertProperties: new Float32Array(points),
    triVerts: new Uint32Array(triangles),
  }));
}

const solids = JSON.parse(fs.readFileSync(0, 'utf8'));
console.log(JSON.stringify(solids.map((meshes) => {
  const union = Manifold.union(meshes.map(manifoldOf));
  const parts = union.decompose().map((part) => ({ genus: part.genus(), volume: part.volume() }));
  return { volume: union.volume(), parts };
})));
