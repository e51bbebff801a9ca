// What a trace says, drawn: places over time, the path of a pair, trees of loads.
'use strict';

/** Events of a trace, numbers as doubles. @returns {{scene, events, end}} */
tpsLive.readTrace = function (text) {
  const [head, ...lines] = text.trimEnd().split('\n').map((line) => JSON.parse(line));
  const vector = (texts) => texts && texts.map(tpsLive.numberOf);
  const state = (states) => Object.fromEntries(Object.entries(states || {}).map(([id, s]) => [id, { position: vector(s.position), velocity: vector(s.velocity) }]));
  const events = lines.filter((l) => l.k).map((l) => ({ ...l, t: tpsLive.numberOf(l.t), pre: state(l.pre), post: state(l.post), dp: vector(l.dp), dp_stored: vector(l.dp_stored) }));
  const end = lines.find((l) => l.end !== undefined);
  return { scene: head.scene, events, end: end && end.end };
};

/** Broken lines of each particle's first coordinate: [[t, x], …] by id; flight is straight before, between and after events. */
tpsLive.worldLines = function ({ scene, events }, until) {
  const lines = new Map();
  const last = new Map();
  scene.particles.forEach((p, n) => {
    const id = String(p.id ?? n), x = Number(p.position[0]), v = Number((p.velocity || [0])[0]);
    lines.set(id, [[0, x]]);
    last.set(id, [0, x, v]);
  });
  for (const e of events) {
    for (const [id, s] of Object.entries(e.post)) {
      lines.get(id).push([e.t, s.position[0]]);
      last.set(id, [e.t, s.position[0], s.velocity[0]]);
    }
  }
  for (const [id, [t, x, v]] of last) lines.get(id).push([until, x + v * (until - t)]);
  return lines;
};

tpsLive.colours = ['#56b4e9', '#e69f00', '#009e73', '#cc79a7', '#0072b2', '#d55e00'];

/** Particles on a line less what lies between their centres at contact, so that lines meet where particles do. */
tpsLive.closedUp = function ({ scene, events }) {
  const shift = new Map();
  let total = 0;
  scene.particles.forEach((p, n) => {
    const before = n > 0 && scene.species[scene.particles[n - 1].species], own = scene.species[p.species];
    if (before) total += (before.radius || 0) + (own.radius || 0);
    shift.set(String(p.id ?? n), total);
  });
  const moved = (states) => Object.fromEntries(Object.entries(states).map(([id, s]) => [id, { ...s, position: [s.position[0] - shift.get(id), ...s.position.slice(1)] }]));
  return { scene: { ...scene, particles: scene.particles.map((p, n) => ({ ...p, position: [p.position[0] - shift.get(String(p.id ?? n)), ...p.position.slice(1)] })) },
    events: events.map((e) => ({ ...e, pre: moved(e.pre), post: moved(e.post) })) };
};

/** A diagram with places across and time upwards, about the events. */
tpsLive.spaceTime = function (asIs, names) {
  const { svg } = tpsLive;
  const trace = tpsLive.closedUp(asIs);
  const { events } = trace;
  const first = events.length ? events[0].t : 0, lastTime = events.length ? events[events.length - 1].t : 1;
  const margin = (lastTime - first || first || 1) * 0.25;
  const from = Math.max(0, first - margin), to = lastTime + margin;
  const lines = tpsLive.worldLines(trace, to);
  const seen = [...lines.values()].flatMap((points) => points.filter(([t], n) => (t >= from && t <= to) || (points[n + 1] && points[n + 1][0] >= from)).map(([, x]) => x));
  const near = events.flatMap((e) => Object.values(e.post).map((s) => s.position[0]));
  const low = Math.min(...(near.length ? near : seen)), high = Math.max(...(near.length ? near : seen));
  const pad = (high - low || 1) * 0.25;
  const W = 640, H = 360;
  const X = (x) => (x - low + pad) / (high - low + 2 * pad) * W, Y = (t) => H - 20 - (t - from) / (to - from || 1) * (H - 30);
  const element = svg('svg', { viewBox: `0 0 ${W} ${H}`, class: 'tps-diagram', role: 'img', 'aria-label': 'Places across, time upwards' });
  for (let k = 0; k <= 4; k++) {
    const t = from + (to - from) * k / 4;
    element.append(svg('line', { x1: 0, x2: W, y1: Y(t), y2: Y(t), class: 'tps-grid' }), svg('text', { x: 4, y: Y(t) - 3 }, `t = ${tpsLive.short(t)}`));
  }
  let n = 0;
  for (const [id, points] of lines) {
    const colour = tpsLive.colours[n++ % tpsLive.colours.length];
    element.append(svg('polyline', { points: points.map(([t, x]) => `${X(x).toFixed(2)},${Y(t).toFixed(2)}`).join(' '), class: 'tps-world', stroke: colour }));
    const [, x] = points.find(([t]) => t >= from) || points[0];
    element.append(svg('text', { x: Math.min(W - 12, Math.max(2, X(x) + 4)), y: H - 6, fill: colour }, names[id] ?? id));
  }
  if (events.length < 400) for (const e of events) for (const id of [e.i, e.j]) if (e.post[id]) element.append(svg('circle', { cx: X(e.post[id].position[0]), cy: Y(e.t), r: 2, class: 'tps-hit' }));
  return element;
};

