// The picture: three.js draws what motion.js says. Lengths are scaled by the extent of the run before they become the
// graphics card's single floats.
'use strict';

TPS.Picture = class {
  constructor(element, motion) {
    this.element = element;
    this.motion = motion;
    this.selected = -1;
    this.showContainers = true;
    this.showVelocities = false;
    this.showOnly = false;
    const canvas = document.createElement('canvas');
    const context = canvas.getContext('webgl2', { antialias: true, preserveDrawingBuffer: true });
    if (!context) throw new Error('this browser has no WebGL 2, which the picture is drawn with');
    this.renderer = new THREE.WebGLRenderer({ canvas, context, antialias: true, preserveDrawingBuffer: true });
    element.append(canvas);
    this.scene = new THREE.Scene();
    this.camera = new THREE.OrthographicCamera(-1, 1, 1, -1, -20, 20);
    this.turn = new THREE.Quaternion();
    this.fit();
    this.colours = motion.what.species.map((s) => new THREE.Color(s.colour));
    this.containers = this.findContainers();
    this.build();
    this.resetView();
    this.themeChanged();
  }

  /** Species that hold others: the infinite partner of a permanent tether, as `tps draw` has it. */
  findContainers() {
    const { what, c, count } = this.motion;
    const holds = new Set();
    for (const pair of what.pairs) {
      if (!pair.permanent) continue;
      for (const s of pair.species) if (what.species[s].mass === 'inf' && what.species[s].radius >= pair.outer) holds.add(s);
    }
    const result = new Uint8Array(count);
    for (let p = 0; p < count; p++) result[p] = holds.has(c.particle_species[p]) ? 1 : 0;
    return result;
  }

  /** Middle and half extent of everything that ever is. */
  fit() {
    const { c, dimension: D, count, what } = this.motion;
    const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
    const take = (x, base, r) => {
      for (let d = 0; d < D; d++) {
        low[d] = Math.min(low[d], x[base + d] - r);
        high[d] = Math.max(high[d], x[base + d] + r);
      }
    };
    const radius = (p) => what.species[c.particle_species[p]].radius;
    for (let p = 0; p < count; p++) take(c.particle_position, p * D, radius(p));
    for (let k = 0; k < c.change_t.length; k++) take(c.change_position, k * D, radius(c.change_particle[k]));
    this.middle = [0, 1, 2].map((d) => (d < D ? low[d] / 2 + high[d] / 2 : 0));
    this.extent = Math.max(...[0, 1, 2].map((d) => (d < D ? high[d] / 2 - low[d] / 2 : 0)), Number.MIN_VALUE);
  }
  scaled(x, d) {
    return (x - this.middle[d]) / this.extent;
  }

  quads(capacity, attributes, shader, uniforms, options) {
    const geometry = new THREE.InstancedBufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(new Float32Array([-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0]), 3));
    geometry.setIndex([0, 1, 2, 0, 2, 3]);
    for (const [name, size] of Object.entries(attributes)) {
      const attribute = new THREE.InstancedBufferAttribute(new Float32Array(capacity * size), size);
      attribute.setUsage ? attribute.setUsage(THREE.DynamicDrawUsage) : attribute.setDynamic(true);
      geometry.setAttribute(name, attribute);
    }
    const material = new THREE.ShaderMaterial({ ...shader, uniforms, ...options });
    const mesh = new THREE.Mesh(geometry, material);
    mesh.frustumCulled = false;
    this.scene.add(mesh);
    return mesh;
  }

  build() {
    const { c, count, what } = this.motion;
    const shared = { pixel: { value: 0.01 }, flatness: { value: this.motion.dimension === 2 ? 1 : 0 },
      paper: { value: new THREE.Color() }, ink: { value: new THREE.Color() }, depths: { value: new THREE.Vector2(-1, 1) } };
    this.uniforms = shared;
    const ball = { centre: 3, radius: 1, colour: 3, rim: 4 };
    this.balls = this.quads(count, ball, TPS.sphereShader, shared, { extensions: { fragDepth: true } });
    this.holders = this.quads(count, ball, TPS.enclosureShader, shared, { transparent: true, depthWrite: false, depthTest: false });
    this.holders.renderOrder = -1;
    this.radius = new Float32Array(count);
    for (let p = 0; p < count; p++) this.radius[p] = what.species[c.particle_species[p]].radius / this.extent;
  }

  /** Tethers are among the particles, arrows and paths before them. */
  drawLines(name, lines, options) {
    let drawn = this[name];
    if (!drawn || drawn.capacity < lines.length) {
      if (drawn) {
        this.scene.remove(drawn.mesh);
        drawn.mesh.geometry.dispose();
      }
      const capacity = Math.max(64, 2 * lines.length);
      const mesh = this.quads(capacity, { from: 3, to: 3, colour: 3, width: 1 }, TPS.lineShader, this.uniforms, options);
      mesh.renderOrder = options.depthTest ? 1 : 2;
      drawn = this[name] = { mesh, capacity };
    }
    const { from, to, colour, width } = drawn.mesh.geometry.attributes;
    lines.forEach((l, n) => {
      from.setXYZ(n, ...l.from);
      to.setXYZ(n, ...l.to);
      colour.setXYZ(n, l.colour.r, l.colour.g, l.colour.b);
      width.setX(n, l.width);
    });
    for (const a of [from, to, colour, width]) a.needsUpdate = true;
    drawn.mesh.geometry.maxInstancedCount = lines.length;
    drawn.mesh.visible = lines.length > 0;
  }

  resetView() {
    this.zoom = 1;
    this.offset = new THREE.Vector2(0, 0);
    this.turn.set(0, 0, 0, 1);
  }

  themeChanged() {
    const style = getComputedStyle(document.documentElement);
    this.uniforms.paper.value.set(style.getPropertyValue('--paper').trim());
    this.uniforms.ink.value.set(style.getPropertyValue('--ink').trim());
    this.renderer.setClearColor(this.uniforms.paper.value, 1);
  }

  resize() {
    const { clientWidth: w, clientHeight: h } = this.element;
    if (w === 0 || h === 0) return;
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
    this.renderer.setSize(w, h);
    this.width = w;
    this.height = h;
  }

  aim() {
    const half = 1.08 / this.zoom;
    const scale = half / Math.min(this.width, this.height);
    this.pixel = 2 * scale;
    const { x, y } = this.offset;
    Object.assign(this.camera, { left: x - this.width * scale, right: x + this.width * scale, top: y + this.height * scale,
      bottom: y - this.height * scale });
    this.camera.updateProjectionMatrix();
    this.scene.quaternion.copy(this.turn);
    this.scene.updateMatrixWorld(true);
    this.uniforms.pixel.value = this.pixel;
  }

  /** Where a point of the run is in the picture, in pixels, and its depth. */
  project(point) {
    const v = new THREE.Vector3(...[0, 1, 2].map((d) => this.scaled(point[d] || 0, d))).applyQuaternion(this.turn);
    return { x: (v.x - this.camera.left) / this.pixel, y: (this.camera.top - v.y) / this.pixel, depth: v.z };
  }

  /** The particle that is seen at a pixel, −1: none. */
  at(x, y) {
    let best = -1, nearest = -Infinity;
    for (let p = 0; p < this.motion.count; p++) {
      if (this.containers[p]) continue;
      const seen = this.project(this.motion.position.subarray(3 * p, 3 * p + 3));
      const reach = Math.max(this.radius[p] / this.pixel, 6);
      if (Math.hypot(seen.x - x, seen.y - y) <= reach && seen.depth + this.radius[p] > nearest) {
        nearest = seen.depth + this.radius[p];
        best = p;
      }
    }
    return best;
  }

  draw(marks) {
    this.aim();
    this.drawBalls(marks);
    this.drawLines('wallLines', TPS.wallLines(this), { depthTest: this.motion.dimension === 3 });
    this.drawLines('tetherLines', TPS.tetherLines(this, marks), { depthTest: this.motion.dimension === 3 });
    this.drawLines('arrowLines', TPS.arrowLines(this, marks), { depthTest: false });
    this.renderer.render(this.scene, this.camera);
  }

  drawBalls(marks) {
    const { motion } = this;
    const fill = { balls: 0, holders: 0 };
    let near = -1e9, far = 1e9;
    const row = new THREE.Vector3(0, 0, 1).applyQuaternion(this.turn.clone().inverse());
    for (let p = 0; p < motion.count; p++) {
      const which = this.containers[p] ? 'holders' : 'balls';
      if (which === 'holders' ? !this.showContainers : this.showOnly && !this.concerned(p, marks)) continue;
      const n = fill[which]++;
      const { centre, radius, colour, rim } = this[which].geometry.attributes;
      const x = this.scaled(motion.position[3 * p], 0), y = this.scaled(motion.position[3 * p + 1], 1),
        z = motion.dimension === 3 ? this.scaled(motion.position[3 * p + 2], 2) : 0;
      centre.setXYZ(n, x, y, z);
      radius.setX(n, this.radius[p]);
      const c = this.colours[motion.c.particle_species[p]];
      colour.setXYZ(n, c.r, c.g, c.b);
      const edge = this.edgeOf(p, marks);
      if (edge) rim.setXYZW(n, edge.colour.r, edge.colour.g, edge.colour.b, edge.width);
      else rim.setXYZW(n, c.r * 0.5, c.g * 0.5, c.b * 0.5, 0.06);
      if (which === 'balls') {
        const depth = row.x * x + row.y * y + row.z * z;
        near = Math.max(near, depth);
        far = Math.min(far, depth);
      }
    }
    this.uniforms.depths.value.set(far, near);
    for (const which of ['balls', 'holders']) {
      this[which].geometry.maxInstancedCount = fill[which];
      this[which].visible = fill[which] > 0;
      for (const name of ['centre', 'radius', 'colour', 'rim']) this[which].geometry.attributes[name].needsUpdate = true;
    }
  }

  concerned(p, marks) {
    return p === this.selected || marks.found.has(p) || marks.involved.has(p) || this.motion.body(p) >= 0;
  }

  /** The rim of a particle that stands out: selected, in a finding, in the event, loaded. */
  edgeOf(p, marks) {
    if (p === this.selected) return { colour: this.uniforms.ink.value, width: 0.28 };
    if (marks.found.has(p)) return { colour: TPS.colour.wrong, width: 0.16 };
    const body = this.motion.body(p);
    if (body >= 0) return { colour: TPS.colour.bodies[body % TPS.colour.bodies.length], width: 0.34 };
    return marks.involved.has(p) ? { colour: TPS.colour.event, width: 0.22 } : null;
  }
};
