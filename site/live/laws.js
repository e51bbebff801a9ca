// Laws that the present case can show: the question is changed, and it is known what the answer must become, to the last bit. They are those of `tps properties`; the
// bounded ones, which need the error of an evaluation, are left to it.
'use strict';

/** Numbers of a question: texts to numbers, and back to texts that are read as the same doubles. */
tpsLive.mapValues = (values, change) => Object.fromEntries(Object.entries(values).map(([key, texts]) => {
  const before = texts.map(tpsLive.numberOf);
  const after = change(key, before);
  return [key, texts.map((text, n) => (Object.is(after[n], before[n]) ? text : Number.isFinite(after[n]) ? String(after[n]) : 'inf'))];
}));
const tpsTimes = (factors) => (key, x) => { const f = factors[tpsLive.dimensionOf(key)] ?? 1; return x.map((c) => c * f); };

/** What a number of a question or an answer is, by its key. */
tpsLive.dimensionOf = (key) => (/^u_|^L$|^du$/.test(key) ? 'length' : /^v_/.test(key) ? 'velocity' : /^m_/.test(key) ? 'mass' : /^dp/.test(key) ? 'impulse' : /^d?t$/.test(key) ? 'time' : 'number');

/** Whether x + by is a double: what TwoSum leaves is 0. */
tpsLive.isExactSum = function (x, by) {
  const sum = x + by, other = sum - x;
  return (x - (sum - other)) + (by - other) === 0;
};
const tpsVectors = (values) => Object.entries(values).filter(([key]) => /^(u|v|dp)/.test(key)).map(([, x]) => x);
const tpsPlanar = (values) => tpsVectors(values).every((x) => x.length === 2);

/**
 * Of each: whether it says anything about a case (`applies`), the other question (`ask`), and what a result of the present question must be in the answer to the other
 * (`becomes`: key and numbers to key and numbers). Without `ask`, `holds` looks at the present answer alone.
 */
tpsLive.laws = [
  { name: 'A and B exchanged: the same answer, impulses reversed',
    ask(values) {
      const partner = (key) => key.replace(/_[AB]$/, (end) => (end === '_A' ? '_B' : '_A'));
      return tpsLive.mapValues(Object.fromEntries(Object.keys(values).map((key) => [key, values[partner(key)] ?? values[key]])), (key, x) => (key === 'dp' ? x.map((c) => -c) : x));
    },
    becomes: (key, x) => (/^dp/.test(key) ? [key, x.map((c) => -c)] : [{ v_A: 'v_B', v_B: 'v_A' }[key] ?? key, x]) },
  { name: 'velocities doubled: times halve, whatever is an impulse or a speed doubles', factors: { velocity: 2, impulse: 2, time: 0.5 } },
  { name: 'lengths and velocities doubled: the same times and verdict, twice the impulses', applies: (values) => 'u_A' in values, factors: { length: 2, velocity: 2, impulse: 2 } },
  { name: 'masses doubled: twice the impulses, the same velocities', applies: (values) => 'm_A' in values, factors: { mass: 2, impulse: 2 } },
  { name: 'the first axis reflected: everything else stays', ...((reflect) => ({ ask: (values) => tpsLive.mapValues(values, reflect), becomes: (key, x) => [key, reflect(key, x)] }))(
    (key, x) => (x.length > 1 ? [-x[0], ...x.slice(1)] : x)) },
  { name: 'turned by a quarter: the answer turns along', applies: tpsPlanar, ...((turn) => ({ ask: (values) => tpsLive.mapValues(values, turn), becomes: (key, x) => [key, turn(key, x)] }))(
    (key, x) => (x.length === 2 ? [-x[1], x[0]] : x)) },
  { name: 'both moved by 1 along the first axis: nothing changes', applies: (values) => 'u_A' in values && ['u_A', 'u_B'].every((key) => tpsLive.isExactSum(tpsLive.numberOf(values[key][0]), 1)),
    ask: (values) => tpsLive.mapValues(values, (key, x) => (/^u_/.test(key) ? [x[0] + 1, ...x.slice(1)] : x)), becomes: (key, x) => [key, x] },
  { name: 'a larger limit is not reached later (here a quarter larger)', applies: (values, report, op) => op === 'block_time' && tpsLive.wordOf(report, 'verdict') === 'hit',
    ask: (values) => tpsLive.mapValues(values, (key, x) => (key === 'L' ? [x[0] * 1.25] : x)),
    judge: (report, other) => tpsLive.timeOf(other) <= tpsLive.timeOf(report) },
  { name: 'a time goes with its verdict: none, at once, or later', applies: (values, report) => Boolean(tpsLive.wordOf(report, 'verdict')),
    holds(values, report) {
      const word = tpsLive.wordOf(report, 'verdict'), t = tpsLive.timeOf(report);
      if (/^(static|receding|miss|tangent)$/.test(word)) return t === undefined;
      return /^(contact|overlap|taut|overstretched)$/.test(word) ? t === 0 : t >= 0;
    } },
  { name: 'an infinite mass keeps its velocity', applies: (values, report) => ['A', 'B'].some((n) => values[`m_${n}`]?.[0] === 'inf') && report.results.some((q) => q.key === 'v_A'),
    holds: (values, report) => ['A', 'B'].every((n) => values[`m_${n}`][0] !== 'inf' ||
      report.results.find((q) => q.key === `v_${n}`).hex.every((x, k) => tpsLive.numberOf(x) === tpsLive.numberOf(values[`v_${n}`][k]))) },
];
for (const law of tpsLive.laws) {
  if (!law.factors) continue;
  law.ask = (values) => tpsLive.mapValues(values, tpsTimes(law.factors));
  law.becomes = (key, x) => [key, tpsTimes(law.factors)(key, x)];
}
tpsLive.wordOf = (report, key) => report.results.find((q) => q.key === key)?.word;
tpsLive.timeOf = (report) => { const t = report.results.find((q) => q.key === 't'); return t && t.hex.length ? tpsLive.numberOf(t.hex[0]) : undefined; };

/** The laws that say something about a case, each with whether it holds. @param ask answers a question of the same operation. */
tpsLive.judgeLaws = function (op, values, report, ask) {
  return tpsLive.laws.filter((law) => !law.applies || law.applies(values, report, op)).map((law) => {
    if (law.holds) return { name: law.name, holds: law.holds(values, report) };
    let other;
    try {
      other = ask(law.ask(values));
    } catch {
      return { name: law.name }; // beyond the range of numbers
    }
    if (law.judge) return { name: law.name, holds: law.judge(report, other) };
    const holds = report.results.every((q) => {
      const [key, numbers] = law.becomes(q.key, q.hex.map(tpsLive.numberOf));
      const there = other.results.find((o) => o.key === key);
      return there.word === q.word && there.hex.length === numbers.length && there.hex.every((x, n) => tpsLive.numberOf(x) === numbers[n]);
    });
    return { name: law.name, holds };
  });
};
