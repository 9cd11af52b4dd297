// Data that is large, odd or ill-meant.

import assert from 'node:assert/strict';
import {after, before, test} from 'node:test';

import {startBrowser} from './browser.mjs';
import {allCases, corpusCases, fixture, reportOf} from './sample.mjs';

let browser;
before(async () => {
  browser = await startBrowser();
});
after(() => browser.stop());

/** A test on a page of its own, which must log nothing. */
function onData(name, data, check, options = {}) {
  test(name, async () => {
    const opened = await browser.open(browser.write(data), options);
    await check(opened.page);
    assert.deepEqual(opened.troubles, []);
    await opened.close();
  });
}

const [sample] = corpusCases().filter(({file}) => file.includes('oracle-known-missed_contact-incident-b-gross-e93298bc.json'));
const boxes = allCases().find(({file}) => file.includes('boxes.jsonl'));
const round = allCases().find(({file}) => file.includes('round.jsonl'));

/** The value with each of its points stretched along x and y. */
function stretched(value, by) {
  if (Array.isArray(value) && value.length === 2 && value.every(Number.isFinite)) return value.map((x, axis) => x * by[axis]);
  if (Array.isArray(value)) return value.map((inner) => stretched(inner, by));
  if (value === null || typeof value !== 'object') return value;
  return Object.fromEntries(Object.entries(value).map(([key, inner]) => [key, ['normal', 'outward'].includes(key) ? inner : stretched(inner, by)]));
}

/** Two overlapping boxes with two contact points, `scale` in size. */
function boxesOf(file, scale, aspect, radius = 0) {
  const one = stretched(boxes, [scale * aspect, scale]);
  return {...one, file, bodies: one.bodies.map((body) => ({...body, radius}))};
}

async function openFirst(page) {
  await page.locator('.witness').first().click();
  await page.locator('#viewer[open]').waitFor();
}

onData('a circle and a capsule are drawn round, with the normal where cores are nearest', reportOf({cases: [round]}), async (page) => {
  await openFirst(page);
  const corners = (css) => page.locator(`#stage .fill.${css}`).first().evaluate((node) => node.getAttribute('d').split('L').length);
  assert.ok(await corners('a') > 24);
  assert.ok(await corners('b') > 24);
  assert.equal(await page.locator('#stage .normal').count() > 0, true);
  assert.equal(await page.locator('#stage .letter').count(), 2);
});

for (const [name, ...shape] of [['tiny', 1e-18, 1], ['huge', 1e18, 1], ['long', 1, 1e8], ['rounded and tiny', 1e-18, 1, 1e-18], ['rounded and long', 1e-4, 1e8, 1e-2]]) {
  onData(`${name} polygons are drawn, and every point in its place`, reportOf({cases: [boxesOf(`${name}.json`, ...shape)]}), async (page) => {
    await openFirst(page);
    await page.locator('#stage .target.point').first().waitFor();
    assert.equal(await page.locator('#stage .target.point').count(), 6);
    assert.equal(await page.locator('#stage .reference').count(), 1);
    const stage = await page.locator('#stage').boundingBox();
    const boxes = await page.locator('#stage .target.point').evaluateAll((nodes) => nodes.map((node) => node.getBoundingClientRect().toJSON()));
    for (const box of boxes) assert.ok(box.left > stage.x - 12 && box.right < stage.x + stage.width + 12 && box.top > stage.y && box.bottom < stage.y + stage.height);
    const across = boxes.map((box) => box.x);
    assert.ok(Math.max(...across) - Math.min(...across) > 150);
    await page.keyboard.press('f');
    await page.keyboard.press('o');
    assert.ok(!(await page.locator('#stage').innerHTML()).includes('NaN'));
  });
}

const evil = '</script><img src=x onerror="document.title=\'owned\'">\'"&amp;<b>\u202eevil\u2066';
const names = {...sample, file: `${evil}.json`, sentence: evil, note: evil, regime: evil, subject: evil, oracle: evil, bucket: `a/b/${evil}/d/e`,
  commands: [evil], case: evil, property: evil, map: 'data:text/html,<script>1</script>', map_words: [evil], curve: evil, curve_words: [evil]};

onData('what the data says is text, never HTML', reportOf({cases: [names], errors: [evil], command: evil, version: evil,
  sources: [{path: evil, kind: evil, cases: null}]}), async (page) => {
  assert.equal(await page.locator('img').count(), 0);
  await openFirst(page);
  assert.equal(await page.textContent('#viewer-title'), evil);
  assert.ok((await page.textContent('.details')).includes(evil));
  assert.equal(await page.locator('img, main b:has-text("evil")').count(), 0);
  assert.notEqual(await page.title(), 'owned');
  await page.keyboard.press('Escape');
  assert.ok((await page.textContent('footer')).includes(evil));
});

