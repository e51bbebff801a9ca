// Headless Chromium of Debian, driven by playwright-core; whatever goes wrong in a page is kept.
import { createRequire } from 'node:module';
import path from 'node:path';
import { root } from './reference.mjs';

const { chromium } = createRequire(path.join(root, 'build/site-tools/'))('playwright-core');

export const launch = () => chromium.launch({
  executablePath: '/usr/bin/chromium',
  args: ['--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync',
    '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist'],
});

/** Opens a file as a reader does, from the disk. @returns {{page, wrong: string[]}} `wrong`: errors, warnings of the policy, requests that failed or left the disk. */
export async function open(browser, file, options = {}) {
  const page = await browser.newPage({ viewport: { width: 1200, height: 900 }, ...options });
  const wrong = [];
  page.on('console', (message) => { if (message.type() === 'error') wrong.push(`console: ${message.text()}`); });
  page.on('pageerror', (error) => wrong.push(`error: ${error.message}`));
  page.on('requestfailed', (request) => wrong.push(`failed: ${request.url()}`));
  page.on('request', (request) => { if (!/^(file|data|blob):/.test(request.url())) wrong.push(`loads ${request.url()}`); });
  await page.goto(`file://${file}`);
  return { page, wrong };
}
