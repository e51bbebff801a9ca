// What stands in the page: the description as JSON, the numbers as columns of one block of bytes.
'use strict';
var TPS = {};

/** The bytes of a base64 text. */
TPS.bytesOf = function (text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const raw = atob(text);
  const bytes = new Uint8Array(raw.length);
  for (let n = 0; n < raw.length; n++) bytes[n] = raw.charCodeAt(n);
  return bytes;
};

/** @returns {{what: Object, columns: Object<string, TypedArray>}} what verify/view/columns.cpp has written. */
TPS.read = function () {
  const what = JSON.parse(document.getElementById('what').textContent);
  const element = document.getElementById('numbers');
  const bytes = TPS.bytesOf(element.textContent);
  element.remove(); // of a long trace it is the larger part of the page
  const types = { f64: Float64Array, i32: Int32Array, u8: Uint8Array };
  const columns = {};
  for (const [name, place] of Object.entries(what.columns)) {
    const Type = types[place.type];
    columns[name] = place.length ? new Type(bytes.buffer, bytes.byteOffset + place.from, place.length) : new Type(0);
  }
  return { what, columns };
};

/** Bits of the column "event_flags": a tether was formed, or broken. */
TPS.formed = 2;
TPS.broken = 4;

/** A double as a hexadecimal float, exactly, as traces spell it. */
TPS.hex = function (x) {
  if (x === 0) return Object.is(x, -0) ? '-0x0p+0' : '0x0p+0';
  if (!isFinite(x)) return x > 0 ? 'inf' : '-inf';
  const view = new DataView(new ArrayBuffer(8));
  view.setFloat64(0, x);
  const high = view.getUint32(0);
  const biased = (high >>> 20) & 0x7ff;
  const fraction = ((high & 0xfffff).toString(16).padStart(5, '0') +
                    view.getUint32(4).toString(16).padStart(8, '0')).replace(/0+$/, '');
  const exponent = biased === 0 ? -1022 : biased - 1023;
  return `${x < 0 ? '-' : ''}0x${biased === 0 ? 0 : 1}${fraction ? '.' + fraction : ''}p${exponent < 0 ? '' : '+'}${exponent}`;
};

/** A number short enough for a list. */
TPS.short = (x) => String(Number(x.toPrecision(6)));

/** Colours of kinds of events, after Okabe and Ito; what is rare shares the last. */
TPS.kindColour = (kind) => ({ rebound: '#0072b2', retract: '#009e73', revolve: '#e69f00', break: '#d55e00',
  restitute: '#cc79a7', wall: '#56b4e9' })[kind] || '#8c8c8c';