const sequence = {file: 'sequence.json', subject: 'cached', oracle: 'judge', verdict: 'known', bucket: 'subject/known/normal/none/a/gross', regime: 'rocking',
  frames: 2, note: '', sentence: 'cached is wrong', count: null, commands: [], svg: '<svg xmlns="http://www.w3.org/2000/svg" width="40" height="20"></svg>'};
const script = `<svg xmlns="http://www.w3.org/2000/svg" width="40" height="20"><script>${evil}</script></svg>`;

onData('a filmstrip is a picture, and what is said of it text', reportOf({sequences: [sequence, {...sequence, file: evil, subject: evil, regime: evil, note: evil,
  sentence: evil, commands: [evil], svg: script}, {...sequence, svg: ''}]}), async (page) => {
  assert.equal(await page.textContent('h1'), 'Nothing recorded as unexplained');
  assert.equal(await page.locator('#sequences article').count(), 3);
  assert.equal(await page.locator('#sequences img').count(), 2);
  assert.equal(await page.locator('#sequences img').first().evaluate((image) => image.naturalWidth), 40);
  assert.equal(await page.locator('#sequences b, #sequences script, #sequences svg').count(), 0);
  assert.notEqual(await page.title(), 'owned');
  assert.ok((await page.textContent('#sequences')).includes('not there to be asked'));
});

const long = 'long'.repeat(500);
onData('very long words stick out nowhere', reportOf({cases: [{...sample, file: `${long}.json`, sentence: long, note: long, bucket: `a/b/${long}/d/e`,
  subject: long, commands: [long]}], errors: [long], command: long}), async (page) => {
  assert.ok(await page.evaluate(() => document.scrollingElement.scrollWidth) <= 360);
  await openFirst(page);
  assert.ok(await page.locator('.viewer-body').evaluate((node) => node.scrollWidth) <= 360);
}, {viewport: {width: 360, height: 740}});

/** Every number of the case is gone; its texts stay. */
function numberless(value) {
  if (typeof value === 'number') return null;
  if (Array.isArray(value)) return value.map(numberless);
  if (value === null || typeof value !== 'object') return value;
  return Object.fromEntries(Object.entries(value).map(([key, inner]) => [key, numberless(inner)]));
}

onData('a case without any number says so', reportOf({cases: [numberless(sample)]}), async (page) => {
  assert.match(await page.textContent('.thumbnail-holder'), /not drawable/);
  await openFirst(page);
  assert.match(await page.textContent('#stage'), /cannot be drawn/);
  for (const key of ['+', '-', '0', 'f', 'o', '.', ',', '[', 'Shift+ArrowUp']) await page.keyboard.press(key);
});

onData('answers without numbers are told beside polygons that are drawn', reportOf({cases: [{...sample, answers: sample.answers.map(numberless)}]}), async (page) => {
  await openFirst(page);
  await page.locator('#stage .edge').first().waitFor({state: 'attached'});
  assert.ok((await page.textContent('.details')).includes('not finite'));
  await page.keyboard.press('f');
  assert.ok(!(await page.locator('#stage').innerHTML()).includes('NaN'));
});

const [truth, ...colliders] = sample.answers;
const severalRight = {...sample, answers: [{...truth, manifolds: [{points: []}, ...truth.manifolds]}, ...colliders]};
onData('an answer is held against the right manifold that is nearest', reportOf({cases: [severalRight]}), async (page) => {
  await openFirst(page);
  assert.match(await page.textContent('.answer.subject .difference'), /^position off by 3\.3e-5/);
  assert.equal(await page.textContent('.answer.oracle .difference'), 'as the truth');
});

onData('a page of nothing says so', reportOf(), async (page) => {
  assert.equal(await page.textContent('h1'), 'Nothing to show');
  assert.equal(await page.locator('main section').count(), 1);
});

onData('a bench alone is a page', reportOf({bench: [fixture('bench')]}), async (page) => {
  assert.equal(await page.textContent('h1'), 'Measured: bench');
  assert.deepEqual(await page.locator('#sections a').allTextContents(), ['Bench']);
});

const holes = Object.fromEntries(['fuzz', 'replay', 'bench', 'stress', 'scene'].map((kind) => [kind, [
  {path: `${kind}.json`, result: numberless(fixture(kind).result)}, {path: 'empty.json', result: {}}]]));
onData('results without numbers, and without anything, are shown', reportOf(holes), async (page) => {
  assert.equal(await page.locator('#sections a').count(), 5);
  assert.ok(!(await page.content()).includes('="NaN'));
});

