// Pictures of the whole run for a film, as PNG files in one tar archive (POSIX ustar), which any system unpacks.
'use strict';

/** The header of a file in an archive: 512 bytes, numbers in octal. */
TPS.tarHeader = function (name, size) {
  const header = new Uint8Array(512);
  const put = (text, at) => header.set(new TextEncoder().encode(text), at);
  const octal = (x, digits) => x.toString(8).padStart(digits, '0');
  put(name, 0);
  put(octal(0o644, 7), 100);
  put(octal(0, 7), 108);
  put(octal(0, 7), 116);
  put(octal(size, 11), 124);
  put(octal(0, 11), 136);
  put('        ', 148);
  put('0', 156);
  put('ustar\u000000', 257);
  put(octal(header.reduce((a, b) => a + b, 0), 6) + '\u0000 ', 148);
  return header;
};

/** @param {[string, Uint8Array][]} files @returns {Blob} */
TPS.tar = function (files) {
  const parts = [];
  for (const [name, bytes] of files) {
    parts.push(TPS.tarHeader(name, bytes.length), bytes, new Uint8Array((512 - bytes.length % 512) % 512));
  }
  parts.push(new Uint8Array(1024));
  return new Blob(parts, { type: 'application/x-tar' });
};

TPS.saveAs = function (blob, name) {
  const link = document.createElement('a');
  link.download = name;
  link.href = URL.createObjectURL(blob);
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60000);
};

/** `count` pictures at equal distances on the axis. `showAt(u)` draws a place; `say(text)` tells how far it is. */
TPS.film = async function (picture, axis, count, showAt, say) {
  const canvas = picture.renderer.domElement;
  const files = [];
  for (let k = 0; k < count; k++) {
    showAt(axis.length * (count > 1 ? k / (count - 1) : 0));
    const blob = await new Promise((resolve) => canvas.toBlob(resolve, 'image/png'));
    files.push([`frame-${String(k).padStart(5, '0')}.png`, new Uint8Array(await blob.arrayBuffer())]);
    say(`${k + 1} of ${count} frames`);
  }
  TPS.saveAs(TPS.tar(files), 'frames.tar');
  say(`${count} frames saved`);
};
