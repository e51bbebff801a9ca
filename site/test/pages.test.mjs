// Every page of the site opens from the disk, whole and without a complaint, in each of the ways it is read.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import { gzipSync } from 'node:zlib';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { launch, open } from './browser.mjs';
import { root } from './reference.mjs';

const site = path.join(root, 'build/site');
let browser;
before(async () => { browser = await launch(); });
after(() => browser.close());

const pages = fs.readdirSync(site).filter((name) => name.endsWith('.html') && name !== '404.html');

test('there is a page for each of docs/', () => {
  for (const name of fs.readdirSync(path.join(root, 'docs')).filter((n) => n.endsWith('.md'))) assert.ok(pages.includes(name.replace('.md', '.html')), name);
});

for (const name of pages) {
  test(`${name} loads without a complaint, and fits a telephone in the dark`, async () => {
    const wide = await open(browser, path.join(site, name));
    for (const live of await wide.page.locator('.tps-equation, .tps-experiment').all()) await live.locator('svg').first().waitFor({ timeout: 60000 });
    assert.deepEqual(wide.wrong, []);
    await wide.page.close();
    const narrow = await open(browser, path.join(site, name), { viewport: { width: 360, height: 700 }, colorScheme: 'dark' });
    assert.deepEqual(narrow.wrong, []);
    const width = await narrow.page.evaluate(() => document.scrollingElement.scrollWidth);
    assert.ok(width <= 360, `${width} pixels wide`);
    await narrow.page.close();
  });
}

test('links between pages and to copied files lead somewhere', () => {
  for (const name of pages) {
    const text = fs.readFileSync(path.join(site, name), 'utf8');
    for (const [, link] of text.matchAll(/href="([^"#:]+)(?:#[^"]*)?"/g)) assert.ok(fs.existsSync(path.join(site, decodeURI(link))), `${name}: ${link}`);
  }
});

test('the first page leads to every equation', () => {
  const text = fs.readFileSync(path.join(site, 'index.html'), 'utf8').split('<article')[1];
  for (let n = 1; n <= 7; n++) assert.ok(text.includes(`href="eq${n}.html"`), `eq${n}`);
});

test('the reference is small enough to be loaded', () => {
  const size = gzipSync(fs.readFileSync(path.join(site, 'live/reference.js'))).length;
  console.log(`live/reference.js: ${size} bytes, compressed`);
  assert.ok(size < 2e6);
});

test('search finds a section by its words', async () => {
  const { page } = await open(browser, path.join(site, 'search.html'));
  await page.fill('input[type=search]', 'earliest turn');
  await page.waitForSelector('.tps-found a[href*="check.html"]');
  await page.close();
});
