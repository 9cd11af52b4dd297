// The list of cases and what surrounds it. Each page is watched: it may log nothing and ask the network for nothing.

import assert from 'node:assert/strict';
import {after, before, test} from 'node:test';

import {startBrowser} from './browser.mjs';
import {corpusCases, fixture, reportOf} from './sample.mjs';

const cases = corpusCases();
const whole = reportOf({cases, ...Object.fromEntries(
  ['fuzz', 'replay', 'bench', 'stress', 'scene'].map((kind) => [kind, [fixture(kind)]]))});
const count = (passes) => cases.filter(passes).length;

let browser;
let path;
before(async () => {
  browser = await startBrowser();
  path = browser.write(whole);
});
after(() => browser.stop());

/** A test on the whole page, which must log nothing. */
function onPage(name, options, check) {
  test(name, async () => {
    const opened = await browser.open(path, options);
    await check(opened.page, opened);
    assert.deepEqual(opened.troubles, []);
    await opened.close();
  });
}

/** Scrolls until the list has grown to its end. */
async function scrollThrough(page) {
  while (await page.locator('#more').isVisible()) {
    await page.locator('#more').evaluate((node) => node.scrollIntoView({block: 'center', behavior: 'instant'}));
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  }
}

async function shownCount(page) {
  return Number.parseInt((await page.textContent('#shown-count')).replaceAll(',', ''), 10) || 0;
}

onPage('the page holds a section for each part and names the verdict', {}, async (page) => {
  const sections = await page.locator('#sections a').allTextContents();
  assert.deepEqual(sections, ['Campaigns', 'Replay', 'Cases', 'Bench', 'Stress', 'Scenes']);
  assert.match(await page.textContent('h1'), /2 replayed cases failed/);
});

test('what is left to find is a sentence, a curve of buckets against cases, and a table by regime', async () => {
  const {path: file, result} = fixture('fuzz');
  const row = (regime, once) => ({regime, cases: 2000, once, next: once / 2000, low: 0, high: 0.0123, wrong: {once: 0, next: 0, low: 0, high: 0.0018}});
  const fuzz = [{path: file, result: {...result, risk: [row('boxes', 1), row('all', 3)]}, overview: {verdicts: '', subject: '', oracle: '', causes: [], findings: []},
    curve: [[1, 1, 0], [40, 2, 1], [4000, 2, 1]]}];
  const opened = await browser.open(browser.write(reportOf({fuzz})));
  const {page} = opened;
  assert.match(await page.textContent('.overview'), /A bucket not yet seen: 1,500 in a million further cases \(95% interval: 0 to 12,300\)\. A wrong one: 0 \(0 to 1,800\)\./);
  assert.equal(await page.locator('.curve-plot path.line').count(), 2);
  const labels = await page.locator('.curve-plot .mark-target').evaluateAll((marks) => marks.map((mark) => mark.getAttribute('aria-label')));
  assert.ok(labels.includes('buckets, 2 buckets in 40 cases'));
  assert.ok(labels.includes('with somebody wrong, 1 bucket in 4,000 cases'));
  await page.getByText('By regime, in a million').click();
  assert.match(await page.textContent('.overview table tbody'), /boxes.*500.*all.*1,500/);
  assert.deepEqual(opened.troubles, []);
  await opened.close();
});

onPage('chips filter by verdict, and their counts are right', {}, async (page) => {
  assert.equal(await shownCount(page), cases.length);
  for (const verdict of ['known', 'tie', 'agree']) {
    const expected = count((one) => one.verdict === verdict);
    assert.ok(expected > 0);
    assert.equal(await page.textContent(`.chip[data-verdict=${verdict}] b`), String(expected));
    await page.click(`.chip[data-verdict=${verdict}]`);
    assert.equal(await shownCount(page), expected);
    assert.equal(await page.getAttribute(`.chip[data-verdict=${verdict}]`, 'aria-pressed'), 'true');
    await page.click(`.chip[data-verdict=${verdict}]`);
  }
  await page.click('.chip[data-verdict=known]');
  await page.click('.chip[data-verdict=tie]');
  assert.equal(await shownCount(page), count(({verdict}) => verdict === 'known' || verdict === 'tie'));
  await page.click('#clear');
  assert.equal(await shownCount(page), cases.length);
});

