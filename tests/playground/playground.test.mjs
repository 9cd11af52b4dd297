// The page that scripts/playground writes, opened from its file, MANIFUZZ_PAGE, and the report that holds it, MANIFUZZ_REPORT.
// MANIFUZZ_PROGRAM answers the cases that are downloaded.

import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {readFileSync} from 'node:fs';
import {after, before, test} from 'node:test';

import {startBrowser} from '../page/browser.mjs';

const path = process.env.MANIFUZZ_PAGE;
const witness = new URL('../../corpus/defects/box2d/witness-box2d-no-contact-under-bias.json', import.meta.url);

let browser;
before(async () => {
  browser = await startBrowser();
});
after(() => browser.stop());

/** A test on the page, ready. Whatever it logs, throws or asks the network for is a failure. */
function onPage(name, check, {hash = '', ...options} = {}) {
  test(name, async () => {
    const opened = await browser.open(path, {hash, acceptDownloads: true, ...options});
    await opened.page.locator('html[data-ready]').waitFor();
    await check(opened.page, opened);
    assert.deepEqual(opened.troubles, []);
    await opened.close();
  });
}

function drawn(page) {
  return page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
}

async function placeOf(page, key) {
  const {x, y, width, height} = await page.locator(`[data-handle="${key}"]`).boundingBox();
  return [x + width / 2, y + height / 2];
}

const valueOf = (page, key) => page.getAttribute(`[data-handle="${key}"]`, 'aria-valuetext');

/** The file that the page gives, as text. */
async function downloaded(page) {
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('text=Download the case')]);
  return readFileSync(await download.path(), 'utf8');
}

/** The points that the page shows of a collider: "x, y" and depth of each. */
function shownPoints(page, i) {
  return page.evaluate((index) => [...document.querySelectorAll('.answer')[index].querySelectorAll('tbody tr')]
    .map((row) => [...row.querySelectorAll('td')].map((cell) => cell.textContent)), i);
}

function collided(text, collider) {
  const line = JSON.stringify(JSON.parse(text));
  return JSON.parse(execFileSync(process.env.MANIFUZZ_PROGRAM, ['collide', '--collider', collider, '-'], {input: line}));
}

const brief = (value) => String(Number(Number(value).toPrecision(4)));

/** What the page shows is what the program answers to the case that it gives. */
async function assertShownAsCollided(page) {
  await drawn(page);
  const text = await downloaded(page);
  for (const [i, collider] of ['clip64', 'gjk64'].entries()) {
    const expected = collided(text, collider).points.map(({position, depth}) => [position.map(brief).join(', '), brief(depth)]);
    assert.deepEqual(await shownPoints(page, i), expected, collider);
  }
  return text;
}

onPage('the manifolds shown are the program\'s, before a vertex is dragged and after', async (page) => {
  const before = await assertShownAsCollided(page);
  const [x, y] = await placeOf(page, 'b vertex 0');
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x - 12, y + 14, {steps: 5});
  await page.mouse.up();
  const after = await assertShownAsCollided(page);
  assert.notDeepEqual(JSON.parse(after).b.vertices[0], JSON.parse(before).b.vertices[0]);
  assert.deepEqual(JSON.parse(after).b.vertices.slice(1), JSON.parse(before).b.vertices.slice(1));
});

onPage('a vertex that is dragged through its shape stops where the shape would be none', async (page) => {
  const [x, y] = await placeOf(page, 'a vertex 0');
  const [toX, toY] = await placeOf(page, 'b move 0');
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(toX, toY, {steps: 8});
  await page.mouse.up();
  await assertShownAsCollided(page);
  assert.equal(await page.locator('#trouble').isVisible(), false);
});

onPage('a body, its rotation and its radius are dragged', async (page) => {
  for (const key of ['b move 0', 'b turn 0', 'b radius 0']) {
    const before = await valueOf(page, key);
    const [x, y] = await placeOf(page, key);
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 9, y + 21, {steps: 3});
    await page.mouse.up();
    await drawn(page);
    assert.notEqual(await valueOf(page, key), before, key);
  }
  await assertShownAsCollided(page);
});

