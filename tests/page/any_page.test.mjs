// What any page must do that `manifuzz report` wrote: here MANIFUZZ_PAGE.

import assert from 'node:assert/strict';
import {resolve} from 'node:path';
import {after, before, test} from 'node:test';

import {startBrowser} from './browser.mjs';

let browser;
let path;
before(async () => {
  browser = await startBrowser();
  path = resolve(process.env.MANIFUZZ_PAGE);
});
after(() => browser.stop());

/** A test on the page, which must log nothing and ask the network for nothing. */
function onPage(name, options, check) {
  test(name, async () => {
    const opened = await browser.open(path, options);
    await check(opened.page);
    assert.deepEqual(opened.troubles, []);
    await opened.close();
  });
}

const dataOf = (page) => page.evaluate(() => JSON.parse(document.getElementById('data').textContent));

onPage('it says what came of it', {}, async (page) => {
  assert.ok((await page.textContent('h1')).length > 3);
  assert.equal((await dataOf(page)).format, 'manifuzz/report/1');
});

onPage('it has room on a phone', {viewport: {width: 360, height: 740}}, async (page) => {
  assert.ok(await page.evaluate(() => document.scrollingElement.scrollWidth) <= 360);
});

onPage('it is dark on a dark system', {colorScheme: 'dark'}, async (page) => {
  assert.equal(await page.evaluate(() => getComputedStyle(document.body).backgroundColor), 'rgb(20, 23, 28)');
});

/** Opens each case in turn; what is wrong with any. Runs in the page. */
async function openAll() {
  const {cases} = JSON.parse(document.getElementById('data').textContent);
  const viewer = document.getElementById('viewer');
  const wrong = [];
  for (const one of cases) {
    location.hash = `case=${encodeURIComponent(one.file)}`;
    await new Promise((done) => addEventListener('hashchange', done, {once: true}));
    const isWaiting = () => viewer.querySelector('#stage svg:not([data-camera])');
    for (let i = 0; i < 1000 && isWaiting(); ++i) await new Promise((done) => setTimeout(done, 1));
    const points = one.answers.find(({role}) => role === 'truth')?.manifolds[0]?.points ?? [];
    const drawn = viewer.querySelectorAll('[data-key^="point truth"]').length;
    if (!viewer.querySelector('.viewer-title').textContent.endsWith(one.file)) wrong.push(`${one.file}: not opened`);
    if (drawn !== points.length) wrong.push(`${one.file}: ${drawn} of ${points.length} true points are drawn`);
    const said = viewer.innerHTML.replaceAll(/data:image[^"]*/g, ''); // base64 may spell anything
    if (said.includes('NaN')) wrong.push(`${one.file}: NaN`);
  }
  return wrong;
}

onPage('each case opens, with the true points in their places', {}, async (page) => {
  assert.deepEqual(await page.evaluate(openAll), []);
});
