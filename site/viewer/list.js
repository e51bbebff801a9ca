// The list of events, filtered by kind and particle. Only the rows that are seen exist.
'use strict';

TPS.rowHeight = 24; // as in style.css
/** Beyond this browsers lose the height of an element; the list then scrolls in steps of several rows. */
TPS.tallest = 8e6;

TPS.List = class {
  /** `chosen(e)` is called with the number of the event that is picked. */
  constructor(motion, found, chosen) {
    Object.assign(this, { motion, found, chosen, at: -1 });
    this.box = document.getElementById('list');
    this.space = document.getElementById('list_space');
    this.rows = document.getElementById('list_rows');
    this.particle = document.getElementById('filter_particle');
    this.hidden = new Set();
    this.onlyFlags = 0; // bits of "event_flags" of which an event that is shown has one; 0: any event
    this.kindButtons();
    this.tetherButtons();
    this.particle.addEventListener('input', () => this.filter());
    this.box.addEventListener('scroll', () => this.draw());
    this.box.addEventListener('keydown', (event) => this.key(event));
    this.filter();
  }

  kindButtons() {
    const counts = new Float64Array(this.motion.what.kinds.length);
    for (const kind of this.motion.c.event_kind) counts[kind]++;
    counts.forEach((count, kind) => {
      if (!count) return;
      const name = this.motion.what.kinds[kind];
      const swatch = document.createElement('i');
      swatch.style.background = TPS.kindColour(name);
      this.button([swatch, ` ${name.replace(/_/g, ' ')} ${count}`], true, (on) => { if (on) this.hidden.delete(kind); else this.hidden.add(kind); });
    });
  }

  tetherButtons() {
    for (const [flag, name] of [[TPS.formed, 'formed'], [TPS.broken, 'broken']]) {
      const count = this.motion.c.event_flags.reduce((sum, flags) => sum + (flags & flag ? 1 : 0), 0);
      if (count) this.button([`only tether ${name} ${count}`], false, () => { this.onlyFlags ^= flag; });
    }
  }

  button(words, checked, changed) {
    const label = document.createElement('label'), box = document.createElement('input');
    Object.assign(box, { type: 'checkbox', checked });
    box.addEventListener('change', () => { changed(box.checked); this.filter(); });
    label.append(box, ' ', ...words);
    document.getElementById('kinds').append(label);
  }

  filter() {
    const { c, indexOf, events } = this.motion;
    const text = this.particle.value.trim();
    const only = text === '' ? null : indexOf.get(Number(text));
    const shown = [];
    for (let e = 0; e < events; e++) {
      if (this.hidden.has(c.event_kind[e])) continue;
      if (this.onlyFlags && !(c.event_flags[e] & this.onlyFlags)) continue;
      if (only !== null && c.event_i[e] !== only && c.event_j[e] !== only) continue;
      shown.push(e);
    }
    this.shown = shown;
    const unknown = text !== '' && only === undefined;
    document.getElementById('list_count').textContent =
      unknown ? `there is no particle ${text}` : `${shown.length} of ${events}`;
    this.scale = Math.max(1, shown.length * TPS.rowHeight / TPS.tallest);
    this.space.style.height = shown.length * TPS.rowHeight / this.scale + 'px';
    this.draw();
  }

  draw() {
    const first = Math.max(0, Math.floor(this.box.scrollTop * this.scale / TPS.rowHeight));
    const count = Math.ceil(this.box.clientHeight / TPS.rowHeight) + 1;
    this.rows.style.top = this.box.scrollTop - (this.scale > 1 ? 0 : this.box.scrollTop % TPS.rowHeight) + 'px';
    this.rows.replaceChildren(...this.shown.slice(first, first + count).map((e) => this.row(e)));
  }

  row(e) {
    const event = this.motion.event(e);
    const row = document.createElement('div');
    row.className = 'event' + (this.found.has(e) ? ' found' : '');
    row.setAttribute('role', 'option');
    row.setAttribute('aria-selected', String(e === this.at));
    const cell = (text) => {
      const span = document.createElement('span');
      span.textContent = text;
      row.append(span);
    };
    const swatch = document.createElement('i');
    swatch.style.background = TPS.kindColour(event.kind);
    row.append(swatch);
    const id = (p) => (p < 0 ? '' : this.motion.c.particle_id[p]);
    cell(event.k);
    cell(event.kind.replace(/_/g, ' ') + (event.formed ? ' + tether' : '') + (event.load ? ', load' : ''));
    cell(TPS.short(event.t));
    cell(event.j < 0 ? id(event.i) : `${id(event.i)}–${id(event.j)}`);
    row.addEventListener('click', () => this.chosen(e));
    return row;
  }

  /** Marks the event that happened last, and has it in sight. */
  mark(e, follow) {
    if (e === this.at) return;
    this.at = e;
    const { box, shown, scale } = this;
    let low = 0, high = shown.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (shown[middle] < e) low = middle + 1; else high = middle;
    }
    const top = low * TPS.rowHeight / scale;
    if (follow && e >= 0 && (top < box.scrollTop || top > box.scrollTop + box.clientHeight - TPS.rowHeight))
      box.scrollTop = top - box.clientHeight / 2;
    this.draw();
  }

  key(event) {
    const step = { ArrowDown: 1, ArrowUp: -1, PageDown: 10, PageUp: -10 }[event.key];
    if (!step || !this.shown.length) return;
    event.preventDefault();
    event.stopPropagation();
    let place = this.at < 0 ? -1 : this.shown.findIndex((e) => e >= this.at);
    if (place < 0 && this.at >= 0) place = this.shown.length - 1;
    this.chosen(this.shown[Math.max(0, Math.min(this.shown.length - 1, place + step))]);
  }
};