onPage('keys move what has the focus by a step, and by ten with shift', async (page) => {
  const position = async () => JSON.parse(await downloaded(page)).b.position;
  const [x, y] = await position();
  await page.focus('[data-handle="b move 0"]');
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('Shift+ArrowUp');
  await drawn(page);
  const [movedX, movedY] = await position();
  assert.ok(Math.abs(movedX - x - 0.1) < 1e-6 && Math.abs(movedY - y - 1) < 1e-6, `${movedX} ${movedY}`);
  assert.match(await page.textContent('#announcer'), /^B position, x /);
  await page.focus('[data-handle="a turn 0"]');
  await page.keyboard.press('ArrowUp');
  await drawn(page);
  assert.equal(await valueOf(page, 'a turn 0'), '1 degrees');
  await assertShownAsCollided(page);
});

onPage('every handle is reached by the tab key', async (page) => {
  await page.focus('#steps button:last-child');
  const seen = new Set();
  for (let i = 0; i < 14; ++i) {
    await page.keyboard.press('Tab');
    seen.add(await page.evaluate(() => document.activeElement.dataset.handle));
  }
  for (const side of ['a', 'b']) {
    for (const kind of ['move 0', 'turn 0', 'radius 0', 'vertex 0', 'vertex 3']) assert.ok(seen.has(`${side} ${kind}`), `${side} ${kind}`);
  }
});

onPage('the address restores case and step', async (page, {url}) => {
  await page.focus('[data-handle="b vertex 1"]');
  await page.keyboard.press('ArrowLeft');
  await page.click('text=4 clip 1');
  await page.waitForFunction(() => location.hash.endsWith('step=3'));
  const [text, address] = [await downloaded(page), await page.evaluate(() => location.hash)];
  const again = await browser.open(path, {hash: address, acceptDownloads: true});
  await again.page.locator('html[data-ready]').waitFor();
  assert.equal(again.url, url);
  assert.equal(await downloaded(again.page), text);
  assert.equal(await again.page.textContent('#steps [aria-pressed=true]'), '4 clip 1');
  await again.close();
});

onPage('each step is shown and said, one after the other', async (page) => {
  const seen = new Set();
  await page.click('text=1 separation');
  for (let i = 0; i < 7; ++i) {
    await drawn(page);
    seen.add(await page.textContent('#step-text'));
    await page.keyboard.press(']');
  }
  assert.equal(seen.size, 7);
});

onPage('a case of the corpus opens, and what is downloaded is that case', async (page) => {
  await page.setInputFiles('#file', witness.pathname);
  await drawn(page);
  const given = JSON.parse(readFileSync(witness, 'utf8'));
  const text = await assertShownAsCollided(page);
  const command = (json) => execFileSync(process.env.MANIFUZZ_PROGRAM, ['collide', '--collider', 'clip64', '-'], {input: JSON.stringify(json)}).toString();
  assert.equal(command(JSON.parse(text)), command({a: given.a, b: given.b}));
});

onPage('what is no case is refused in a line, and the case before stays', async (page) => {
  const before = await downloaded(page);
  const open = async (json, expected) => {
    await page.setInputFiles('#file', {name: 'bad.json', mimeType: 'application/json', buffer: Buffer.from(json)});
    await page.locator('#trouble', {hasText: expected}).waitFor();
    assert.equal(await downloaded(page), before);
  };
  await open('{"a": 1', 'no JSON');
  await open('{"a": {"vertices": [[0,0],[1,"x"],[0,1]]}, "b": {"vertices": [[0,0],[1,0],[0,1]]}}', '$.a.vertices');
  await open('{"a": {"vertices": [[0,0],[0,1],[1,0]]}, "b": {"vertices": [[0,0],[1,0],[0,1]]}}', 'A: ');
  await page.evaluate(() => { location.hash = '#a=m;0;0,0;1,0;0,0;1,0;0,1'; });
  await page.locator('#trouble', {hasText: '$.b.vertices'}).waitFor();
  await page.evaluate(() => { location.hash = '#b=m;0;0,0;1,0;0,0;1,0;0,1'; });
  await page.locator('#trouble', {hasText: '$.a.vertices'}).waitFor();
  assert.equal(await downloaded(page), before);
});