onPage('the regime and the search filter, together with each other and the chips', {}, async (page) => {
  await page.selectOption('#regime', 'sliver');
  assert.equal(await shownCount(page), count(({regime}) => regime === 'sliver'));
  await page.click('.chip[data-verdict=tie]');
  const ties = count(({regime, verdict}) => regime === 'sliver' && verdict === 'tie');
  assert.equal(await shownCount(page), ties);
  assert.equal(await page.textContent('.chip[data-verdict=tie] b'), String(ties));
  await page.click('#clear');
  await page.fill('#search', 'WITNESS-box2d');
  assert.equal(await shownCount(page), count(({file}) => file.includes('witness-box2d')));
  await page.fill('#search', 'chipmunk missed');
  assert.equal(await shownCount(page), count((one) => ['chipmunk', 'missed'].every((word) =>
    [one.file, one.bucket, one.verdict, one.regime, one.subject, one.oracle, one.sentence, one.note].join(' ').includes(word))));
  await page.fill('#search', 'no such thing');
  assert.equal(await page.textContent('#shown-count'), 'No file passes these filters.');
  assert.equal(await page.locator('.card').count(), 0);
});

onPage('a count of the matrix shows its files', {}, async (page) => {
  await page.click('.matrix tr:has(th:text-is("sliver")) button[aria-label*="tie"]');
  assert.equal(await shownCount(page), count(({regime, verdict}) => regime === 'sliver' && verdict === 'tie'));
});

onPage('cards sort by magnitude, severity, vertices and name', {}, async (page) => {
  const first = async () => {
    const card = page.locator('.card').first();
    if (await card.locator('summary').count() > 0) {
      await card.locator('summary').click();
      await card.locator('.files').waitFor();
    }
    return card.locator('a[data-case]').evaluateAll((links) => links.map((link) => link.dataset.case));
  };
  const greatest = (all) => Math.max(...all.map(({magnitude}) => magnitude).filter(Number.isFinite));
  const groupOf = (ids) => cases.filter(({file}) => ids.includes(file));
  await page.selectOption('#sort', 'magnitude');
  const [worst] = groupOf(await first());
  const sameGroup = cases.filter(({bucket, subject, oracle}) => bucket === worst.bucket && subject === worst.subject && oracle === worst.oracle);
  assert.equal(greatest(sameGroup), greatest(cases));
  await page.selectOption('#sort', 'vertices');
  const vertices = (one) => one.bodies[0].vertices.length + one.bodies[1].vertices.length;
  assert.ok(groupOf(await first()).some((one) => vertices(one) === Math.min(...cases.map(vertices))));
  await page.selectOption('#sort', 'severity');
  assert.ok(groupOf(await first()).some(({severity}) => severity === Math.max(...cases.map((one) => one.severity ?? -1))));
});

onPage('files of one bucket are one card, and all can be reached', {}, async (page) => {
  await scrollThrough(page);
  for (const summary of await page.locator('.card details > summary').all()) await summary.evaluate((node) => node.click());
  await page.waitForFunction((total) => new Set([...document.querySelectorAll('.card a[data-case]')]
    .map((link) => link.dataset.case)).size === total, cases.length);
});

onPage('the page switches to dark and back, and keeps it', {colorScheme: 'light'}, async (page) => {
  const paper = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  assert.equal(await paper(), 'rgb(255, 255, 255)');
  await page.click('#theme');
  assert.equal(await paper(), 'rgb(20, 23, 28)');
  await page.reload();
  assert.equal(await paper(), 'rgb(20, 23, 28)');
  await page.click('#theme');
  assert.equal(await paper(), 'rgb(255, 255, 255)');
});

// In a context of its own, which stays paper.
onPage('paper shows every case with its picture, and no controls', {colorScheme: 'light'}, async (page) => {
  await page.emulateMedia({media: 'print'});
  await page.waitForFunction(() => document.getElementById('more').hidden
    && [...document.querySelectorAll('.thumbnail-holder')].every((holder) => holder.firstChild));
  assert.equal(await page.locator('button:not(.cell):visible').count(), 0);
  assert.equal(await page.locator('select:visible, input:visible, dialog:visible, #bar:visible').count(), 0);
});

