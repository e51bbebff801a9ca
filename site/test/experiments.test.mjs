// The paper's experiments on the page give the paper's numbers, and those of the program.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { launch, open } from './browser.mjs';
import { root } from './reference.mjs';

const tps = path.join(root, 'build/release/tps');
let browser, page, wrong;
before(async () => {
  browser = await launch();
  ({ page, wrong } = await open(browser, path.join(root, 'build/site/experiments.html')));
});
after(() => browser.close());

/** Sets the sliders of an experiment and waits for what it then says. */
async function says(name, values, expected) {
  const place = page.locator(`[data-experiment=${name}]`);
  await place.scrollIntoViewIfNeeded();
  for (const [slider, value] of Object.entries(values)) {
    await place.locator(`input[name=${slider}]`).evaluate((input, v) => {
      input.value = v;
      input.dispatchEvent(new Event('input'));
    }, value);
  }
  await place.locator('.tps-says', { hasText: expected }).waitFor({ timeout: 60000 });
  return place;
}

test('X, Y and Z: 70 collisions, two when Y is as heavy, two when they are grouped, a stall with losses', async () => {
  const place = await says('three-body', {}, '70 collisions');
  await place.locator('.tps-says', { hasText: 'allows 70 at most' }).waitFor();
  await says('three-body', { mass: 0 }, /^2 collisions; end/);
  await says('three-body', { mass: -3, grouped: 0.0625 }, /^2 collisions; 2 restitutions/);
  await says('three-body', { grouped: 0, c: 0.8 }, 'stalled at t =');
});

test('what a run on the page finds is the trace of the program', async () => {
  const place = await says('three-body', { mass: -2, c: 1, grouped: 0 }, 'collisions; end');
  const here = await place.evaluate((e) => e.live.answer.trace);
  const run = spawnSync('sh', ['-c', `'${tps}' scene three-body --middle-mass 0.01 | '${tps}' run - -q -o - 2>/dev/null`], { encoding: 'utf8' });
  const events = (text) => text.split('\n').filter((l) => l.startsWith('{"k"'));
  assert.ok(events(here).length > 20);
  assert.deepEqual(events(here), events(run.stdout));
});

test("Galperin's billiard counts digits of π", async () => {
  for (const [digits, count] of [[0, 3], [1, 31], [2, 314], [3, 3141]]) await says('galperin', { digits }, `${count} collisions`);
});

test("the paper's revolution: 45°, 0.5, four collisions", async () => {
  await says('revolution', {}, 'after the 4 collisions of a whole turn it is 0.5 of what it was');
  await says('revolution', { theta: 30, c: 0.8 }, 'after the 6 collisions of a whole turn it is 0.8 of what it was');
  // A steep way leads through the inner distance: what happens there is drawn, too.
  const place = await says('revolution', { theta: 75, c: 0.8 }, 'rebounds between them');
  const [, revolutions, rebounds] = /^(\d+) revolutions drawn, and (\d+) rebounds/.exec(await place.locator('.tps-says').textContent());
  assert.equal(await place.locator('svg .tps-hit').count(), Number(revolutions) + Number(rebounds));
  assert.equal(await place.locator('svg .tps-circle').count(), 2);
});

test('grouping: two loads, then two restitutions from the root', async () => {
  const place = await says('grouping', {}, 'Before anything: 4 events follow');
  const step = place.getByRole('button', { name: 'step', exact: true });
  for (const expected of ['X meets Y; X, Y move together', 'Y meets Z; X, Y, Z move together', 'Y and Z part by', 'X and Y part by']) {
    await step.click();
    await place.locator('.tps-says', { hasText: expected }).waitFor();
  }
  const speeds = await place.locator('svg text').allTextContents();
  assert.ok(speeds.some((t) => t.startsWith('v_load')) && speeds.some((t) => t.startsWith('Δp_AB')), speeds.join());
  // No word leaves the picture or lies on another one, and on a telephone all can still be read.
  for (const width of [1200, 360]) {
    await page.setViewportSize({ width, height: 900 });
    const { frame, words } = await place.locator('svg').evaluate((svg) => ({ frame: svg.getBoundingClientRect().toJSON(), words: [...svg.querySelectorAll('text')].map((t) => ({ text: t.textContent, ...t.getBoundingClientRect().toJSON() })) }));
    for (const w of words) assert.ok(w.left >= frame.left && w.right <= frame.right && w.top >= frame.top && w.bottom <= frame.bottom, `${w.text} is cut off at ${width} px`);
    for (const [n, a] of words.entries()) for (const b of words.slice(n + 1)) assert.ok(a.right < b.left || b.right < a.left || a.bottom <= b.top + 2 || b.bottom <= a.top + 2, `${a.text} and ${b.text} overlap at ${width} px`);
    assert.ok(words.every((w) => w.height >= 7), `words of ${Math.min(...words.map((w) => w.height))} px at ${width} px`);
  }
  await page.setViewportSize({ width: 1200, height: 900 });
});

test('nothing was complained about', () => assert.deepEqual(wrong, []));
