// Where everything is: each particle flies straight from its last change. A place in the run is (n, t): n events
// have happened, and the time is t.
'use strict';

TPS.Motion = class {
  constructor({ what, columns }) {
    this.what = what;
    this.c = columns;
    this.dimension = what.dimension;
    this.count = columns.particle_id.length;
    this.events = columns.event_t.length;
    this.tEnd = Math.max(what.t_end, this.events ? columns.event_t[this.events - 1] : 0);
    this.indexOf = new Map();
    columns.particle_id.forEach((id, p) => this.indexOf.set(id, p));
    this.sortChanges();
    this.cursor = new Int32Array(this.count).fill(-1); // of the particle's changes so far, the last
    this.position = new Float64Array(3 * this.count);
    this.tethers = new Map();
    this.tetherCursor = 0;
    this.outer = this.limits('outer');
    this.n = 0;
    this.t = 0;
    this.go(0, 0);
  }

  /** The changes of each particle, in order: changes[start[p]] … changes[start[p + 1] − 1]. */
  sortChanges() {
    const of = this.c.change_particle;
    this.start = new Int32Array(this.count + 1);
    for (let k = 0; k < of.length; k++) this.start[of[k] + 1]++;
    for (let p = 0; p < this.count; p++) this.start[p + 1] += this.start[p];
    this.changes = new Int32Array(of.length);
    const next = this.start.slice();
    for (let k = 0; k < of.length; k++) this.changes[next[of[k]]++] = k;
  }

  /** A limit of each pair of species that has one, by "a b". */
  limits(which) {
    const map = new Map();
    for (const pair of this.what.pairs) {
      if (pair[which] === undefined) continue;
      const [a, b] = pair.species;
      map.set(a + ' ' + b, pair[which]).set(b + ' ' + a, pair[which]);
    }
    return map;
  }
  limit(map, i, j) {
    const species = this.c.particle_species;
    return map.get(species[i] + ' ' + species[j]);
  }

  /** Events up to and at time t. */
  eventsUntil(t) {
    let low = 0, high = this.events;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.c.event_t[middle] <= t) low = middle + 1; else high = middle;
    }
    return low;
  }

  /** Number of changes when n events have happened. */
  changesAfter(n) {
    return n < this.events ? this.c.event_first_change[n] : this.c.change_t.length;
  }

  go(n, t) {
    this.n = n;
    this.t = t;
    const limit = this.changesAfter(n);
    for (let p = 0; p < this.count; p++) this.move(p, limit, t);
    this.followTethers();
  }

  move(p, limit, t) {
    const { start, changes, cursor } = this;
    let at = cursor[p];
    const first = start[p], end = start[p + 1];
    let k = at < 0 ? first - 1 : at;
    while (k + 1 < end && changes[k + 1] < limit) k++;
    while (k >= first && changes[k] >= limit) k--;
    cursor[p] = k < first ? -1 : k;
    const D = this.dimension;
    at = cursor[p];
    const c = at < 0 ? -1 : changes[at];
    const base = c < 0 ? p * D : c * D;
    const x = c < 0 ? this.c.particle_position : this.c.change_position;
    const v = c < 0 ? this.c.particle_velocity : this.c.change_velocity;
    const since = t - (c < 0 ? 0 : this.c.change_t[c]);
    const following = this.what.one_of > 1 && k + 1 < end ? changes[k + 1] : -1;
    for (let d = 0; d < D; d++) {
      let value = x[base + d] + v[base + d] * since;
      if (following >= 0) { // changes in between are missing: straight to the next one there is
        const whole = this.c.change_t[following] - (t - since);
        const share = whole > 0 ? since / whole : 0;
        value = x[base + d] + (this.c.change_position[following * D + d] - x[base + d]) * share;
      }
      this.position[3 * p + d] = value;
    }
  }

  velocity(p) {
    const D = this.dimension;
    const c = this.cursor[p] < 0 ? -1 : this.changes[this.cursor[p]];
    const v = c < 0 ? this.c.particle_velocity : this.c.change_velocity;
    return Array.from(v.subarray((c < 0 ? p : c) * D, ((c < 0 ? p : c) + 1) * D));
  }
  place(p) {
    return Array.from(this.position.subarray(3 * p, 3 * p + this.dimension));
  }
  /** Number of the load that it moves with, −1: none. */
  body(p) {
    return this.cursor[p] < 0 ? -1 : this.c.change_body[this.changes[this.cursor[p]]];
  }
  members(body) {
    const members = [];
    for (let p = 0; body >= 0 && p < this.count; p++) if (this.body(p) === body) members.push(p);
    return members;
  }

  followTethers() {
    const { tether_t, tether_i, tether_j, tether_formed } = this.c;
    const until = this.n === 0 ? 0 : this.c.event_t[this.n - 1];
    if (this.tetherCursor > 0 && tether_t[this.tetherCursor - 1] > until) {
      this.tetherCursor = 0;
      this.tethers.clear();
    }
    while (this.tetherCursor < tether_t.length && tether_t[this.tetherCursor] <= until) {
      const i = tether_i[this.tetherCursor], j = tether_j[this.tetherCursor];
      const key = Math.min(i, j) * this.count + Math.max(i, j);
      if (tether_formed[this.tetherCursor]) this.tethers.set(key, [i, j]); else this.tethers.delete(key);
      this.tetherCursor++;
    }
  }
  distance(i, j) {
    const x = this.position;
    return Math.hypot(x[3 * i] - x[3 * j], x[3 * i + 1] - x[3 * j + 1], x[3 * i + 2] - x[3 * j + 2]);
  }

  /** Event e as an object; its velocities after it are those of the changes it made. */
  event(e) {
    const c = this.c, D = this.dimension;
    const flags = c.event_flags[e];
    return { number: e, k: c.event_k[e], t: c.event_t[e], dt: c.event_dt[e], line: c.event_line[e],
      kind: this.what.kinds[c.event_kind[e]], i: c.event_i[e], j: c.event_j[e],
      dp: flags & 1 ? Array.from(c.event_dp.subarray(e * D, (e + 1) * D)) : null,
      formed: !!(flags & TPS.formed), broken: !!(flags & TPS.broken), load: !!(flags & 8) };
  }
};
