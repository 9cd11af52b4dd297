// What any page must do. MANIFUZZ_PAGE names one that `manifuzz report` wrote; without it a page of the corpus is checked.

import assert from 'node:assert/strict';
import {resolve} from 'node:path';
import {after, before, test} from 'node:test';

import {startBrowser} from './browser.mjs';
import {corpusCases, reportOf} from './sample.mjs';

let browser;
let path;
before(async () => {
  browser = await startBrowser();
  path = process.env.MANIFUZZ_PAGE ? resolve(process.env.MANIFUZZ_PAGE) : browser.write(reportOf({cases: corpusCases()}));
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

onPage('each case opens, with the true points in their places', {}, async (page) => {
  const {cases} = await dataOf(page);
  for (const one of cases.slice(0, 400)) {
    await page.evaluate((file) => { location.hash = `case=${encodeURIComponent(file)}`; }, one.file);
    await page.waitForFunction((file) => document.querySelector('.viewer-title p')?.textContent.endsWith(file), one.file);
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
    const points = one.parties.find(({role}) => role === 'truth')?.manifolds[0]?.points ?? [];
    assert.equal(await page.locator('#stage [data-key^="point truth"]').count(), points.length, one.file);
    assert.ok(!(await page.locator('#viewer').innerHTML()).includes('NaN'), one.file);
  }
});
