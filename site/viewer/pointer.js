// Turning, moving and magnifying the picture, by mouse, finger and keys.
'use strict';

/** Calls `changed` after each change of the view, `clicked(x, y)` for a click that was no drag. */
TPS.followPointer = function (picture, changed, clicked) {
  const { element } = picture;
  const down = new Map();
  let moved = 0, spread = 0;
  const place = (event) => {
    const box = element.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  };
  const shift = (dx, dy) => {
    picture.offset.x -= dx * picture.pixel;
    picture.offset.y += dy * picture.pixel;
  };
  const rotate = (dx, dy) => {
    const axis = new THREE.Vector3(dy, dx, 0);
    const angle = axis.length() * 0.008;
    if (angle > 0) picture.turn.premultiply(new THREE.Quaternion().setFromAxisAngle(axis.normalize(), angle));
  };
  /** The point under the pointer stays there. */
  const magnify = (factor, at) => {
    const dx = at.x - picture.width / 2, dy = at.y - picture.height / 2;
    picture.zoom *= factor;
    picture.offset.x += dx * picture.pixel * (1 - 1 / factor);
    picture.offset.y -= dy * picture.pixel * (1 - 1 / factor);
    picture.aim();
  };
  element.addEventListener('pointerdown', (event) => {
    element.setPointerCapture(event.pointerId);
    down.set(event.pointerId, place(event));
    if (down.size === 1) moved = 0;
    spread = 0;
  });
  element.addEventListener('pointermove', (event) => {
    if (!down.has(event.pointerId)) return;
    const before = down.get(event.pointerId), now = place(event);
    down.set(event.pointerId, now);
    const dx = now.x - before.x, dy = now.y - before.y;
    moved += Math.abs(dx) + Math.abs(dy);
    if (down.size === 2) {
      const [a, b] = [...down.values()];
      const apart = Math.hypot(a.x - b.x, a.y - b.y);
      if (spread > 0) magnify(apart / spread, { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 });
      spread = apart;
      shift(dx / 2, dy / 2);
    } else if (picture.motion.dimension === 2 || event.shiftKey || event.buttons === 2 || event.buttons === 4) {
      shift(dx, dy);
    } else {
      rotate(dx, dy);
    }
    changed();
  });
  const up = (event) => {
    if (!down.delete(event.pointerId)) return;
    const at = place(event);
    if (event.type === 'pointerup' && moved < 4 && down.size === 0) clicked(at.x, at.y);
  };
  element.addEventListener('pointerup', up);
  element.addEventListener('pointercancel', up);
  element.addEventListener('contextmenu', (event) => event.preventDefault());
  element.addEventListener('wheel', (event) => {
    event.preventDefault();
    magnify(Math.exp(-event.deltaY * 0.0015), place(event));
    changed();
  }, { passive: false });
  element.addEventListener('keydown', (event) => {
    const turns = { w: [0, -12], a: [-12, 0], s: [0, 12], d: [12, 0] }[event.key];
    if (turns) (picture.motion.dimension === 3 ? rotate : shift)(...turns);
    else if (event.key === '+' || event.key === '=') magnify(1.15, { x: picture.width / 2, y: picture.height / 2 });
    else if (event.key === '-') magnify(1 / 1.15, { x: picture.width / 2, y: picture.height / 2 });
    else return;
    event.preventDefault();
    changed();
  });
};
