// One Chromium for all tests of a file; every page that it opens is watched.

import {mkdtempSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {pathToFileURL} from 'node:url';
import {chromium} from 'playwright-core';

import {pageOf} from './sample.mjs';

const flags = ['--headless', '--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run',
  '--disable-background-networking', '--disable-component-update', '--disable-sync'];

const viewport = {width: 1280, height: 860};

/** A page of the context, whose troubles are noted. */
async function watched(context, init) {
  const opened = {page: await context.newPage(), url: '', troubles: []};
  opened.page.on('console', (message) => opened.troubles.push(`${message.type()}: ${message.text()}`));
  opened.page.on('pageerror', (error) => opened.troubles.push(`error: ${error.message}`));
  opened.page.on('request', (request) => {
    const asked = request.url();
    if (asked.split('#')[0] !== opened.url && !/^(data:|blob:|about:blank)/.test(asked)) opened.troubles.push(`request: ${asked}`);
  });
  if (init) await opened.page.addInitScript(init);
  return opened;
}

/** Debian's Chromium; MANIFUZZ_CHROMIUM names another one. */
export async function startBrowser() {
  const browser = await chromium.launch({executablePath: process.env.MANIFUZZ_CHROMIUM ?? '/usr/bin/chromium', args: flags});
  const folder = mkdtempSync(join(tmpdir(), 'manifuzz-page-'));
  let pages = 0;
  let plain;
  return {
    /** Writes a page that shows `data`; its path. */
    write(data) {
      const path = join(folder, `page-${++pages}.html`);
      writeFileSync(path, pageOf(data));
      return path;
    },
    /** Opens the file, with options in a context of its own; {page, troubles, url}. Troubles: what it logs, throws or asks the network for. */
    async open(path, {hash = '', init = undefined, ...options} = {}) {
      const isPlain = init === undefined && Object.keys(options).length === 0;
      if (isPlain) plain ??= await watched(await browser.newContext({viewport}));
      const opened = isPlain ? plain : await watched(await browser.newContext({viewport, ...options}), init);
      // From the same page with another hash there would be no load.
      await opened.page.goto('about:blank');
      opened.url = pathToFileURL(path).href;
      opened.troubles = [];
      await opened.page.goto(opened.url + hash);
      return {...opened, close: () => (isPlain ? undefined : opened.page.context().close())};
    },
    async stop() {
      await browser.close();
      rmSync(folder, {recursive: true});
    },
  };
}