for (const name of ['A capsule on a box', 'A circle and a polygon with round corners', 'Two that planck and Box2D miss', 'Two octagons']) {
  onPage(`the example is answered as the program does: ${name}`, async (page) => {
    await page.selectOption('#cases select', {label: name});
    await assertShownAsCollided(page);
  });
}

onPage('a finger drags a vertex, and a phone shows all of it without scrolling sideways', async (page) => {
  await page.locator('[data-handle="b vertex 0"]').scrollIntoViewIfNeeded();
  const [x, y] = await placeOf(page, 'b vertex 0');
  const before = await valueOf(page, 'b vertex 0');
  const client = await page.context().newCDPSession(page);
  const touch = (type, points) => client.send('Input.dispatchTouchEvent', {type, touchPoints: points});
  await touch('touchStart', [{x, y}]);
  for (let i = 1; i <= 4; ++i) await touch('touchMove', [{x: x - 3 * i, y: y + 3 * i}]);
  await touch('touchEnd', []);
  await drawn(page);
  assert.notEqual(await valueOf(page, 'b vertex 0'), before);
  const [width, room] = await page.evaluate(() => [document.documentElement.scrollWidth, document.documentElement.clientWidth]);
  assert.ok(width <= room, `${width} > ${room}`);
}, {viewport: {width: 360, height: 740}, hasTouch: true, isMobile: true});

test('a report that holds the playground drags its cases in it', async () => {
  const opened = await browser.open(process.env.MANIFUZZ_REPORT, {acceptDownloads: true});
  const {page} = opened;
  await page.locator('#cards a[data-case]').first().click();
  const shown = await page.textContent('.viewer-title .digits');
  await page.click('.viewer-buttons >> text=Drag');
  const held = page.frameLocator('.playground-frame');
  await held.locator('html[data-held]').waitFor();
  const given = await page.evaluate((title) => {
    const {cases} = JSON.parse(document.getElementById('data').textContent);
    return JSON.parse(cases.find(({file}) => title.endsWith(`: ${file}`)).case);
  }, shown);
  await held.locator('[data-handle="a vertex 0"]').waitFor();
  const [download] = await Promise.all([page.waitForEvent('download'), held.locator('text=Download the case').click()]);
  const text = JSON.parse(readFileSync(await download.path(), 'utf8'));
  assert.deepEqual(text.a.vertices, given.a.vertices);
  assert.deepEqual(text.b.vertices, given.b.vertices);
  await page.click('.viewer-buttons >> text=Next');
  await page.locator('#stage svg').waitFor();
  assert.deepEqual(opened.troubles, []);
  await opened.close();
});

onPage('the time of a frame while one drags is said', async (page) => {
  for (const name of ['A box on a box', 'Two octagons', 'A capsule on a box']) {
    await page.selectOption('#cases select', {label: name});
    await drawn(page);
    await page.evaluate(() => {
      globalThis.frames = [];
      new PerformanceObserver((list) => globalThis.frames.push(...list.getEntries().map(({duration}) => duration))).observe({type: 'measure'});
    });
    const [x, y] = await placeOf(page, 'b move 0');
    await page.mouse.move(x, y);
    await page.mouse.down();
    for (let i = 1; i <= 60; ++i) {
      await page.mouse.move(x + 20 * Math.sin(i / 5), y + 20 * Math.cos(i / 5));
      await drawn(page);
    }
    await page.mouse.up();
    const frames = (await page.evaluate(() => globalThis.frames)).sort((p, q) => p - q);
    assert.ok(frames.length > 10);
    console.log(`${name}: a frame takes ${frames[frames.length >> 1].toFixed(1)} ms, at most ${frames.at(-1).toFixed(1)} ms, of ${frames.length}`);
  }
});
