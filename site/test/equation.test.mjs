// The figures of the equations say what the program says.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { launch, open } from './browser.mjs';
import { root } from './reference.mjs';

const site = path.join(root, 'build/site');
const tps = path.join(root, 'build/release/tps');
let browser;
before(async () => { browser = await launch(); });
after(() => browser.close());

const ready = (page) => page.waitForSelector('.tps-answers tr.tps-result', { timeout: 60000 });

/** What the page shows, as bits by key; and the command that it offers. */
const shown = (page) => page.evaluate(() => {
  const { live } = document.querySelector('.tps-equation');
  return { command: live.command(), values: Object.fromEntries([...live.report.steps, ...live.report.results].map((q) => [q.key, q.word || (q.vector ? q.hex : q.hex[0] ?? null)])),
    table: [...document.querySelectorAll('.tps-answers tr[data-quantity]')].map((tr) => [tr.dataset.quantity, tr.cells[3].textContent]) };
});

function agrees({ command, values, table }) {
  const run = spawnSync(tps, [...command.split(' ').slice(1), '--format', 'json'], { encoding: 'utf8' });
  assert.equal(run.status, 0, run.stderr);
  const native = JSON.parse(run.stdout);
  assert.deepEqual(values, { ...native.steps, ...native.out }, command);
  for (const [key, text] of table) assert.equal(text, [].concat(values[key]).filter((x) => /^-?0x|inf/.test(x ?? '')).join(' '), key);
}

for (const name of ['eq1', 'eq2', 'eq3', 'eq4', 'eq5', 'eq6', 'eq7']) {
  test(`${name}: dragging changes the values to those of tps eval`, async () => {
    const { page, wrong } = await open(browser, path.join(site, `${name}.html`));
    await ready(page);
    const at = await shown(page);
    agrees(at);
    const tip = page.locator('.tps-figure .tps-tip').last();
    await tip.scrollIntoViewIfNeeded();
    const box = await tip.boundingBox();
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await page.mouse.down();
    await page.mouse.move(box.x + 40, box.y - 25, { steps: 4 });
    await page.mouse.up();
    const then = await shown(page);
    assert.notEqual(then.command, at.command);
    agrees(then);
    assert.deepEqual(wrong, []);
    await page.close();
  });
}

test('by keyboard alone: a handle moves by the arrow keys, a number can be typed as a hexadecimal float', async () => {
  const { page } = await open(browser, path.join(site, 'eq2.html'));
  await ready(page);
  const at = await shown(page);
  await page.locator('[data-key=u_B]').focus();
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('ArrowUp');
  const then = await shown(page);
  assert.notEqual(then.command, at.command);
  agrees(then);
  await page.getByLabel('L', { exact: true }).fill('0x1.8p-1');
  agrees(await shown(page));
  await page.getByLabel('L', { exact: true }).fill('nonsense');
  assert.match(await page.locator('.tps-says.tps-error').textContent(), /hexadecimal/);
  await page.close();
});

test('hard cases are of every stratum that equations 2 to 5 have', async () => {
  const { page } = await open(browser, path.join(site, 'eq5.html'));
  await ready(page);
  const strata = await page.evaluate(() => Object.fromEntries(Object.entries(window.tpsCases).map(([op, cases]) => [op, [...new Set(cases.map((c) => c.id.split('.')[1]))]])));
  for (const op of ['block_time', 'tether_time', 'collision_impulse', 'tether_response', 'revolution_impulse']) {
    const files = fs.readdirSync(path.join(root, 'data/vectors')).filter((name) => name.startsWith(`${op}.`)).map((name) => name.split('.')[1]);
    assert.deepEqual(strata[op].sort(), files.filter((name) => name !== 'twins').sort(), op);
  }
  await page.close();
});

test('hard cases of every operation are answered, and laws are shown to hold', async () => {
  for (const name of ['eq2', 'eq3', 'eq4', 'eq5', 'eq6', 'eq7']) {
    const { page, wrong } = await open(browser, path.join(site, `${name}.html`));
    await ready(page);
    const broken = await page.evaluate(async () => {
      const { live } = document.querySelector('.tps-equation');
      const bad = [];
      for (const op of live.ops) {
        await live.choose(op);
        for (let n = 0; n < (window.tpsCases[op] || []).length; n++) {
          live.hardCase();
          await new Promise((resolve) => setTimeout(resolve));
          if (live.lawList.querySelector('.tps-broken')) bad.push(`${live.copied.textContent}: ${live.lawList.textContent}`);
          if (!live.report) bad.push(`${live.copied.textContent}: ${live.says.textContent}`);
        }
      }
      return bad;
    });
    assert.deepEqual(broken, []);
    assert.deepEqual(wrong, []);
    await page.close();
  }
});

