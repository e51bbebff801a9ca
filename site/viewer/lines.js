// Lines of the picture: tethers, impulses, velocities, the path of who is selected, what a finding expected.
'use strict';

TPS.colour = {
  tether: new THREE.Color('#8a8a94'),
  taut: new THREE.Color('#d62718'),
  wall: new THREE.Color('#7a7468'),
  event: new THREE.Color('#0072b2'),
  found: new THREE.Color('#d55e00'),
  expected: new THREE.Color('#009e73'),
  wrong: new THREE.Color('#d62718'),
  velocity: new THREE.Color('#7b6fd0'),
  bodies: ['#c02814', '#6e2896', '#00693c', '#0a3ca0', '#aa1464', '#785500'].map((c) => new THREE.Color(c)),
};

/** A tether is drawn taut from this share of its limit on: what the eye takes for the limit, no verdict. */
TPS.tautFrom = 0.999;
/** Pixels of the longest impulse of the trace, and of any. */
TPS.longestArrow = 90;
TPS.shortestArrow = 14;
/** Changes of the selected particle that its path goes back. */
TPS.pathChanges = 200;

/** From coordinates of the run to those of the picture. */
TPS.pointIn = function (picture, x) {
  return [picture.scaled(x[0], 0), picture.scaled(x[1], 1), picture.motion.dimension === 3 ? picture.scaled(x[2], 2) : 0];
};

TPS.tetherLines = function (picture, marks) {
  const { motion } = picture;
  const at = (p) => TPS.pointIn(picture, motion.position.subarray(3 * p, 3 * p + 3));
  const shown = ([i, j]) => !picture.showOnly || picture.concerned(i, marks) || picture.concerned(j, marks);
  return [...motion.tethers.values()].filter(shown).map(([i, j]) => {
    const limit = motion.limit(motion.outer, i, j);
    const taut = limit !== undefined && motion.distance(i, j) >= TPS.tautFrom * limit;
    return { from: at(i), to: at(j), colour: taut ? TPS.colour.taut : TPS.colour.tether, width: taut ? 3 : 2 };
  });
};

TPS.arrowLines = function (picture, marks) {
  const lines = [];
  const { motion } = picture;
  const at = (p) => TPS.pointIn(picture, motion.position.subarray(3 * p, 3 * p + 3));
  if (picture.selected >= 0) lines.push(...TPS.pathOf(picture, picture.selected));
  if (picture.showVelocities) {
    const unit = 60 / marks.fastest;
    for (let p = 0; p < motion.count; p++) TPS.arrow(lines, picture, at(p), motion.velocity(p), unit, TPS.colour.velocity, 1.5);
  }
  // An edge in the colour of the paper first, so that an arrow is seen on a particle of its own colour.
  for (const a of marks.arrows) TPS.arrow(lines, picture, at(a.particle), a.value, a.unit, picture.uniforms.paper.value, a.width + 3, a.least, a.shift);
  for (const a of marks.arrows) TPS.arrow(lines, picture, at(a.particle), a.value, a.unit, TPS.colour[a.colour], a.width, a.least, a.shift);
  return lines;
};

/** From the changes before to where it is now. */
TPS.pathOf = function (picture, p) {
  const { motion } = picture;
  const D = motion.dimension, lines = [];
  const last = motion.cursor[p];
  const point = (x) => TPS.pointIn(picture, x);
  let to = point(motion.position.subarray(3 * p, 3 * p + 3));
  for (let k = last; k >= motion.start[p] - 1 && k > last - TPS.pathChanges; k--) {
    const c = k < motion.start[p] ? -1 : motion.changes[k];
    const x = c < 0 ? motion.c.particle_position : motion.c.change_position;
    const from = point(x.subarray((c < 0 ? p : c) * D, (c < 0 ? p : c) * D + D));
    lines.push({ from, to, colour: picture.uniforms.ink.value, width: 1 });
    to = from;
  }
  return lines;
};

/** An arrow of `unit` pixels a unit of length of `vector`, at least `least` pixels long. Two that are compared stand on either
 * side of the point, `shift` 1 and −1. @returns its tip; null: a vector of no length */
TPS.arrow = function (lines, picture, from, vector, unit, colour, width, least = 0, shift = 0) {
  const size = Math.hypot(...vector);
  if (!(size > 0)) return null;
  const length = Math.max(size * unit, least) * picture.pixel;
  const direction = new THREE.Vector3(vector[0] / size, vector[1] / size, (vector[2] || 0) / size);
  const upwards = new THREE.Vector3(0, 7 * shift * picture.pixel, 0).applyQuaternion(picture.turn.clone().inverse());
  const tail = new THREE.Vector3(...from).add(upwards);
  const tip = tail.clone().addScaledVector(direction, length);
  // The head lies in the plane of the picture.
  const seen = direction.clone().applyQuaternion(picture.turn);
  const across = new THREE.Vector3(-seen.y, seen.x, 0).normalize().applyQuaternion(picture.turn.clone().inverse());
  const head = Math.min(8 * picture.pixel, length * 0.5);
  lines.push({ from: tail.toArray(), to: tip.toArray(), colour, width });
  for (const side of [-0.5, 0.5]) {
    const barb = tip.clone().addScaledVector(direction, -head).addScaledVector(across, side * head);
    lines.push({ from: barb.toArray(), to: tip.toArray(), colour, width });
  }
  return tip;
};
