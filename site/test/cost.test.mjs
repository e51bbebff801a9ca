// The page of `tps cost` in a browser: every section has its plots, their marks say what the JSON says, it works by keyboard, in the dark and on paper.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { launch, open } from './browser.mjs';
import { root } from './reference.mjs';

const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'tps-cost-'));
const file = (name) => path.join(folder, name);
const levels = ['queries', 'responses', 'runs', 'grouping', 'revolution', 'cases'];
let browser, study;

before(async () => {
  const done = spawnSync(path.join(root, 'build/release/tps'), ['cost', '--queries', '--responses', '--runs', '--model', '--hard-cases', '--quick', '--quiet', '--questions', '200',
    '--repetitions', '3', '--events', '600', '--stratum', 'plain,graze', '--case', 'grazing-train,resting', '--json', file('cost.json'), '--page', file('cost.html')],
  { encoding: 'utf8' });
  assert.equal(done.status, 0, done.stderr);
  study = JSON.parse(fs.readFileSync(file('cost.json'), 'utf8'));
  browser = await launch();
});
after(async () => { await browser?.close(); fs.rmSync(folder, { recursive: true }); });

/** The figures of a section: title, and of each mark what it says and where its centre is on the screen. */
const figuresOf = (page, section) => page.evaluate((id) => {
  const figures = [];
  for (let e = document.getElementById(id).nextElementSibling; e && !e.id; e = e.nextElementSibling) figures.push(...e.querySelectorAll('figure'));
  return figures.map((figure) => ({
    title: figure.querySelector('figcaption').textContent,
    frame: figure.querySelector('svg').getBoundingClientRect().toJSON(),
    marks: [...figure.querySelectorAll('.reach path')].map((mark) => {
      const box = mark.getBoundingClientRect();
      return { says: mark.getAttribute('aria-label'), x: box.x + box.width / 2, y: box.y + box.height / 2 };
    }),
  }));
}, section);
async function pageOf(options) {
  const opened = await open(browser, file('cost.html'), options);
  await opened.page.waitForSelector('body[data-drawn=all]', { timeout: 20000 });
  return opened;
}
/** The tips that are seen. */
const tips = (page) => page.$$eval('.tip', (all) => all.filter((tip) => getComputedStyle(tip).visibility === 'visible').map((tip) => tip.textContent));
/** "12.5" of "stable-double: 12.5 ns, …" as the program rounds: to four digits. */
const four = (x) => Number(x).toPrecision(4);

test('every section has plots, with every mark inside of its frame, and nothing goes wrong', async () => {
  const { page, wrong } = await pageOf();
  assert.deepEqual(await page.$$eval('h2[id]', (all) => all.map((h) => h.id)), levels);
  for (const section of levels.slice(0, -1)) {
    const figures = await figuresOf(page, section);
    assert.ok(figures.length >= 2, `${section}: ${figures.length} figures`);
    for (const { title, frame, marks } of figures) {
      assert.ok(frame.width > 200 && frame.height > 100, `${title} is ${frame.width} by ${frame.height}`);
      for (const mark of marks) assert.ok(mark.x > frame.left && mark.x < frame.right && mark.y > frame.top && mark.y < frame.bottom, `${title}: ${mark.says} is outside`);
    }
    assert.ok(figures.some((figure) => figure.marks.length >= 10), `${section} is empty`);
  }
  assert.deepEqual(wrong, []);
  await page.close();
});

test('marks say what the JSON says, and stand where it says', async () => {
  const { page } = await pageOf();
  const [plain] = await figuresOf(page, 'queries');
  for (const cell of study.strata[0].cells.filter((c) => 'p99' in c.log2_error)) {
    const mark = plain.marks.find((m) => m.says.startsWith(`${cell.variant}: `));
    const [, ns, error] = /: ([\d.e+]+) ns, error 2\^(\S+) at p99/.exec(mark.says);
    assert.equal(four(ns), four(cell.ns.throughput.median), mark.says);
    assert.equal(Number(error), Number(cell.log2_error.p99.toFixed(1)), mark.says);
  }
  const faster = (x, y) => x.ns.throughput.median - y.ns.throughput.median;
  const cells = study.strata[0].cells.filter((c) => 'p99' in c.log2_error).sort(faster);
  const places = cells.map((c) => plain.marks.find((m) => m.says.startsWith(`${c.variant}: `)).x);
  assert.deepEqual(places, [...places].sort((x, y) => x - y), 'a slower variant stands to the left of a faster one');

  const [horizons] = await figuresOf(page, 'runs');
  const expected = [...study.runs.rows.filter((r) => 'horizon' in r).map((r) => r.horizon), ...study.runs.proven.filter((p) => !['events', 'end'].includes(p.ends_by)).map((p) => p.events)];
  assert.ok(horizons.marks.some((m) => m.says.startsWith('gas, proven for every start')), 'no mark of what is proven');
  assert.deepEqual(horizons.marks.map((m) => Number(/(\d+) (collisions or )?events/.exec(m.says)[1])), expected);

  const [collisions, distances] = await figuresOf(page, 'grouping');
  assert.deepEqual(collisions.marks.map((m) => Number(/(\d+) collisions/.exec(m.says)[1])), study.model.grouping.map((r) => r.collisions));
  assert.equal(distances.marks.length, study.model.grouping.filter((r) => 'distance' in r).length);

  const rows = await page.$$eval('#cases ~ div tr', (all) => all.map((row) => [...row.children].map((cell) => cell.textContent)));
  study.cases.forEach((one, k) => {
    assert.ok(rows[k + 1][0].startsWith(`${one.name}:`));
    assert.deepEqual(rows[k + 1].slice(2, 2 + one.outcomes.length), one.outcomes.map((o) => ('horizon' in o ? String(o.horizon) : 'all')));
    assert.equal(rows[k + 1].at(-1), one.good_enough);
  });
  await page.close();
});

