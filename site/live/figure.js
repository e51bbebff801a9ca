// The figure of a pair: places and velocities that can be dragged, limit, impulse.
'use strict';

/** `values` holds "key" → list of texts; `changed(key, texts)` is called while something is dragged. */
tpsLive.Figure = class {
  constructor(changed) {
    this.changed = changed;
    this.element = tpsLive.svg('svg', { viewBox: '-6 -4 12 8', class: 'tps-figure', role: 'group', 'aria-label': 'The pair; drag its places and velocities, or use the arrow keys' });
    this.element.append(tpsLive.arrowHeads());
    this.layer = tpsLive.svg('g', { transform: 'scale(1,-1)' });
    this.element.append(this.layer);
    this.handles = new Map();
  }

  /** The part of the plane that is seen: changed by what is shown, never while something is dragged. */
  fit(points) {
    if (this.dragging || !points.length) return;
    const reach = Math.max(...points.map(([x, y]) => Math.max(Math.abs(x - points[0][0]) / 1.35, Math.abs(y - points[0][1]))), 1e-300);
    const good = this.scale && reach * this.scale < 3.6 && reach * this.scale > 0.8;
    if (good && this.origin && Math.hypot(points[0][0] - this.origin[0], points[0][1] - this.origin[1]) * this.scale < 4) return;
    this.scale = 2.8 / reach;
    this.origin = points.length > 1 ? [(points[0][0] + points[1][0]) / 2, (points[0][1] + points[1][1]) / 2] : points[0];
  }
  at([x, y]) {
    return [(x - this.origin[0]) * this.scale, (y - this.origin[1]) * this.scale];
  }

  /** @param {Object} shown {bodies: [{key, label, place}], arrows: [{key, from, vector, unit, kind, drag}], circles: [{centre, radius, kind}]} */
  draw(shown) {
    const places = shown.bodies.map((b) => b.place);
    this.fit([...places, ...shown.circles.map((c) => [c.centre[0] + c.radius, c.centre[1]])]);
    const old = document.activeElement && document.activeElement.dataset ? document.activeElement.dataset.key : null;
    const parts = [];
    for (const { centre, radius, kind } of shown.circles) {
      const [x, y] = this.at(centre);
      parts.push(tpsLive.svg('circle', { cx: x, cy: y, r: radius * this.scale, class: `tps-circle tps-${kind}` }));
    }
    for (const b of shown.bodies) {
      const [x, y] = this.at(b.place);
      parts.push(this.handle(b.key, tpsLive.svg('circle', { cx: x, cy: y, r: 0.3, class: `tps-body tps-${b.label}` }), b.place, 1 / this.scale, b.name));
      parts.push(tpsLive.svg('text', { x, y: -y + 0.12, transform: 'scale(1,-1)', class: 'tps-label' }, b.label));
    }
    for (const a of shown.arrows) {
      const [x, y] = this.at(a.from);
      const tip = [x + a.vector[0] * a.unit, y + a.vector[1] * a.unit];
      if (Math.hypot(...a.vector) * a.unit > 0.02)
        parts.push(tpsLive.svg('line', { x1: x, y1: y, x2: tip[0], y2: tip[1], class: `tps-arrow tps-${a.kind}`, 'marker-end': `url(#tps-${a.kind})` }));
      if (a.key) parts.push(this.handle(a.key, tpsLive.svg('circle', { cx: tip[0], cy: tip[1], r: 0.2, class: 'tps-tip' }), a.vector, 1 / a.unit, a.name));
    }
    this.layer.replaceChildren(...parts);
    if (old && this.handles.get(old)) this.handles.get(old).focus();
  }

  handle(key, element, value, unit, name) {
    element.dataset.key = key;
    element.setAttribute('tabindex', '0');
    element.setAttribute('role', 'slider');
    element.setAttribute('aria-label', name);
    element.setAttribute('aria-valuetext', value.join(', '));
    element.setAttribute('aria-valuenow', '0');
    const move = (dx, dy) => this.changed(key, [value[0] + dx * unit, value[1] + dy * unit]);
    element.addEventListener('pointerdown', (event) => {
      event.preventDefault();
      const start = this.toPlane(event);
      this.dragging = true;
      const follow = (e) => { const now = this.toPlane(e); move(now[0] - start[0], now[1] - start[1]); };
      const stop = () => {
        this.dragging = false;
        window.removeEventListener('pointermove', follow);
        window.removeEventListener('pointerup', stop);
      };
      window.addEventListener('pointermove', follow);
      window.addEventListener('pointerup', stop);
    });
    element.addEventListener('keydown', (event) => {
      const step = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1] }[event.key];
      if (!step) return;
      event.preventDefault();
      move(...step);
    });
    this.handles.set(key, element);
    return element;
  }

  toPlane(event) {
    const matrix = this.layer.getScreenCTM().inverse();
    const point = new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix);
    return [point.x, point.y];
  }
};

tpsLive.arrowHeads = () => tpsLive.svg('defs', {}, ...['velocity', 'after', 'impulse', 'axis'].map((kind) => tpsLive.svg('marker', { id: `tps-${kind}`, viewBox: '0 0 10 10', refX: 8, refY: 5, markerWidth: 5, markerHeight: 5, orient: 'auto-start-reverse' },
  tpsLive.svg('path', { d: 'M0 0L10 5L0 10z', class: `tps-head tps-${kind}` }))));
