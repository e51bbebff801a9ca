// Eqs. (2), (3), (4), (6), (7) over a pipe: tps conform -- node adapter.js
"use strict";

/** Numbers come as hexadecimal floats in strings: sign, 0x1.digits, p exponent; "inf" among them. */
function number(x) {
  if (typeof x === "number") return x;
  if (x === "inf") return Infinity;
  const [, sign, whole, digits = "", power] = /^(-?)0x([01])(?:\.([0-9a-f]*))?p([+-]?\d+)$/.exec(x);
  const significand = parseInt(whole + digits.padEnd(13, "0"), 16); // 53 bits: exact
  const exponent = Number(power) - 52, half = Math.trunc(exponent / 2); // 2^exponent alone may vanish
  return (sign ? -1 : 1) * significand * 2 ** half * 2 ** (exponent - half);
}
const vec = (list) => list.map(number);
const plus = (a, s, b) => a.map((x, k) => x + s * b[k]);
const dot = (a, b) => a.reduce((sum, x, k) => sum + x * b[k], 0);
const reduced = (q) => 1 / (1 / number(q.m_A) + 1 / number(q.m_B));

/** a, h, c and D of a t^2 + 2 h t + c (docs/eq2.md says why so). */
function quadratic(q) {
  const r = plus(vec(q.u_B), -1, vec(q.u_A)), v = plus(vec(q.v_B), -1, vec(q.v_A)), L = number(q.L);
  const a = dot(v, v), h = dot(r, v), distance = Math.sqrt(dot(r, r)), c = (distance - L) * (distance + L);
  let across = 0;
  for (let j = 0; j < r.length; ++j) for (let i = 0; i < j; ++i) across += (r[i] * v[j] - r[j] * v[i]) ** 2;
  return { a, h, c, D: h * h < a * L * L ? h * h - a * c : a * L * L - across };
}

const operations = {
  block_time(q) {
    const { a, h, c, D } = quadratic(q);
    if (a === 0 || h >= 0) return { verdict: a === 0 ? "static" : "receding", t: null };
    if (c <= 0) return { verdict: c < 0 ? "overlap" : "contact", t: 0 };
    if (D <= 0) return { verdict: D < 0 ? "miss" : "tangent", t: null };
    return { verdict: "hit", t: c / (-h + Math.sqrt(D)) };
  },
  tether_time(q) {
    const { a, h, c, D } = quadratic(q);
    if (a === 0) return { verdict: "static", t: null };
    if (c >= 0 && h >= 0) return { verdict: c > 0 ? "overstretched" : "taut", t: 0 };
    if (c > 0 && D <= 0) return { verdict: "turning", t: -h / a };
    return { verdict: "hit", t: h > 0 ? -c / (h + Math.sqrt(D)) : (-h + Math.sqrt(D)) / a };
  },
  apply_impulse: (q) => ({ v_A: vec(q.v_A).map((v, k) => v + number(q.dp[k]) / number(q.m_A)),
                           v_B: vec(q.v_B).map((v, k) => v - number(q.dp[k]) / number(q.m_B)) }),
  collision_impulse(q) {
    const r = plus(vec(q.u_B), -1, vec(q.u_A)), distance = Math.sqrt(dot(r, r)), n = r.map((x) => x / distance);
    const v_n = dot(plus(vec(q.v_B), -1, vec(q.v_A)), n);
    return { dp: n.map((x) => (1 + number(q.c)) * reduced(q) * (v_n * x)) };
  },
  load(q) {
    const m_A = number(q.m_A), m_B = number(q.m_B);
    return { v_load: vec(q.v_A).map((v, k) => (1 / (1 + m_B / m_A)) * v + (1 / (1 + m_A / m_B)) * number(q.v_B[k])) };
  },
  restitution_impulse: (q) => ({ dp_AB: plus(vec(q.dp), -reduced(q), plus(vec(q.v_B), -1, vec(q.v_A))) }),
};

require("readline").createInterface({ input: process.stdin }).on("line", (line) => {
  const { hello, bye, seq, op, in: question } = JSON.parse(line);
  if (bye) process.exit(0);
  const reply = hello ? { name: "JavaScript", ops: Object.keys(operations) } : { seq, out: operations[op](question) };
  process.stdout.write(JSON.stringify(reply) + "\n"); // NaN and Infinity become null, which is no number
});