test('laws are those that the present case can show, and one that breaks is shown', async () => {
  const { page, wrong } = await open(browser, path.join(site, 'eq2.html'));
  await ready(page);
  const laws = () => page.locator('.tps-equation ul li').allTextContents();
  const general = await laws();
  assert.ok(general.length >= 8 && general.some((l) => l.startsWith('a larger limit')) && general.some((l) => l.startsWith('turned by a quarter')), general.join('; '));
  assert.ok(!general.some((l) => l.startsWith('masses')), 'eq. (2) has no masses');
  await page.getByLabel('v_A, x').fill('-1');
  assert.ok(!(await laws()).some((l) => l.startsWith('a larger limit')), 'a pair that recedes has no hit to compare');
  // An answer with another last bit, or none, breaks every law that asks another question.
  const broken = await page.evaluate(async () => {
    const { live } = document.querySelector('.tps-equation');
    await live.choose('block_time');
    const values = live.values, honest = live.ask, answer = live.report;
    const flipped = (request) => { const other = honest(request); for (const q of other.results) q.hex = q.hex.map((x) => (x.startsWith('0x1.') ? x.replace(/.p/, (d) => (d === '1p' ? '3p' : '1p')) : x)); return other; };
    const silent = (request) => ({ ...honest(request), results: answer.results.map((q) => ({ ...q, hex: [], word: '' })) });
    const names = (ask) => tpsLive.judgeLaws('block_time', values, answer, (v) => ask({ do: 'eval', op: 'block_time', scalar: 'double', in: live.request(v) })).filter((l) => l.holds === false).length;
    return { honest: names(honest), flipped: names(flipped), silent: names(silent), all: tpsLive.judgeLaws('block_time', values, answer, () => answer).length };
  });
  assert.equal(broken.honest, 0);
  assert.equal(broken.flipped, broken.all - 2, 'all but the two that a bit in the last place does not touch');
  assert.equal(broken.silent, broken.all - 1, 'all but the one that looks at the present answer alone');
  await page.goto(`file://${path.join(site, 'eq3.html')}#op=apply_impulse&v_A=1,0.5&v_B=0.25,0&m_A=1&m_B=inf&dp=-1,0.5`);
  await page.reload();
  await ready(page);
  assert.ok((await laws()).some((l) => l.startsWith('an infinite mass')), (await laws()).join('; '));
  assert.deepEqual(wrong, []);
  await page.close();
});

test('what is copied as a known answer is one: tps vectors verify proves it', async () => {
  for (const name of ['eq2', 'eq3', 'eq4', 'eq5', 'eq6', 'eq7']) {
    const { page } = await open(browser, path.join(site, `${name}.html`));
    await ready(page);
    const copied = await page.evaluate(async () => {
      const { live } = document.querySelector('.tps-equation');
      const texts = [];
      live.copy = (text) => texts.push(text);
      for (const op of live.ops.filter((o) => o !== 'paper_time')) {
        for (let n = 0; n < 6; n++) {
          await live.choose(op);
          for (let k = 0; k < n; k++) { live.hardCase(); await new Promise((resolve) => setTimeout(resolve)); }
          [...document.querySelectorAll('.tps-equation button')].find((b) => b.textContent === 'copy as known answer').click();
        }
      }
      return texts;
    });
    assert.ok(copied.length >= 6, `${name}: ${copied.length}`);
    const run = spawnSync(tps, ['vectors', 'verify', '-'], { input: copied.join(''), encoding: 'utf8' });
    assert.equal(run.status, 0, run.stdout + run.stderr);
    const [header, text] = copied[0].split('\n');
    const known = JSON.parse(text);
    if (known.t) known.t = ['0x1p+100', '0x1p+100']; else Object.values(known.out)[0][0] = ['0x1p+100', '0x1p+100'];
    const forged = `${header}\n${JSON.stringify(known)}\n`;
    assert.equal(spawnSync(tps, ['vectors', 'verify', '-'], { input: forged, encoding: 'utf8' }).status, 1, 'a forged one passes');
    await page.close();
  }
});

test('responses are compared with certified enclosures', async () => {
  const { page } = await open(browser, path.join(site, 'eq5.html'));
  await ready(page);
  assert.match(await page.locator('.tps-says').first().textContent(), /^Against the certified enclosures: .*(nearest|ulp)/);
  const told = await page.evaluate(() => {
    const { live } = document.querySelector('.tps-equation');
    const honest = live.report.results.find((q) => q.key === 'dp').hex.slice();
    live.report.results.find((q) => q.key === 'dp').hex = honest.map((x) => (x.endsWith('p-1') || !x.includes('.') ? x : x.replace(/.p/, '5p')));
    return [live.verdictWords()[0], honest.join()];
  });
  assert.match(told[0], /\d+ ulp/, told.join(' '));
  await page.close();
});

test('the row of the decision table that applies is marked', async () => {
  const { page } = await open(browser, `${path.join(site, 'eq2.html')}#op=tether_time&u_A=0,0&u_B=1,0&v_A=0,0&v_B=1,0&L=1`);
  await ready(page);
  assert.deepEqual(await page.locator('tr.tps-here td').allTextContents(), ['c = 0, h ≥ 0', 'taut', '0']);
  await page.close();
});

test('a link restores the numbers', async () => {
  const { page } = await open(browser, `${path.join(site, 'eq4.html')}#op=collision_impulse&u_A=0,0&u_B=0x1p%2B0,0&v_A=2,0&v_B=0,0&m_A=1&m_B=inf&c=1`);
  await ready(page);
  const now = await shown(page);
  assert.match(now.command, /u_B=0x1p\+0,0 .*m_B=inf/);
  assert.deepEqual(now.values.dp, ['-0x1p+2', '-0x0p+0'].map((x, n) => now.values.dp[n] && x));
  agrees(now);
  await page.close();
});
