// The WebAssembly build computes what the native program computes, to the last bit.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { inWebAssembly, knownAnswers, natively, scenes } from './reference.mjs';

const ask = await inWebAssembly();
const cases = knownAnswers();
const evaluated = ['apply_impulse', 'block_time', 'collision_impulse', 'load', 'restitution_impulse', 'revolution_impulse', 'tether_response', 'tether_time'];

/** Doubles as integers that count them, so that differences are ulps. */
function place(hex) {
  const [, sign, lead, fraction = '', exponent] = /^(-?)0x([01])(?:\.([0-9a-f]+))?p([+-]\d+)$/.exec(hex);
  const mantissa = BigInt('0x' + lead + fraction.padEnd(13, '0'));
  const magnitude = mantissa === 0n ? 0n : ((BigInt(exponent) + 1022n) << 52n) + mantissa;
  return sign ? -magnitude : magnitude;
}
const apart = (a, b) => { const d = place(a) - place(b); return Number(d < 0n ? -d : d); };

/** The quantities of two answers that differ, in the order in which they are computed, with ulps. */
function differences(one, other) {
  const [a, b] = [one, other].map((text) => { const answer = JSON.parse(text); return [...answer.steps, ...answer.results]; });
  assert.deepEqual(a.map((q) => q.key), b.map((q) => q.key));
  return a.map((q, n) => ({ key: q.key, word: q.word !== b[n].word, ulps: Math.max(0, ...q.hex.map((x, k) => apart(x, b[n].hex[k]))) }))
    .filter((q) => q.word || q.ulps > 0);
}

// pow and tan are the only functions that IEEE 754 does not round for us: glibc's and musl's are each within an ulp of the real
// number (their manuals), so that they are at most two numbers apart. What follows from them may differ; what precedes may not.
const fromLibrary = new Set(['speed_ratio', 'needed', 'v_revolve']); // c^(θ/π); tan θ |v_ŵ|; the vector with tan θ

test('known answers in double have the same bits', () => {
  const asked = cases.filter((one) => evaluated.includes(one.op));
  assert.ok(asked.length > 7000, `${asked.length} cases`);
  const requests = asked.map((one) => ({ do: 'eval', op: one.op, scalar: 'double', in: one.in }));
  const native = natively(requests);
  const others = {};
  requests.forEach((request, n) => {
    const mine = ask(request);
    if (mine === native[n]) return;
    const found = differences(mine, native[n]);
    assert.ok(fromLibrary.has(found[0].key), `${asked[n].id}: ${JSON.stringify(found)}`);
    if (found[0].key === 'speed_ratio') assert.ok(found[0].ulps <= 2, `${asked[n].id}: ${JSON.stringify(found[0])}`);
    others[found[0].key] = (others[found[0].key] ?? 0) + 1;
  });
  const count = Object.values(others).reduce((a, b) => a + b, 0);
  console.log(`${asked.length - count} of ${asked.length} answers have the same bits; the others by the first that differs: ${JSON.stringify(others)}`);
  assert.ok(count < asked.length / 100);
});

test('certified times and orders are those of the files', () => {
  let count = 0;
  for (const one of cases.filter((c) => ['block_time', 'tether_time', 'order'].includes(c.op))) {
    const answer = JSON.parse(ask({ do: 'certified', op: one.op, in: one.in }));
    const expected = one.op === 'order' ? { order: one.order }
      : { verdict: one.verdict, t: one.t === null ? null : one.t[one.nearest === 'hi' ? 1 : 0] };
    assert.deepEqual(answer, expected, one.id);
    count++;
  }
  console.log(`${count} certified answers`);
  assert.ok(count > 5000);
});

// Intervals of the page's own (site/wasm/library/ball.cpp) have to prove what Arb's balls prove in the program. A condition number is written to three digits, from doubles
// whose roots and powers are the library's.
test('known answers with their proofs and enclosures are those of the files', () => {
  const asked = cases.filter((one) => evaluated.includes(one.op));
  let otherConditions = 0;
  for (const one of asked) {
    const { case: mine } = JSON.parse(ask({ do: 'known_answer', op: one.op, in: one.in }));
    for (const key of ['in', 'verdict', 't', 'nearest', 'proof', 'kind', 'out']) assert.deepEqual(mine[key], one[key], `${one.id}: ${key}`);
    assert.deepEqual(mine.also?.map((a) => a.out), one.also?.map((a) => a.out), one.id);
    if (JSON.stringify(mine.cond) === JSON.stringify(one.cond)) continue;
    otherConditions++;
    assert.ok(Math.abs(mine.cond / one.cond - 1) < 0.011, `${one.id}: cond ${mine.cond}, ${one.cond}`);
  }
  console.log(`${asked.length} known answers; ${otherConditions} condition numbers have another third digit`);
  assert.ok(otherConditions < asked.length / 1000);
});

for (const timing of ['stable', 'certified']) {
  test(`traces of 500 events are the native ones byte by byte, ${timing}`, () => {
    const requests = scenes().map(([, scene]) => ({ do: 'run', scene, timing, max_events: 500 }));
    const native = natively(requests);
    requests.forEach((request, n) => assert.ok(ask(request) === native[n], scenes()[n][0]));
  });
}

test('decimals are written as the native program writes them', () => {
  const numbers = [1, 0.1, 100000, 123456, 1e5, 1e22, 1e23, 5e-324, 2.2250738585072014e-308, 1.7976931348623157e308, 0.001, 1e-5, 0.00012345, 4503599627370497.5, 9007199254740993,
    1e15, 1e16, 123456789012345680000, 3e-7, 0.3, 2 / 3];
  const requests = numbers.map((x) => ({ do: 'eval', op: 'load', scalar: 'double', in: { m_A: 1, m_B: 1, v_A: [x, -x], v_B: [x, 0] } }));
  const native = natively(requests);
  requests.forEach((request, n) => assert.equal(ask(request), native[n]));
});

test('what cannot be answered is said', () => {
  for (const request of [{}, { do: 'dance' }, { do: 'eval', op: 'load', scalar: 'double', in: {} }, { do: 'eval', op: 'load', scalar: 'quad', in: { m_A: 1, m_B: 1, v_A: [1, 0], v_B: [0, 0] } },
    { do: 'run', scene: { tps: 1 } }, { do: 'scene', name: 'nowhere' }]) {
    assert.ok(JSON.parse(ask(request)).error.length > 10, JSON.stringify(request));
  }
});