for (const width of [360, 800]) {
  onPage(`nothing sticks out at ${width} pixels`, {viewport: {width, height: 740}}, async (page) => {
    assert.ok(await page.evaluate(() => document.scrollingElement.scrollWidth) <= width);
    await page.locator('.witness').first().click();
    await page.locator('#stage .target.point').first().waitFor();
    assert.ok(await page.locator('.viewer-body').evaluate((node) => node.scrollWidth) <= width);
    assert.ok(await page.evaluate(() => document.scrollingElement.scrollWidth) <= width);
  });
}

onPage('the keys reach the search, the cases and the help', {}, async (page) => {
  await page.keyboard.press('Tab');
  assert.equal(await page.evaluate(() => document.activeElement.textContent), 'Skip to the report');
  await page.keyboard.press('/');
  assert.equal(await page.evaluate(() => document.activeElement.id), 'search');
  await page.keyboard.type('?j');
  assert.equal(await page.inputValue('#search'), '?j');
  await page.fill('#search', '');
  await page.locator('h1').click();
  await page.keyboard.press('j');
  await page.keyboard.press('j');
  const second = await page.locator('#cards a[data-case]').nth(1).getAttribute('data-case');
  assert.equal(await page.evaluate(() => document.activeElement.dataset.case), second);
  await page.keyboard.press('Enter');
  await page.locator('#viewer[open]').waitFor();
  assert.match(await page.textContent('.viewer-title'), new RegExp(second.replaceAll('.', '\\.')));
  await page.keyboard.press('Escape');
  await page.locator('#viewer').waitFor({state: 'hidden'});
  assert.equal(await page.evaluate(() => document.activeElement.dataset.case), second);
  await page.keyboard.press('?');
  assert.ok(await page.locator('#help').isVisible());
});

onPage('plots tell their values and follow their choices', {}, async (page) => {
  const marks = page.locator('#bench .bench-point');
  assert.equal(await marks.count(), whole.bench[0].result.rows.filter((row) => row.error && ['', 'AVX3'].includes(row.target)).length);
  await marks.first().hover();
  assert.match(await page.textContent('#tooltip'), /box2d.*177 ns a pair.*depth error 7\.86/);
  const line = () => page.locator('#stress .line').first().getAttribute('d');
  const depth = await line();
  await page.locator('#stress select').selectOption('normal');
  assert.notEqual(await line(), depth);
  const broken = whole.stress[0].result.sweeps.filter(({breaking_point: x}) => x !== null);
  assert.ok(broken.length > 0);
  assert.equal(await page.locator('#stress .break').count(), broken.length);
  const scenes = whole.scene[0].result.rows.filter(({baseline}) => baseline === 'box2d');
  assert.equal(await page.locator('#scenes tbody').first().locator('tr').count(), scenes.length);
});

onPage('walks tell what was wrong, and what may have been', {}, async (page) => {
  const rows = page.locator('#stress table', {hasText: 'flickers'}).locator('tbody tr');
  assert.equal(await rows.count(), whole.stress[0].result.walks.length);
  assert.match(await rows.nth(0).textContent(), /resting.*clip.*0 \(\+392 within bound\)/);
  assert.equal(await rows.nth(0).locator('.bad').count(), 0);
  assert.equal(await rows.nth(1).locator('.bad').count(), 3);
});

onPage('recycling is a line of errors against what is skipped', {}, async (page) => {
  const {points} = whole.scene[0].result.recycling[0];
  const marks = page.locator('#scenes .line-point');
  assert.equal(await marks.count(), points.length);
  await marks.last().scrollIntoViewIfNeeded();
  await marks.last().hover();
  assert.match(await page.textContent('#tooltip'), /pile 200 bodies.*skipped.*depth error/);
  const before = await marks.last().getAttribute('cy');
  await page.locator('#scenes select').selectOption('position');
  assert.notEqual(await marks.last().getAttribute('cy'), before);
});

onPage('a failed replay links to its case', {}, async (page) => {
  await page.click('#replay td a, #replay th a');
  await page.locator('#viewer[open]').waitFor();
  assert.match(await page.textContent('.viewer-title'), /witness-box2d-no-contact-on-tied-features/);
});