/** The path of the second particle about the first. */
tpsLive.relativePath = function ({ events }) {
  const { svg } = tpsLive;
  const points = events.map((e) => [e.post[e.j].position[0] - e.post[e.i].position[0], e.post[e.j].position[1] - e.post[e.i].position[1]]);
  const reach = Math.max(...points.flat().map(Math.abs), 1e-300) * 1.15;
  const to = ([x, y]) => [x / reach * 100, -y / reach * 100];
  const element = svg('svg', { viewBox: '-105 -105 210 210', class: 'tps-diagram', role: 'img', 'aria-label': 'The path of B about A' });
  // The outer distance, and the inner one where it is met.
  const met = [0, events.findIndex((e) => e.kind === 'rebound')].filter((n) => points[n]);
  for (const n of met) element.append(svg('circle', { cx: 0, cy: 0, r: Math.hypot(...to(points[n])), class: 'tps-circle' }));
  element.append(svg('circle', { cx: 0, cy: 0, r: 3, class: 'tps-A' }),
    svg('polyline', { points: points.map((p) => to(p).join(',')).join(' '), class: 'tps-world', stroke: tpsLive.colours[1], 'stroke-width': 1 }));
  for (const p of points) element.append(svg('circle', { cx: to(p)[0], cy: to(p)[1], r: 1.8, class: 'tps-hit' }));
  return element;
};

/** Particles on their line with velocities, and the loads above them as a tree; `gone` of its nodes have been taken apart. */
tpsLive.loadTree = function (bodies, nodes) {
  const { svg } = tpsLive;
  const W = 400, base = 210;  // narrow, so that words can be read where a page is
  const element = svg('svg', { viewBox: `0 0 ${W} 270`, class: 'tps-diagram tps-tree', role: 'img', 'aria-label': 'Particles, their velocities and the tree of loads' });
  element.append(tpsLive.arrowHeads());
  const ids = Object.keys(bodies);
  const at = Object.fromEntries(ids.map((id, n) => [id, 70 + n * (W - 140) / Math.max(1, ids.length - 1)]));
  const fastest = Math.max(...ids.map((id) => Math.abs(bodies[id].velocity[0])), 1e-300);
  const top = Object.fromEntries(ids.map((id) => [id, { x: at[id], y: base - 20 }]));
  const words = [];  // over all lines
  for (const node of nodes) {
    const x = (top[node.i].x + top[node.j].x) / 2, y = Math.min(top[node.i].y, top[node.j].y) - 64;
    const style = node.gone ? 'stroke-dasharray:4 4;opacity:.45' : '';
    for (const id of [node.i, node.j]) element.append(svg('line', { x1: top[id].x, y1: top[id].y, x2: x, y2: y, class: 'tps-arrow tps-axis', style: `stroke-width:1.5;${style}` }));
    element.append(svg('circle', { cx: x, cy: y, r: 5, class: 'tps-hit', style }));
    node.text.forEach((text, line) => words.push(svg('text', { x, y: y - 9 - 13 * (node.text.length - 1 - line), 'text-anchor': 'middle', class: 'tps-over', style: node.gone ? 'opacity:.6' : '' }, text)));
    for (const id of node.members) top[id] = { x, y };
  }
  element.append(...words);
  ids.forEach((id, n) => {
    element.append(svg('circle', { cx: at[id], cy: base, r: 17, fill: tpsLive.colours[n % tpsLive.colours.length] }), svg('text', { x: at[id], y: base + 4, 'text-anchor': 'middle', style: 'fill:#111' }, bodies[id].name));
    const length = bodies[id].velocity[0] / fastest * 50;
    if (Math.abs(length) > 1) element.append(svg('line', { x1: at[id], y1: base + 28, x2: at[id] + length, y2: base + 28, class: 'tps-arrow tps-velocity', style: 'stroke-width:2.5', 'marker-end': 'url(#tps-velocity)' }));
    element.append(svg('text', { x: at[id], y: base + 48, 'text-anchor': 'middle' }, `v = ${tpsLive.short(bodies[id].velocity[0])}`));
  });
  return element;
};
