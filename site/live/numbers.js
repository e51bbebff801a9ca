// Numbers as people type them and as files spell them; no arithmetic of the paper.
'use strict';

/** As pages print and people write a number: with the sign − of print, with a plus. */
tpsLive.plain = (text) => text.trim().replace(/^\u2212/, '-').replace(/([ep])\u2212/i, '$1-').replace(/^\+/, '');

/** A decimal or a hexadecimal float as the nearest double; NaN where it is neither. */
tpsLive.numberOf = function (text) {
  text = tpsLive.plain(text);
  if (text === 'inf') return Infinity;
  const hex = /^(-?)0x([0-9a-f]+)(?:\.([0-9a-f]*))?p([+-]?\d+)$/i.exec(text);
  if (!hex) return /^-?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(text) ? Number(text) : NaN;
  const [, sign, lead, fraction = '', exponent] = hex;
  const digits = parseInt(lead + fraction, 16); // exact for the 14 digits of a double
  return (sign ? -1 : 1) * digits * 2 ** (-4 * fraction.length) * 2 ** Number(exponent);
};

/** As a request has it: what is typed in hexadecimal goes as it is, decimals as the double that they are nearest to. */
tpsLive.asRequested = (text) => (/x|inf/i.test(text) ? tpsLive.plain(text) : tpsLive.numberOf(text));

/** Doubles counted, so that differences are ulps. */
tpsLive.place = function (x) {
  const view = new DataView(new ArrayBuffer(8));
  view.setFloat64(0, x);
  const bits = view.getBigInt64(0);
  return bits < 0n ? -(bits & 0x7fffffffffffffffn) : bits;
};
tpsLive.ulpsApart = (a, b) => { const d = tpsLive.place(a) - tpsLive.place(b); return d < 0n ? -d : d; };

/** Where the nearest double of a number between two others stands. @param which "lo", "hi", or "mid", the one between them. */
tpsLive.nearestPlace = ([lo, hi], which) => tpsLive.place(tpsLive.numberOf(which === 'hi' ? hi : lo)) + (which === 'mid' ? 1n : 0n);
/** "nearest", or the largest of distances that are counted in doubles. */
tpsLive.ulpsWords = function (distances) {
  const most = distances.reduce((m, d) => { const size = d < 0n ? -d : d; return size > m ? size : m; }, 0n);
  return most === 0n ? 'nearest' : `${most} ulp off`;
};

/** Nine digits for the eye. */
tpsLive.short = (decimal) => (decimal === 'inf' || decimal === '-inf' ? decimal : String(Number(Number(decimal).toPrecision(9))));

tpsLive.element = function (name, properties = {}, ...children) {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(properties)) {
    if (key in element) element[key] = value; else element.setAttribute(key, value);
  }
  element.append(...children);
  return element;
};
tpsLive.svg = function (name, attributes = {}, ...children) {
  const element = document.createElementNS('http://www.w3.org/2000/svg', name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  element.append(...children);
  return element;
};
