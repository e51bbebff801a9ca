// How dense events are along the axis, by kind, with findings and the place shown.
'use strict';

/** The axis: either time, or the number of events with the share of the way to the next, so that nearly simultaneous ones lie
 * apart. Places on it are numbers from 0 to `length`. */
TPS.Axis = class {
  constructor(motion) {
    this.motion = motion;
    this.by = 'time';
  }
  get length() {
    return this.by === 'time' ? this.motion.tEnd || 1 : this.motion.events + 1;
  }
  of(n, t) {
    if (this.by === 'time') return t;
    const [from, to] = this.between(n);
    return n + (to > from ? Math.min(1, (t - from) / (to - from)) : 0);
  }
  /** @returns {[number, number]} events and time at a place. */
  at(u) {
    const { motion } = this;
    if (this.by === 'time') return [motion.eventsUntil(u), u];
    const n = Math.max(0, Math.min(motion.events, Math.floor(u)));
    const [from, to] = this.between(n);
    return [n, from + Math.min(1, u - n) * (to - from)];
  }
  /** The time between the n-th event and the next one. */
  between(n) {
    const { motion } = this;
    return [n === 0 ? 0 : motion.c.event_t[n - 1], n < motion.events ? motion.c.event_t[n] : motion.tEnd];
  }
  ofEvent(e) {
    return this.by === 'time' ? this.motion.c.event_t[e] : e + 1;
  }
};

TPS.Timeline = class {
  constructor(canvas, axis, motion, findings) {
    Object.assign(this, { canvas, axis, motion, findings });
  }

  resize() {
    const ratio = window.devicePixelRatio || 1;
    this.canvas.width = Math.max(1, Math.round(this.canvas.clientWidth * ratio));
    this.canvas.height = Math.max(1, Math.round(this.canvas.clientHeight * ratio));
    this.ratio = ratio;
    this.count();
  }

  count() {
    const kinds = this.motion.what.kinds.length;
    this.bins = Math.max(1, Math.floor(this.canvas.width / (3 * this.ratio)));
    this.counts = new Float64Array(this.bins * kinds);
    this.most = 1;
    const totals = new Float64Array(this.bins);
    for (let e = 0; e < this.motion.events; e++) {
      const bin = Math.min(this.bins - 1, Math.floor(this.axis.ofEvent(e) / this.axis.length * this.bins));
      this.counts[bin * kinds + this.motion.c.event_kind[e]]++;
      this.most = Math.max(this.most, ++totals[bin]);
    }
    this.totals = totals;
  }

  draw(u) {
    const context = this.canvas.getContext('2d');
    const { width, height } = this.canvas;
    const style = getComputedStyle(document.documentElement);
    const kinds = this.motion.what.kinds;
    context.clearRect(0, 0, width, height);
    const foot = 10 * this.ratio, room = height - foot, step = width / this.bins;
    for (let bin = 0; bin < this.bins; bin++) {
      if (!this.totals[bin]) continue;
      // The height is the square root, so that single events beside a burst are seen.
      const tall = Math.max(2 * this.ratio, Math.sqrt(this.totals[bin] / this.most) * room);
      let y = room;
      for (let kind = 0; kind < kinds.length; kind++) {
        const part = tall * this.counts[bin * kinds.length + kind] / this.totals[bin];
        context.fillStyle = TPS.kindColour(kinds[kind]);
        context.fillRect(bin * step, y - part, Math.max(1, step - 1), part);
        y -= part;
      }
    }
    context.fillStyle = style.getPropertyValue('--mark');
    for (const finding of this.findings) {
      if (finding.place === 0 && !this.motion.events) continue;
      const x = this.axis.ofEvent(Math.max(0, finding.place - 1)) / this.axis.length * width;
      context.beginPath();
      context.moveTo(x, room + 1);
      context.lineTo(x - 4 * this.ratio, height);
      context.lineTo(x + 4 * this.ratio, height);
      context.fill();
    }
    context.fillStyle = style.getPropertyValue('--ink');
    context.fillRect(u / this.axis.length * width - this.ratio / 2, 0, Math.max(1, this.ratio), height);
  }
};
