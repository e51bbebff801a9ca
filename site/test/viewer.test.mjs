// The page of a trace in a browser: opens where the check says, steps exactly, by keyboard alone, whatever names are in it.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { launch, open } from './browser.mjs';
import { root } from './reference.mjs';

const tps = path.join(root, 'build/release/tps');
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'tps-viewer-'));
let browser;
before(async () => { browser = await launch(); });
after(async () => { await browser.close(); fs.rmSync(folder, { recursive: true }); });

const file = (name) => path.join(folder, name);
function run(...words) {
  return spawnSync(tps, words, { encoding: 'utf8', maxBuffer: 1 << 28 });
}
function traceOf(scene, ...options) {
  const trace = file(`${path.basename(scene)}.ndjson`);
  const done = run('run', scene, '-q', '-o', trace, ...options);
  assert.ok(done.status === 0 || done.status === 6, done.stderr);
  return trace;
}
const sceneOf = (name) => path.join(root, 'data/scenes', `${name}.json`);

/** Whether anything but paper is in the picture. */
const coloured = (page) => page.evaluate(() => {
  const canvas = document.querySelector('#picture canvas');
  const flat = document.createElement('canvas');
  Object.assign(flat, { width: canvas.width, height: canvas.height });
  const context = flat.getContext('2d');
  context.drawImage(canvas, 0, 0);
  const { data } = context.getImageData(0, 0, flat.width, flat.height);
  let count = 0;
  for (let k = 0; k < data.length; k += 4) if (Math.max(data[k], data[k + 1], data[k + 2]) - Math.min(data[k], data[k + 1], data[k + 2]) > 60) count++;
  return count / (data.length / 4);
});

for (const name of ['terminal', 'sheet', 'three-body-grouped', 'ring', 'sediment', 'gas-walls']) {
  test(`${name}: particles are where the trace has them at each event`, async () => {
    const trace = traceOf(sceneOf(name), '--max-events', '300');
    assert.equal(run('view', trace, '-q', '-o', file('page.html')).status, 0);
    const { page, wrong } = await open(browser, file('page.html'));
    const events = fs.readFileSync(trace, 'utf8').split('\n').filter((l) => l.startsWith('{"k"')).map((l) => JSON.parse(l));
    const asked = events.map((e) => Object.entries(e.post ?? {}).map(([id, state]) => [Number(id), state]));
    const seen = await page.evaluate((all) => all.map((particles, n) => {
      TPS.page.goToEvent(n);
      return particles.map(([id]) => { const p = TPS.page.motion.indexOf.get(id); return [TPS.page.motion.place(p).map(TPS.hex), TPS.page.motion.velocity(p).map(TPS.hex)]; });
    }), asked);
    asked.forEach((particles, n) => particles.forEach(([id, state], k) => {
      assert.deepEqual(seen[n][k], [state.position, state.velocity], `event ${n + 1}, particle ${id}`);
    }));
    assert.ok(await coloured(page) > 0.003, 'an empty picture');
    assert.deepEqual(wrong, []);
    await page.close();
  });
}

