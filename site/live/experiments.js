// The paper's experiments: the engine runs in a worker, the page draws what its trace says.
'use strict';

tpsLive.Experiment = class {
  /** `fields`: [{name, label, value, min, max, step, shown}] of sliders. */
  constructor(root, fields) {
    const { element } = tpsLive;
    this.root = root;
    this.row = element('div', { className: 'tps-live-row' });
    this.says = element('p', { className: 'tps-says', role: 'status' }, 'Loading the engine …');
    this.picture = element('div');
    this.values = {};
    for (const field of fields) {
      const slider = element('input', { type: 'range', min: field.min, max: field.max, step: field.step, value: field.value, name: field.name });
      const shown = element('output');
      const take = () => {
        this.values[field.name] = field.of ? field.of(Number(slider.value)) : Number(slider.value);
        shown.textContent = tpsLive.short(this.values[field.name]);
      };
      slider.addEventListener('input', () => { take(); this.run(); });
      take();
      this.row.append(element('label', {}, field.label, slider, shown));
    }
    root.replaceChildren(this.row, this.says, this.picture);
    this.picture.append(tpsLive.svg('svg', { class: 'tps-diagram', viewBox: '0 0 640 10' }));
    // The engine is loaded when the experiment comes into sight.
    const watcher = new IntersectionObserver((entries) => {
      if (!entries.some((e) => e.isIntersecting)) return;
      watcher.disconnect();
      this.runner = new tpsLive.Runner();
      this.run();
    });
    watcher.observe(root);
  }

  async run() {
    if (!this.runner) return;
    try {
      const ask = await tpsLive.reference();
      const { scene } = ask({ do: 'scene', name: this.scene, options: Object.fromEntries(Object.entries(this.options()).map(([k, v]) => [k, String(v)])) });
      this.runner.ask({ do: 'run', scene, max_events: this.mostEvents }, (answer) => {
        if (answer.error) { this.complain(answer.error); return; }
        this.says.classList.remove('tps-error');
        this.answer = answer;
        this.show(tpsLive.readTrace(answer.trace), answer);
      });
    } catch (error) {
      this.complain(error.message);
    }
  }
  complain(message) {
    this.says.classList.add('tps-error');
    this.says.textContent = message;
  }
  get mostEvents() { return 20000; } // a stall is certain after ten thousand events without time (docs/engine.md)
};

tpsLive.experiments = {};

tpsLive.experiments['three-body'] = class extends tpsLive.Experiment {
  constructor(root) {
    super(root, [{ name: 'mass', label: 'm_Y', min: -4, max: 0, step: 0.1, value: -3, of: (x) => Number((10 ** x).toPrecision(3)) },
      { name: 'c', label: 'c', min: 0, max: 1, step: 0.01, value: 1 }, { name: 'grouped', label: 'Δt_restitute', min: 0, max: 0.2, step: 0.0025, value: 0 }]);
  }
  get scene() { return 'three-body'; }
  options() { return { 'middle-mass': this.values.mass, restitution: this.values.c, grouped: this.values.grouped }; }
  show(trace, { end, events, stalled_on: on }) {
    const collisions = trace.events.filter((e) => e.kind === 'rebound').length;
    const words = [`${collisions} collision${collisions === 1 ? '' : 's'}`];
    if (trace.events.some((e) => e.kind === 'restitute')) words.push(`${events - collisions} restitutions`);
    words.push(end === 'stalled' ? `stalled at t = ${trace.events.at(-1).t}: the clock no longer moves, on ${on.join(', ')}` : `end: ${end.replace(/_/g, ' ')}`);
    if (this.values.c === 1 && this.values.grouped === 0) {
      // Three on a line are one ball in a wedge (docs/claims.md): its angle by the masses 1, m, 1.
      const angle = Math.atan(Math.sqrt(this.values.mass * (2 + this.values.mass)));
      words.push(`the wedge of ${tpsLive.short(angle * 180 / Math.PI)}° allows ${Math.ceil(Math.PI / angle) - 1} at most`);
    }
    this.says.textContent = words.join('; ') + '.';
    this.picture.replaceChildren(tpsLive.spaceTime(trace, { 0: 'X', 1: 'Y', 2: 'Z' }));
  }
};

tpsLive.experiments.galperin = class extends tpsLive.Experiment {
  constructor(root) {
    super(root, [{ name: 'digits', label: 'digits behind the point', min: 0, max: 3, step: 1, value: 1 }]);
  }
  get scene() { return 'galperin'; }
  options() { return { digits: this.values.digits }; }
  show(trace, { events, end }) {
    this.says.textContent = `${events} collisions with a mass ratio of ${100 ** this.values.digits}; π = ${Math.PI.toFixed(5)} (end: ${end.replace(/_/g, ' ')}).`;
    this.picture.replaceChildren(tpsLive.spaceTime(trace, {}));
  }
};