const thousand = corpusCases().filter(({bodies}) => bodies[0].vertices.length > 2);
const many = Array.from({length: 1000}, (_, i) => {
  const one = thousand[i % thousand.length];
  return {...one, file: `many/${i}-${one.file}`, smallest: null, role: 'smallest', bucket: one.bucket && `${one.bucket}${Math.floor(i / 2)}`};
});

onData('a thousand cases cost what is looked at', reportOf({cases: many}), async (page) => {
  assert.match(await page.textContent('#shown-count'), /^1,000 files/);
  const drawn = () => page.locator('svg.thumbnail').count();
  const nodes = () => page.evaluate(() => document.querySelectorAll('*').length);
  assert.ok(await drawn() <= 40, `${await drawn()} pictures`);
  assert.ok(await nodes() < 8000, `${await nodes()} elements`);
  for (let i = 0; i < 12; ++i) {
    await page.mouse.wheel(0, 3000);
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
    assert.ok(await drawn() <= 60, `${await drawn()} pictures`);
  }
  await page.waitForFunction(() => document.querySelectorAll('.card').length > 16);
  await page.locator('#search').evaluate((field) => field.scrollIntoView({behavior: 'instant'}));
  await page.fill('#search', 'many/77');
  assert.match(await page.textContent('#shown-count'), /^11 files/);
});

onData('a thousand cases are filtered, and only what is looked at is built', reportOf({cases: many}), async (page) => {
  const built = await page.evaluate(() => {
    const search = document.getElementById('search');
    const cards = document.getElementById('cards');
    return ['t', 'ti', 'tie', '', 'known', 'known chip', ''].map((text) => {
      search.value = text;
      search.dispatchEvent(new Event('input'));
      return [cards.children.length, cards.querySelectorAll('*').length];
    });
  });
  for (const [cards, elements] of built) {
    assert.ok(cards > 0 && cards <= 16, `${cards} cards`);
    assert.ok(elements < 1000, `${elements} elements`);
  }
});

const run = fixture('fuzz').result;
const one = (result) => [{path: 'one.json', result}];
const replay = fixture('replay').result;
const wrong = {...sample, verdict: 'subject_wrong', subject: 'mine', oracle: 'clip'};
const headed = [
  ['Nothing unexplained', {fuzz: one(run)}],
  ['1 known defect over budget', {fuzz: one({...run, ledger: [{id: 'one', hits: 9, regimes: {boxes: 9}, over_budget: ['boxes']}]})}],
  ['a run that stopped early', {fuzz: one({...run, stopped_early: true})}],
  ['a run that was interrupted', {fuzz: one({...run, interrupted: true})}],
  ['a vacuous run', {fuzz: one({...run, vacuous: true, failed: true})}],
  ['a run that failed', {fuzz: one({...run, failed: true})}],
  ['2 files unread', {fuzz: one(run), errors: ['a.json: is empty', 'b.json: is empty']}],
  ['Nothing unexplained', {replay: one({...replay, failed: 0, failures: []})}],
  ['2 replayed cases failed', {replay: one({...replay, failed: 0})}],
  ['4 cases left out, 3 files unread', {replay: one({...replay, failed: 0, failures: [], left_out: 4, unread: 3})}],
  ['6 mismatches', {scene: one({rows: [{mismatches: -3}, {mismatches: 3}]})}],
  ['1 breaking point got worse', {stress: one({worse: {a: 1}})}],
  ['Nothing recorded as unexplained', {cases: [sample]}],
  ['1 bucket recorded as wrong', {cases: [wrong]}],
  ['1 bucket recorded as wrong', {cases: [wrong], fuzz: one(run)}],
  ['Nothing unexplained', {cases: [wrong], fuzz: one({...run, subject: 'mine', oracle: 'clip'})}],
  ['1 property recorded as wrong', {cases: [{...sample, property: 'never-empty'}]}],
];
for (const [head, parts] of headed) {
  onData(`the head of a page is "${head}" with ${Object.keys(parts).join(' and ')}`, reportOf(parts), async (page) => {
    assert.equal(await page.textContent('h1'), head);
    assert.equal(await page.getAttribute('h1', 'class'), head.startsWith('Nothing') ? 'good' : 'bad');
  });
}

const unsupported = {fuzz: one({...run, vacuous: true, verdicts: {...run.verdicts, unsupported: run.cases}}),
  replay: one({...replay, failed: 0, failures: [], passed: replay.cases - 2, unsupported: 2})};
onData('what no collider takes is told apart from what passed and from what does not touch', reportOf(unsupported), async (page) => {
  assert.match(await page.textContent('#replay h3'), /195 of 197 cases passed, 2 unsupported/);
  assert.match(await page.textContent('#campaigns'), /vacuous: no case is supported/);
});
