// Walls as lines: planes by a square about the particles, spheres by great circles, boxes by their edges.
'use strict';

/** Segments of an ellipse that stands for a circle about `centre` in the plane of two unit vectors. */
TPS.circleSegments = function (centre, radius, a, b, count = 96) {
  const at = (k) => {
    const angle = 2 * Math.PI * k / count;
    return centre.map((x, d) => x + radius * (Math.cos(angle) * a[d] + Math.sin(angle) * b[d]));
  };
  return Array.from({ length: count }, (_, k) => [at(k), at(k + 1)]);
};

/** The edges of a box between two corners, in as many dimensions as they have. */
TPS.boxSegments = function (low, high) {
  const D = low.length, segments = [];
  for (let corner = 0; corner < 1 << D; corner++) {
    const point = low.map((x, d) => (corner >> d & 1 ? high[d] : x));
    for (let d = 0; d < D; d++) if (!(corner >> d & 1)) segments.push([point, point.map((x, e) => (e === d ? high[d] : x))]);
  }
  return segments;
};

/** A plane where it is nearest to the middle of the picture, `reach` to each side. */
TPS.planeSegments = function (point, normal, middle, reach) {
  const D = point.length;
  const off = normal.reduce((sum, n, d) => sum + n * (middle[d] - point[d]), 0);
  const foot = point.map((_, d) => middle[d] - off * normal[d]);
  if (D === 2) {
    const along = [-normal[1], normal[0]];
    return [[foot.map((x, d) => x - reach * along[d]), foot.map((x, d) => x + reach * along[d])]];
  }
  const n = new THREE.Vector3(...normal);
  const a = new THREE.Vector3(...(Math.abs(normal[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0])).cross(n).normalize(), b = a.clone().cross(n);
  const corner = (s, t) => foot.map((x, d) => x + reach * (s * a.getComponent(d) + t * b.getComponent(d)));
  const corners = [corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)];
  return corners.map((c, k) => [c, corners[(k + 1) % 4]]);
};

TPS.wallLines = function (picture) {
  const { motion } = picture;
  const D = motion.dimension;
  const lines = [];
  for (const wall of motion.what.walls) {
    const cut = (v) => v.slice(0, D);
    const point = cut(wall.point).map((x, d) => x + wall.velocity[d] * motion.t);
    let segments;
    if (wall.shape === 'plane') segments = TPS.planeSegments(point, cut(wall.normal), picture.middle, 1.02 * picture.extent);
    else if (wall.shape === 'box') segments = TPS.boxSegments(point, cut(wall.high).map((x, d) => x + wall.velocity[d] * motion.t));
    else {
      const axes = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].slice(0, D).map(cut);
      segments = axes.flatMap((a, k) => axes.slice(k + 1).flatMap((b) => TPS.circleSegments(point, wall.radius, a, b)));
    }
    for (const [from, to] of segments)
      lines.push({ from: TPS.pointIn(picture, from), to: TPS.pointIn(picture, to), colour: TPS.colour.wall, width: 2 });
  }
  return lines;
};