tpsLive.experiments.revolution = class extends tpsLive.Experiment {
  constructor(root) {
    super(root, [{ name: 'theta', label: 'θ_revolve, degrees', min: 5, max: 80, step: 1, value: 45 }, { name: 'c', label: 'c_revolve', min: 0.05, max: 1, step: 0.01, value: 0.5 }]);
  }
  get scene() { return 'pair'; }
  get mostEvents() { return Math.ceil(180 / this.values.theta) + 1; }
  options() { return { theta: this.values.theta, 'c-revolve': this.values.c, duration: 'inf' }; }
  show(trace) {
    const speed = (e, which) => Math.hypot(...e[which][e.j].velocity.map((v, k) => v - e[which][e.i].velocity[k]));
    const turn = 180 / this.values.theta;
    const events = trace.events.filter((e) => e.kind === 'revolve');
    const rebounds = trace.events.filter((e) => e.kind === 'rebound').length;
    const speeds = events.map((e) => speed(e, 'post'));
    const whole = Number.isInteger(turn) && events.length >= turn && rebounds === 0;
    this.says.textContent = `${events.length} revolutions drawn${rebounds ? `, and ${rebounds} rebounds between them: so steep a way leads through the inner distance` : ''}; the relative speed goes from ${tpsLive.short(speed(events[0], 'pre'))} over ${speeds.slice(0, 6).map(tpsLive.short).join(', ')}${speeds.length > 6 ? ' …' : ''}` +
      (rebounds ? '.' : whole ? `; after the ${turn} collisions of a whole turn it is ${tpsLive.short(speeds[turn - 1] / speed(events[0], 'pre'))} of what it was, and c_revolve is ${this.values.c}.` : '; a whole turn is no whole number of them.');
    this.picture.replaceChildren(tpsLive.relativePath(trace));
    this.picture.firstChild.style.maxWidth = '22rem';
  }
};

tpsLive.experiments.grouping = class extends tpsLive.Experiment {
  constructor(root) {
    super(root, [{ name: 'mass', label: 'm_Y', min: -4, max: 0, step: 0.1, value: -3, of: (x) => Number((10 ** x).toPrecision(3)) }, { name: 'c', label: 'c', min: 0, max: 1, step: 0.01, value: 1 }]);
    const button = (text, action) => {
      const b = tpsLive.element('button', { type: 'button' }, text);
      b.addEventListener('click', action);
      return b;
    };
    this.step = 0;
    this.row.append(button('step back', () => this.go(this.step - 1)), button('step', () => this.go(this.step + 1)), button('play', () => this.play()));
  }
  get scene() { return 'three-body'; }
  options() { return { 'middle-mass': this.values.mass, restitution: this.values.c, grouped: 0.0625 }; }
  show(trace) {
    this.trace = trace;
    this.go(Math.min(this.step, trace.events.length));
  }
  play() {
    clearInterval(this.timer);
    this.go(0);
    this.timer = setInterval(() => {
      if (this.step >= this.trace.events.length) clearInterval(this.timer); else this.go(this.step + 1);
    }, 1200);
  }
  go(step) {
    if (!this.trace) return;
    this.step = Math.max(0, Math.min(this.trace.events.length, step));
    const bodies = {}, nodes = [];
    this.trace.scene.particles.forEach((p, n) => { bodies[p.id ?? n] = { name: 'XYZ'[n] ?? String(n), velocity: p.velocity.map(Number) }; });
    const groups = new Map(Object.keys(bodies).map((id) => [id, [id]]));
    const mass = Object.fromEntries(this.trace.scene.particles.map((p, n) => [p.id ?? n, Number(this.trace.scene.species[p.species].mass)]));
    const massOf = (members) => tpsLive.short(members.reduce((sum, id) => sum + mass[id], 0));
    for (const e of this.trace.events.slice(0, this.step)) {
      if (e.members) {
        const members = e.members.map(String);
        const sides = [groups.get(String(e.i)), groups.get(String(e.j))];
        nodes.push({ i: String(e.i), j: String(e.j), members, sides, text: [`m_A = ${massOf(sides[0])}, m_B = ${massOf(sides[1])}`, `v_load = ${tpsLive.short(e.post[e.i].velocity[0])}`, `Δp_AB = ${tpsLive.short(e.dp_stored[0])}`] });
        for (const id of members) groups.set(id, members);
      } else if (e.kind === 'restitute') {
        const node = nodes.findLast((n) => !n.gone && n.i === String(e.i) && n.j === String(e.j));
        if (node) {
          node.gone = true;
          // The rest of a side moves with its particle of the pair.
          [e.i, e.j].forEach((id, s) => node.sides[s].forEach((m) => { bodies[m].velocity = e.post[id].velocity; groups.set(m, node.sides[s]); }));
        }
      }
      for (const [id, s] of Object.entries(e.post)) bodies[id].velocity = s.velocity;
    }
    const last = this.trace.events[this.step - 1];
    const name = (id) => bodies[id].name;
    this.says.textContent = !last ? `Before anything: ${this.trace.events.length} events follow.`
      : last.kind === 'restitute' ? `Event ${last.k}, t = ${tpsLive.short(last.t)}: ${name(last.i)} and ${name(last.j)} part by Δp_AB = ${tpsLive.short(last.dp[0])}, eq. (3).`
        : last.members ? `Event ${last.k}, t = ${tpsLive.short(last.t)}: ${name(last.i)} meets ${name(last.j)}; ${last.members.map(name).join(', ')} move together with the velocity of eq. (6); Δp of eq. (4) is ${tpsLive.short(last.dp[0])}, and eq. (7) keeps ${tpsLive.short(last.dp_stored[0])}.`
          : `Event ${last.k}, t = ${tpsLive.short(last.t)}: ${last.kind} of ${name(last.i)} and ${name(last.j)}.`;
    this.picture.replaceChildren(tpsLive.loadTree(bodies, nodes));
  }
};