test('a broken trace opens at the first event that tps check names', async () => {
  const lines = fs.readFileSync(traceOf(sceneOf('three-body')), 'utf8').split('\n');
  lines[20] = lines[20].replace('"dp":["-', '"dp":["').replace(/"dp":\["(?=0x)/, '"dp":["');
  fs.writeFileSync(file('broken.ndjson'), lines.join('\n'));
  const check = run('check', file('broken.ndjson'), '-q', '--format', 'json', '--view', file('broken.html'));
  assert.equal(check.status, 1);
  const first = JSON.parse(check.stdout).findings[0];
  const { page, wrong } = await open(browser, file('broken.html'));
  assert.match(await page.locator('#clock').textContent(), new RegExp(`event ${first.event} of 70`));
  assert.ok((await page.locator('#findings button').first().textContent()).includes(first.message));
  assert.deepEqual((await page.locator('#labels span').allTextContents()).sort(), ['Δp expected', 'Δp found']);
  assert.deepEqual(wrong, []);
  await page.close();
});

test('by keyboard alone: play, pause, step, ends, list', async () => {
  assert.equal(run('view', sceneOf('three-body'), '-q', '-o', file('keys.html')).status, 0);
  const { page } = await open(browser, file('keys.html'));
  const now = () => page.evaluate(() => TPS.page.motion.n);
  for (const [key, n] of [['ArrowRight', 1], ['ArrowRight', 2], ['ArrowLeft', 1], ['End', 70], ['Home', 0]]) {
    await page.keyboard.press(key);
    assert.equal(await now(), n, key);
  }
  await page.keyboard.press('Space');
  // Not waitForFunction: it evaluates text, which the page's policy forbids.
  while (await page.evaluate(() => TPS.page.motion.t) <= 0.01) await page.waitForTimeout(20);
  await page.keyboard.press('Space');
  const t = await page.evaluate(() => TPS.page.motion.t);
  await page.waitForTimeout(200);
  assert.equal(await page.evaluate(() => TPS.page.motion.t), t);
  await page.locator('#list').focus();
  await page.keyboard.press('ArrowDown');
  assert.equal(await now(), 1);
  await page.fill('#go_k', '35');
  await page.keyboard.press('Enter');
  assert.equal(await now(), 35);
  await page.close();
});

test('a place that is not there is refused in words', async () => {
  assert.equal(run('view', sceneOf('three-body'), '-q', '-o', file('places.html')).status, 0);
  const { page, wrong } = await open(browser, file('places.html'));
  const end = await page.evaluate(() => TPS.page.motion.tEnd);
  for (const [field, text, range] of [['go_k', 'abc', '0 to 70'], ['go_k', '999999', '0 to 70'], ['go_k', '-1', '0 to 70'], ['go_t', '1e9', `0 to ${end}`], ['go_t', 'x', `0 to ${end}`]]) {
    await page.evaluate(() => TPS.page.goToEvent(3));
    await page.fill(`#${field}`, text);
    await page.keyboard.press('Enter');
    const says = await page.locator(`#${field}`).evaluate((input) => input.validationMessage);
    assert.ok(says.startsWith(text) && says.endsWith(range), says);
    assert.equal(await page.evaluate(() => TPS.page.motion.n), 4);
  }
  await page.fill('#go_k', '12');
  await page.keyboard.press('Enter');
  assert.equal(await page.locator('#go_k').evaluate((input) => input.validationMessage), '');
  assert.equal(await page.evaluate(() => TPS.page.motion.n), 12);
  assert.deepEqual(wrong, []);
  await page.close();
});

test('events that form or break a tether can be picked out', async () => {
  const trace = traceOf(sceneOf('terminal-action-potential'), '--max-events', '3000');
  assert.equal(run('view', trace, '-q', '-o', file('tethers.html')).status, 0);
  const { page, wrong } = await open(browser, file('tethers.html'));
  const events = fs.readFileSync(trace, 'utf8').split('\n').filter((l) => l.startsWith('{"k"')).map((l) => JSON.parse(l));
  const counts = { formed: events.filter((e) => e.tether === 'formed').length, broken: events.filter((e) => e.tether === 'broken').length };
  let shown = 0;
  for (const [name, count] of Object.entries(counts)) {
    assert.ok(count > 0, `no tether is ${name}`);
    await page.getByLabel(`only tether ${name} ${count}`).check();
    assert.equal(await page.locator('#list_count').textContent(), `${shown += count} of ${events.length}`);
  }
  for (const [name, count] of Object.entries(counts)) await page.getByLabel(`only tether ${name} ${count}`).uncheck();
  assert.equal(await page.locator('#list_count').textContent(), `${events.length} of ${events.length}`);
  assert.deepEqual(wrong, []);
  await page.close();
});

test('a click selects the particle that is seen there', async () => {
  assert.equal(run('view', sceneOf('cradle'), '-q', '-o', file('click.html')).status, 0);
  const { page } = await open(browser, file('click.html'));
  const { x, y } = await page.evaluate(() => TPS.page.picture.project(TPS.page.motion.place(2)));
  const box = await page.locator('#picture').boundingBox();
  await page.mouse.click(box.x + x, box.y + y);
  await page.locator('#particle dd').first().waitFor();
  assert.match(await page.locator('#particle').textContent(), /^id2species/);
  await page.close();
});

test('the place in the run is dragged, and particles go along; the picture turns by dragging and grows by the wheel', async () => {
  assert.equal(run('view', sceneOf('cradle'), '-q', '-o', file('drag.html')).status, 0);
  const { page, wrong } = await open(browser, file('drag.html'));
  const scrub = await page.locator('#scrub').boundingBox();
  const y = scrub.y + scrub.height / 2, at = (share) => scrub.x + 8 + share * (scrub.width - 16);  // the middle of the thumb goes from 8 to 8 pixels before the end
  await page.mouse.move(at(0), y);
  await page.mouse.down();
  const seen = [];
  for (const share of [0.25, 0.5, 0.75]) {
    await page.mouse.move(at(share), y, { steps: 3 });
    seen.push(await page.evaluate(() => {
      const { motion } = TPS.page;
      return { share: motion.t / motion.tEnd, events: motion.n, due: motion.eventsUntil(motion.t), clock: document.getElementById('clock').textContent, place: motion.place(0)[0] };
    }));
  }
  await page.mouse.up();
  seen.forEach((one, k) => {
    assert.ok(Math.abs(one.share - (k + 1) / 4) < 0.02, JSON.stringify(seen));
    assert.equal(one.events, one.due, 'the events are those until the time');
  });
  assert.equal(new Set(seen.map((one) => one.clock)).size, 3);
  const after = await page.evaluate(() => TPS.page.motion.t);
  await page.mouse.move(at(0.1), y);
  assert.equal(await page.evaluate(() => TPS.page.motion.t), after, 'it goes on though the button is up');

  const view = () => page.evaluate(() => ({ zoom: TPS.page.picture.zoom, offset: { ...TPS.page.picture.offset }, seen: TPS.page.picture.project(TPS.page.motion.place(0)) }));
  const picture = await page.locator('#picture').boundingBox();
  const before = await view();
  await page.mouse.move(picture.x + 200, picture.y + 200);
  await page.mouse.down();
  await page.mouse.move(picture.x + 260, picture.y + 230, { steps: 4 });
  await page.mouse.up();
  const dragged = await view();
  assert.ok(Math.hypot(dragged.seen.x - before.seen.x, dragged.seen.y - before.seen.y) > 5, JSON.stringify([before, dragged]));
  await page.mouse.wheel(0, -300);
  await page.waitForTimeout(100);
  assert.ok((await view()).zoom > dragged.zoom, 'the wheel magnifies');
  assert.deepEqual(wrong, []);
  await page.close();
});

test('a film is an archive of pictures that differ', async () => {
  assert.equal(run('view', sceneOf('chain'), '-q', '-o', file('film.html')).status, 0);
  const { page, wrong } = await open(browser, file('film.html'));
  await page.fill('#frames', '5');
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('#film')]);
  await download.saveAs(file('frames.tar'));
  assert.equal(spawnSync('tar', ['-xf', 'frames.tar'], { cwd: folder }).status, 0);
  const frames = fs.readdirSync(folder).filter((name) => name.startsWith('frame-'));
  assert.deepEqual(frames, ['00000', '00001', '00002', '00003', '00004'].map((n) => `frame-${n}.png`));
  const pictures = frames.map((name) => fs.readFileSync(file(name)).toString('base64'));
  assert.ok(pictures.every((text) => text.startsWith('iVBORw0KGgo')));
  assert.equal(new Set(pictures).size, 5);
  assert.deepEqual(wrong, []);
  await page.close();
});

