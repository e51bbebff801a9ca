// What is known of the event that happened last, of the particle that is selected, and of the findings. All text is set as text.
'use strict';

TPS.definitions = function (element, rows) {
  const list = document.createElement('dl');
  for (const [term, ...values] of rows) {
    const dt = document.createElement('dt'), dd = document.createElement('dd');
    dt.textContent = term;
    dd.append(...values);
    list.append(dt, dd);
  }
  element.replaceChildren(list);
};

/** Nine digits of a number; all of it, and its bits as a hexadecimal float, when it is pointed at. */
TPS.number = function (...numbers) {
  const span = document.createElement('span');
  const shown = numbers.map((x) => String(Number(x.toPrecision(9)))).join(', ');
  span.textContent = numbers.length === 1 ? shown : `(${shown})`;
  span.title = `${numbers.join(', ')}\n${numbers.map(TPS.hex).join(', ')}`;
  return span;
};

TPS.Inspector = class {
  /** `select(p)` selects a particle; `show(e)` goes to an event. */
  constructor(motion, findings, select, show) {
    Object.assign(this, { motion, findings, select, show });
    this.listFindings();
  }

  link(p) {
    const button = document.createElement('button');
    button.className = 'link';
    button.textContent = this.motion.c.particle_id[p];
    button.addEventListener('click', () => this.select(p));
    return button;
  }
  links(particles) {
    return particles.slice(0, 60).flatMap((p, n) => (n ? [' ', this.link(p)] : [this.link(p)]))
      .concat(particles.length > 60 ? [` … ${particles.length} in all`] : []);
  }

  event(e) {
    const element = document.getElementById('event');
    if (e < 0) {
      element.textContent = this.motion.events ? 'The start: nothing has happened yet.' : 'There are no events.';
      return;
    }
    const { c, what, dimension: D } = this.motion;
    const event = this.motion.event(e);
    const rows = [['kind', event.kind.replace(/_/g, ' ') + (event.load ? ': a load, applied at the restitution' : '')],
      ['k', `${event.k}, line ${event.line} of the trace`], ['t', TPS.number(event.t)], ['dt', TPS.number(event.dt)]];
    if (event.i >= 0) rows.push([event.j >= 0 ? 'pair' : 'particle', ...this.links([event.i, event.j].filter((p) => p >= 0))]);
    if (event.dp) rows.push(['Δp', TPS.number(...event.dp)]);
    if (event.formed || event.broken) rows.push(['tether', event.formed ? 'formed' : 'broken']);
    const before = this.changesBefore(e);
    for (const [p, change] of this.changesOf(e).slice(0, 12)) {
      const v = (k) => Array.from((k < 0 ? c.particle_velocity : c.change_velocity).subarray((k < 0 ? p : k) * D, (k < 0 ? p : k) * D + D));
      const id = c.particle_id[p];
      if (what.one_of === 1) rows.push([`v of ${id} before`, TPS.number(...v(before.get(p)))]);
      rows.push([`v of ${id} after`, TPS.number(...v(change))]);
    }
    TPS.definitions(element, rows);
  }

  /** Particles whose flight the event changed, with their changes. */
  changesOf(e) {
    const list = [];
    for (let k = this.motion.changesAfter(e); k < this.motion.changesAfter(e + 1); k++)
      list.push([this.motion.c.change_particle[k], k]);
    return list;
  }
  changesBefore(e) {
    const map = new Map();
    const limit = this.motion.changesAfter(e);
    for (const [p] of this.changesOf(e)) {
      const own = this.motion.changes.subarray(this.motion.start[p], this.motion.start[p + 1]);
      let low = 0, high = own.length;
      while (low < high) {
        const middle = (low + high) >> 1;
        if (own[middle] < limit) low = middle + 1; else high = middle;
      }
      map.set(p, low === 0 ? -1 : own[low - 1]);
    }
    return map;
  }

  particle(p) {
    const element = document.getElementById('particle');
    if (p < 0) {
      element.textContent = 'Click a particle, or type an id below.';
      return;
    }
    const { motion } = this;
    const { c, what } = motion;
    const species = what.species[c.particle_species[p]];
    const tethers = [...motion.tethers.values()].filter((pair) => pair.includes(p)).map(([i, j]) => (i === p ? j : i));
    const body = motion.body(p);
    const rows = [['id', String(c.particle_id[p])], ['species', species.name], ['mass', String(species.mass)], ['radius', String(species.radius)],
      ['position', TPS.number(...motion.place(p))], ['velocity', TPS.number(...motion.velocity(p))],
      ['events', `${motion.cursor[p] + 1 - motion.start[p] > 0 ? motion.cursor[p] + 1 - motion.start[p] : 0} so far, ` +
        `${motion.start[p + 1] - motion.start[p]} in all`]];
    if (tethers.length) rows.push(['tethered to', ...this.links(tethers)]);
    if (body >= 0) rows.push(['moves with', ...this.links(motion.members(body).filter((q) => q !== p))]);
    TPS.definitions(element, rows);
  }

  listFindings() {
    if (!this.findings.length) return;
    document.getElementById('findings_panel').hidden = false;
    const list = document.getElementById('findings');
    this.findings.forEach((finding, n) => {
      const item = document.createElement('li'), button = document.createElement('button');
      const off = finding.off === undefined ? '' : `\noff by ${typeof finding.off === 'number' ? finding.off.toPrecision(3) : finding.off}` +
        ` ulp, allowed ${finding.allowed}`;
      button.textContent = `${finding.rule}, ${finding.outcome}: event ${finding.event}, line ${finding.line}\n${finding.message}${off}` +
        (finding.equation ? `\neq. ${finding.equation}` : '') + (finding.reading ? `\nanother reading of the paper: ${finding.reading}` : '');
      button.addEventListener('click', () => this.show(finding.place - 1, n));
      item.append(button);
      list.append(item);
    });
  }
  markFindings(current) {
    const buttons = document.querySelectorAll('#findings button');
    this.findings.forEach((finding, n) => buttons[n].setAttribute('aria-current', String(finding === current)));
  }
};
