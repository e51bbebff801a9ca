// The page: one place (n events, time t) that everything shows, and what moves it.
'use strict';

(function () {
  const data = TPS.read();
  const { what } = data;
  const $ = (id) => document.getElementById(id);
  const motion = new TPS.Motion(data);
  const findings = what.findings.map((finding) => ({ ...finding, place: placeOf(finding) }));
  const found = new Set(findings.filter((f) => f.place > 0).map((f) => f.place - 1));

  /** How many events have happened where a finding is: the one it is about included. */
  function placeOf(finding) {
    const lines = data.columns.event_line;
    let low = 0, high = lines.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (lines[middle] < finding.line) low = middle + 1; else high = middle;
    }
    return Math.min(lines.length, low + 1);
  }

  document.title = what.title;
  $('title').textContent = what.title;
  $('subtitle').textContent = `${motion.count} particles, ${what.all_events} events, ${what.scalar}, ${what.timing}` +
    (what.end ? `, end: ${what.end.replace(/_/g, ' ')}` : '');
  for (const note of what.notes) {
    const item = document.createElement('li');
    item.textContent = note;
    $('notes').append(item);
  }

  let picture = null;
  try {
    picture = new TPS.Picture($('picture'), motion);
  } catch (error) {
    const text = document.createElement('p');
    text.id = 'nogl';
    text.textContent = `No picture: ${error.message}. Lists and numbers are here all the same.`;
    $('picture').append(text);
  }
  const axis = new TPS.Axis(motion);
  const timeline = new TPS.Timeline($('density'), axis, motion, findings);
  const inspector = new TPS.Inspector(motion, findings, select, (e, n) => {
    chosenFinding = n;
    goToEvent(e);
  });
  const list = new TPS.List(motion, found, (e) => goToEvent(e));
  const largest = { dp: largestOf(data.columns.event_dp), velocity: largestOf(data.columns.change_velocity, data.columns.particle_velocity) };
  let chosenFinding = -1, playing = false, before = 0, dirty = true;

  function largestOf(...columns) {
    let most = 0;
    const D = motion.dimension;
    for (const column of columns) {
      for (let k = 0; k < column.length; k += D) most = Math.max(most, Math.hypot(...column.subarray(k, k + D)));
    }
    return most || 1;
  }

  /** Of several findings at an event the one that was asked for, or the first. */
  function findingAt(e) {
    if (chosenFinding >= 0 && findings[chosenFinding].place - 1 === e) return findings[chosenFinding];
    return findings.find((f) => f.place - 1 === e);
  }

  /** What stands out at the place shown: the last event, if the time is its own. */
  function marks() {
    const e = motion.n - 1;
    const here = e >= 0 && motion.t === data.columns.event_t[e];
    const result = { involved: new Set(), found: new Set(), arrows: [], fastest: largest.velocity };
    if (!here) return result;
    const event = motion.event(e);
    for (const p of [event.i, event.j]) if (p >= 0) result.involved.add(p);
    const finding = findingAt(e);
    const add = (particle, value, unit, colour, text, shift = 0) =>
      result.arrows.push({ particle, value, unit, colour, text, shift, width: colour === 'expected' ? 5 : 3, least: TPS.shortestArrow });
    const expected = finding ? finding.expected || [] : [];
    const compared = new Set(expected.map((x) => x.of));
    if (finding) for (const id of finding.particles) if (motion.indexOf.has(id)) result.found.add(motion.indexOf.get(id));
    if (event.dp && !compared.has('dp')) {
      const unit = TPS.longestArrow / largest.dp;
      add(event.i, event.dp, unit, 'event', 'Δp');
      if (event.j >= 0) add(event.j, event.dp.map((x) => -x), unit, 'event', '');
    }
    for (const { particle, of, value } of expected) {
      const right = value.slice(0, motion.dimension), wrong = of === 'dp' ? event.dp : motion.velocity(particle);
      const unit = TPS.longestArrow / Math.max(Math.hypot(...right), wrong ? Math.hypot(...wrong) : 0, Number.MIN_VALUE);
      const name = of === 'dp' ? 'Δp' : 'v';
      if (wrong) add(particle, wrong, unit, 'found', name + ' found', -1);
      add(particle, right, unit, 'expected', name + ' expected', 1);
    }
    return result;
  }

  function show() {
    dirty = false;
    const e = motion.n - 1;
    const seen = marks();
    if (picture && picture.width) {
      picture.draw(seen);
      label(seen.arrows);
    }
    const u = axis.of(motion.n, motion.t);
    timeline.draw(u);
    $('scrub').max = axis.length;
    $('scrub').value = u;
    $('clock').textContent = `t = ${TPS.short(motion.t)} of ${TPS.short(motion.tEnd)}, ` +
      (what.one_of > 1 ? `event ${e < 0 ? 0 : data.columns.event_k[e]} of ${what.all_events}` : `event ${motion.n} of ${motion.events}`);
    inspector.event(e);
    inspector.particle(picture ? picture.selected : selected);
    inspector.markFindings(findingAt(e));
    list.mark(e, true);
  }

  function label(arrows) {
    $('labels').replaceChildren(...arrows.filter((a) => a.text).map((a) => {
      const span = document.createElement('span');
      span.textContent = a.text;
      const from = TPS.pointIn(picture, motion.position.subarray(3 * a.particle, 3 * a.particle + 3));
      const tip = TPS.arrow([], picture, from, a.value, a.unit, null, 0, a.least, a.shift);
      if (!tip) return span;
      const seen = tip.applyQuaternion(picture.turn);
      span.className = a.shift < 0 ? 'below' : 'above';
      span.style.left = (seen.x - picture.camera.left) / picture.pixel + 'px';
      span.style.top = (picture.camera.top - seen.y) / picture.pixel + 'px';
      return span;
    }));
  }

  function go(n, t) {
    motion.go(n, t);
    dirty = true;
  }
  function goToEvent(e) {
    pause();
    go(e + 1, e < 0 ? 0 : data.columns.event_t[e]);
  }
  function goTo(u) {
    go(...axis.at(u));
  }
  let selected = -1;
  function select(p) {
    selected = p;
    if (picture) picture.selected = p;
    dirty = true;
  }
  function pause() {
    playing = false;
    $('play').textContent = 'play';
    $('play').setAttribute('aria-label', 'Play');
  }
  function play() {
    if (axis.of(motion.n, motion.t) >= axis.length) go(0, 0);
    playing = true;
    before = performance.now();
    $('play').textContent = 'pause';
    $('play').setAttribute('aria-label', 'Pause');
  }
  /** The whole run takes half a minute, an event half a second where the axis is events; the speed is a power of two of that. */
  function rate() {
    return 2 ** Number($('speed').value) * (axis.by === 'time' ? axis.length / 30 : 2);
  }

  function frame(now) {
    if (playing) {
      const u = axis.of(motion.n, motion.t) + rate() * (now - before) / 1000;
      before = now;
      if (u >= axis.length) {
        go(motion.events, motion.tEnd);
        pause();
      } else {
        goTo(u);
      }
    }
    if (dirty) show();
    requestAnimationFrame(frame);
  }

  const steps = {
    first: () => goToEvent(-1),
    previous: () => goToEvent(Math.max(-1, motion.n - 2)),
    next: () => (motion.n < motion.events ? goToEvent(motion.n) : (pause(), go(motion.events, motion.tEnd))),
    last: () => (pause(), go(motion.events, motion.tEnd)),
    play: () => (playing ? pause() : play()),
  };
  for (const [id, step] of Object.entries(steps)) $(id).addEventListener('click', step);
  $('scrub').addEventListener('input', () => (pause(), goTo(Number($('scrub').value))));
  $('density').addEventListener('pointerdown', (event) => (pause(), goTo(event.offsetX / $('density').clientWidth * axis.length)));
  $('axis').addEventListener('change', () => {
    axis.by = $('axis').value;
    timeline.count();
    dirty = true;
  });
  /** The number in a field; null, and said at the field, where it is none from low to high. */
  const asked = (field, low, high, what) => {
    const input = $(field), text = input.value.trim(), number = Number(text);
    const there = text !== '' && number >= low && number <= high;
    input.setCustomValidity(there || text === '' ? '' : `${text} is not here: ${what} go from ${low} to ${high}`);
    input.reportValidity();
    return there ? number : null;
  };
  $('go_k').addEventListener('change', () => {
    const numbers = data.columns.event_k, k = asked('go_k', 0, motion.events ? numbers[motion.events - 1] : 0, 'events');
    if (k !== null) goToEvent(k === 0 ? -1 : numbers.findIndex((x) => x >= k));
  });
  $('go_t').addEventListener('change', () => {
    const t = asked('go_t', 0, motion.tEnd, 'times');
    if (t !== null) pause(), go(motion.eventsUntil(t), t);
  });
  $('show_velocities').addEventListener('change', () => (picture && (picture.showVelocities = $('show_velocities').checked), dirty = true));
  $('show_only').addEventListener('change', () => (picture && (picture.showOnly = $('show_only').checked), dirty = true));
  $('show_containers').addEventListener('change', () => (picture && (picture.showContainers = $('show_containers').checked), dirty = true));
  $('reset').addEventListener('click', () => (picture && picture.resetView(), dirty = true));
  $('filter_particle').addEventListener('change', () => {
    const p = motion.indexOf.get(Number($('filter_particle').value));
    if (p !== undefined && $('filter_particle').value.trim() !== '') select(p);
  });
  $('save').addEventListener('click', () => picture && picture.renderer.domElement.toBlob((blob) => TPS.saveAs(blob, `event-${motion.n}.png`)));
  $('film').addEventListener('click', () => {
    if (!picture) return;
    pause();
    const count = Math.max(1, Math.min(5000, Math.round(Number($('frames').value)) || 1));
    TPS.film(picture, axis, count, (u) => (goTo(u), show()), (text) => ($('film_says').textContent = text));
  });
  document.addEventListener('keydown', (event) => {
    const inField = /^(INPUT|SELECT|TEXTAREA)$/.test(event.target.tagName) && event.target.type !== 'checkbox';
    if (inField && event.target.id !== 'scrub' || event.ctrlKey || event.altKey || event.metaKey) return;
    if (event.key === ' ' && event.target.tagName === 'BUTTON') return; // the button's own
    const step = { ' ': 'play', ArrowLeft: 'previous', ArrowRight: 'next', Home: 'first', End: 'last' }[event.key];
    if (!step) return;
    event.preventDefault();
    steps[step]();
  });

  if (picture) {
    TPS.followPointer(picture, () => (dirty = true), (x, y) => select(picture.at(x, y)));
    const key = $('key');
    what.species.forEach((species) => {
      const item = document.createElement('li'), swatch = document.createElement('i');
      swatch.style.background = species.colour;
      item.append(swatch, species.name);
      key.append(item);
    });
  }
  const resized = () => {
    if (picture) picture.resize();
    timeline.resize();
    dirty = true;
  };
  new ResizeObserver(resized).observe($('picture'));
  window.addEventListener('resize', resized);
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => (picture && picture.themeChanged(), dirty = true));
  resized();
  // #k=12 and #t=0.5 open at a place; a finding comes first.
  const place = new URLSearchParams(location.hash.slice(1));
  if (place.has('k')) goToEvent(data.columns.event_k.findIndex((k) => k >= Number(place.get('k'))));
  else if (place.has('t')) go(motion.eventsUntil(Number(place.get('t'))), Number(place.get('t')));
  else if (findings.length) goToEvent(findings[0].place - 1);
  else go(0, 0);
  TPS.page = { motion, picture, axis, goToEvent, select, findings, marks };
  show();
  requestAnimationFrame(frame);
})();