test('hostile names are shown and do nothing', async () => {
  const scene = JSON.parse(fs.readFileSync(sceneOf('pair'), 'utf8'));
  const hostile = '</script><script>window.hacked=1</script><img src=x onerror="window.hacked=2">';
  scene.title = hostile;
  const old = Object.keys(scene.species)[0];
  const text = JSON.stringify(scene).replaceAll(`"${old}"`, JSON.stringify(hostile));
  fs.writeFileSync(file('hostile.json'), text);
  assert.equal(run('view', file('hostile.json'), '-q', '-o', file('hostile.html')).status, 0);
  const { page, wrong } = await open(browser, file('hostile.html'));
  assert.equal(await page.locator('#title').textContent(), hostile);
  assert.equal(await page.evaluate(() => window.hacked), undefined);
  assert.equal(await page.locator('img').count(), 0);
  // And what got in by another way would not run.
  await page.evaluate(() => document.body.insertAdjacentHTML('beforeend', '<img src="data:," onerror="window.hacked=3">'));
  await page.waitForTimeout(100);
  assert.equal(await page.evaluate(() => window.hacked), undefined);
  assert.ok(wrong.every((w) => /Content Security Policy/.test(w)), wrong.join('\n'));
  await page.close();
});

test('10,000 particles: what a frame costs', async () => {
  assert.equal(run('scene', 'gas', '--particles', '10000', '--duration', '0.2', '-o', file('gas.json')).status, 0);
  assert.equal(run('view', file('gas.json'), '-q', '-o', file('gas.html')).status, 0);
  const { page, wrong } = await open(browser, file('gas.html'));
  const cost = await page.evaluate(() => {
    const { motion, picture, marks } = TPS.page;
    const times = [];
    for (let k = 0; k < 40; k++) {
      const start = performance.now();
      const t = motion.tEnd * k / 40;
      motion.go(motion.eventsUntil(t), t);
      picture.draw(marks());
      times.push(performance.now() - start);
    }
    return times.sort((a, b) => a - b)[20];
  });
  // Without the work of the graphics card, which here is software.
  console.log(`10,000 particles: ${cost.toFixed(1)} ms a frame on the processor`);
  assert.ok(cost < 1000 / 30, `${cost} ms`);
  assert.deepEqual(wrong, []);
  await page.close();
});
