// One Chromium for all tests of a file; every page that it opens is watched.

import {mkdtempSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {pathToFileURL} from 'node:url';
import {chromium} from 'playwright-core';

import {pageOf} from './sample.mjs';

const flags = ['--headless', '--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run',
  '--disable-background-networking', '--disable-component-update', '--disable-sync'];

/** Debian's Chromium; MANIFUZZ_CHROMIUM names another one. */
export async function startBrowser() {
  const browser = await chromium.launch({executablePath: process.env.MANIFUZZ_CHROMIUM ?? '/usr/bin/chromium', args: flags});
  const folder = mkdtempSync(join(tmpdir(), 'manifuzz-page-'));
  let pages = 0;
  return {
    /** Writes a page that shows `data`; its path. */
    write(data) {
      const path = join(folder, `page-${++pages}.html`);
      writeFileSync(path, pageOf(data));
      return path;
    },
    /** Opens the file in a context of its own; {page, troubles, url}. Troubles: what it logs, throws or asks the network for. */
    async open(path, {hash = '', init = undefined, ...options} = {}) {
      const context = await browser.newContext({viewport: {width: 1280, height: 860}, ...options});
      const page = await context.newPage();
      const url = pathToFileURL(path).href;
      const troubles = [];
      page.on('console', (message) => troubles.push(`${message.type()}: ${message.text()}`));
      page.on('pageerror', (error) => troubles.push(`error: ${error.message}`));
      page.on('request', (request) => {
        const asked = request.url();
        if (asked.split('#')[0] !== url && !asked.startsWith('data:')) troubles.push(`request: ${asked}`);
      });
      if (init) await page.addInitScript(init);
      await page.goto(url + hash);
      return {page, troubles, url, close: () => context.close()};
    },
    async stop() {
      await browser.close();
      rmSync(folder, {recursive: true});
    },
  };
}
