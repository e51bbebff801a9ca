// The figures of the equations say what the program says.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
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
