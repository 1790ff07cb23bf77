// node validate.cjs FILE.glb …: what Khronos' validator says of each, as JSON.
const fs = require('fs');
const validator = require('gltf-validator');

async function main() {
  const reports = [];
  for (const file of process.argv.slice(2)) {
    const { issues } = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)));
    reports.push(issues);
  }
  console.log(JSON.stringify(reports));
}

main();