test('by keyboard: links, a stop in every plot, and from there each mark, which tells its figures', async () => {
  const { page } = await pageOf();
  const says = () => page.evaluate(() => (document.activeElement.matches('.reach path') ? document.activeElement.getAttribute('aria-label') : null));
  for (const id of levels) {
    await page.keyboard.press('Tab');
    assert.equal(await page.evaluate(() => document.activeElement.getAttribute('href')), `#${id}`);
  }
  const [plain, graze] = await figuresOf(page, 'queries');
  await page.keyboard.press('Tab');
  for (const mark of plain.marks) {
    assert.equal(await says(), mark.says);
    assert.deepEqual(await tips(page), [mark.says]);
    await page.keyboard.press('ArrowRight');
  }
  assert.equal(await says(), plain.marks.at(-1).says, 'an arrow leads out of the plot');
  await page.keyboard.press('Home');
  assert.equal(await says(), plain.marks[0].says);
  await page.keyboard.press('End');
  await page.keyboard.press('ArrowLeft');
  assert.equal(await says(), plain.marks.at(-2).says);
  await page.keyboard.press('Tab');
  assert.equal(await page.evaluate(() => document.activeElement.textContent), 'every number');
  assert.deepEqual(await tips(page), []);
  await page.keyboard.press('Tab');
  assert.equal(await says(), graze.marks[0].says);
  assert.deepEqual(await tips(page), [graze.marks[0].says]);
  assert.equal(await page.evaluate(() => document.querySelectorAll('.reach path[tabindex="0"]').length), await page.evaluate(() => document.querySelectorAll('figure').length));
  await page.click('nav a[href="#cases"]');
  assert.ok(await page.$eval('#cases', (h) => h.getBoundingClientRect().top < innerHeight), 'the link leads nowhere');
  await page.close();
});

test('without scripts the page says so and each list has the numbers of its plot', async () => {
  const drawn = await pageOf();
  const [plain] = await figuresOf(drawn.page, 'queries');
  await drawn.page.close();
  const { page } = await open(browser, file('cost.html'), { javaScriptEnabled: false });
  assert.match(await page.locator('noscript').innerText(), /scripts/);
  await page.locator('summary').first().click();
  assert.deepEqual(await page.locator('figure').first().locator('li').allInnerTexts(), plain.marks.map((mark) => mark.says));
  await page.close();
});

test('a mark that is pointed at tells its figures, until the pointer leaves', async () => {
  const { page } = await pageOf();
  await page.evaluate(() => document.getElementById('grouping').scrollIntoView());
  const [collisions] = await figuresOf(page, 'grouping');
  const mark = collisions.marks.at(-1);
  await page.mouse.move(mark.x, mark.y);
  assert.deepEqual(await tips(page), [mark.says]);
  await page.mouse.move(collisions.frame.left + 2, collisions.frame.top + 2);
  assert.deepEqual(await tips(page), []);
  await page.close();
});

test('light and dark differ in paper, ink and marks, and both can be read', async () => {
  const looks = {};
  for (const colorScheme of ['light', 'dark']) {
    const { page } = await pageOf({ colorScheme });
    looks[colorScheme] = await page.evaluate(() => {
      const luminance = (colour) => { const [r, g, b] = /rgba?\((\d+), (\d+), (\d+)/.exec(colour).slice(1).map((v) => (v / 255 <= 0.03928 ? v / 3294.6 : ((v / 255 + 0.055) / 1.055) ** 2.4)); return 0.2126 * r + 0.7152 * g + 0.0722 * b; };
      const ratio = (a, b) => (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
      const paper = luminance(getComputedStyle(document.body).backgroundColor);
      return { paper, text: ratio(paper, luminance(getComputedStyle(document.body).color)), tick: ratio(paper, luminance(getComputedStyle(document.querySelector('.role-axis-label text')).fill)),
        marks: Math.min(...[...document.querySelectorAll('.shapes path')].map((mark) => getComputedStyle(mark)).map((look) => ratio(paper, luminance(look.fill === 'none' ? look.stroke : look.fill)))) };
    });
    await page.close();
  }
  assert.ok(looks.light.paper > 0.9 && looks.dark.paper < 0.05, JSON.stringify(looks));
  for (const look of Object.values(looks)) assert.ok(look.text > 7 && look.tick > 7 && look.marks > 3, JSON.stringify(looks));  // WCAG: 7 for text, 3 for graphics
});

test('on paper nothing is cut off and no tip is left', async () => {
  const { page } = await pageOf();
  await page.setViewportSize({ width: 720, height: 1000 });
  await page.emulateMedia({ media: 'print' });
  const seen = await page.evaluate(() => ({
    tips: [...document.querySelectorAll('.tip')].filter((tip) => getComputedStyle(tip).display !== 'none').length,
    outside: [...document.querySelectorAll('svg')].filter((svg) => svg.getBoundingClientRect().right > innerWidth + 1).length,
    tables: [...document.querySelectorAll('details table')].length,
  }));
  assert.equal(seen.tips, 0);
  assert.equal(seen.outside, 0);
  assert.ok(seen.tables >= study.strata.length);
  assert.ok((await page.pdf({ format: 'A4' })).length > 10000);
  await page.close();
});
