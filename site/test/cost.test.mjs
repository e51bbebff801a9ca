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
    marks: [...figure.querySelectorAll('.mark')].map((mark) => {
      const box = mark.querySelector('.reach').getBoundingClientRect();
      return { says: mark.getAttribute('aria-label'), x: box.x + box.width / 2, y: box.y + box.height / 2 };
    }),
  }));
}, section);
const pageOf = (options) => open(browser, file('cost.html'), options);
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

test('the tabulator key reaches marks, whose figures then show, and links lead to sections', async () => {
  const { page } = await pageOf();
  const shown = () => page.evaluate(() => {
    const mark = document.activeElement;
    return { mark: mark.classList.contains('mark'), tip: mark.querySelector('.tip') && getComputedStyle(mark.querySelector('.tip')).visibility, label: mark.getAttribute('aria-label'), text: mark.querySelector('.tip')?.textContent };
  });
  for (const id of levels) {
    await page.keyboard.press('Tab');
    assert.equal(await page.evaluate(() => document.activeElement.getAttribute('href')), `#${id}`);
  }
  await page.keyboard.press('Tab');
  const first = await shown();
  assert.ok(first.mark && first.tip === 'visible' && first.text === first.label, JSON.stringify(first));
  await page.keyboard.press('Tab');
  assert.notEqual((await shown()).label, first.label);
  assert.equal(await page.$$eval('.mark .tip', (all) => all.filter((tip) => getComputedStyle(tip).visibility === 'visible').length), 1);
  await page.click('nav a[href="#cases"]');
  assert.ok(await page.$eval('#cases', (h) => h.getBoundingClientRect().top < innerHeight), 'the link leads nowhere');
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
      return { paper, text: ratio(paper, luminance(getComputedStyle(document.body).color)), tick: ratio(paper, luminance(getComputedStyle(document.querySelector('text.tick')).fill)),
        marks: Math.min(...[...document.querySelectorAll('.mark circle:not(.reach)')].map((c) => ratio(paper, luminance(getComputedStyle(c).fill)))) };
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
