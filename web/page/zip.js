
/* ---- a ZIP of files as they are (APPNOTE.TXT of PKWARE, 4.3 and 4.4: method 0, names in UTF-8) ---- */

const CRC_OF_BYTE = Uint32Array.from({length: 256}, (_, byte) => {
  let crc = byte;
  for (let bit = 0; bit < 8; bit++) crc = crc & 1 ? crc >>> 1 ^ 0xedb88320 : crc >>> 1;
  return crc;
});

function crcOf(bytes) {
  let crc = -1;
  for (const byte of bytes) crc = crc >>> 8 ^ CRC_OF_BYTE[(crc ^ byte) & 0xff];
  return (crc ^ -1) >>> 0;
}

/* Numbers of the given sizes, 2 or 4 bytes each, the lowest byte first. */
function record(...fields) {
  const bytes = new DataView(new ArrayBuffer(fields.reduce((sum, [size]) => sum + size, 0)));
  let at = 0;
  for (const [size, value] of fields) {
    if (size === 2) bytes.setUint16(at, value, true);
    else bytes.setUint32(at, value, true);
    at += size;
  }
  return new Uint8Array(bytes.buffer);
}

/* What a file's own head and its entry in the directory have in common. The date is the first that there is, 1 January 1980. */
const described = (name, bytes) => [
  [2, 20], [2, 0x800], [2, 0], [2, 0], [2, 0x21], [4, crcOf(bytes)], [4, bytes.length], [4, bytes.length], [2, name.length], [2, 0]];

/* files: [{name, bytes}]. */
function zip(files) {
  const parts = [], directory = [];
  let at = 0;
  for (const {name, bytes} of files) {
    const path = new TextEncoder().encode(name), about = described(path, bytes);
    const head = record([4, 0x04034b50], ...about);
    parts.push(head, path, bytes);
    directory.push(record([4, 0x02014b50], [2, 20], ...about, [2, 0], [2, 0], [2, 0], [4, 0], [4, at]), path);
    at += head.length + path.length + bytes.length;
  }
  const length = directory.reduce((sum, part) => sum + part.length, 0), count = files.length;
  const end = record([4, 0x06054b50], [2, 0], [2, 0], [2, count], [2, count], [4, length], [4, at], [2, 0]);
  return new Blob([...parts, ...directory, end], {type: 'application/zip'});
}
