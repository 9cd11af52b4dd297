// The viewer of one case: what it shows, how it zooms, what it copies.

import assert from 'node:assert/strict';
import {after, before, test} from 'node:test';

import {startBrowser} from './browser.mjs';
import {corpusCases, reportOf} from './sample.mjs';

const cases = corpusCases();
const witness = cases.find(({file}) => file.includes('thin-overlap-box2d'));
const tie = cases.find(({verdict, answers}) => verdict === 'tie' && answers[0].manifolds.length > 1
  && answers.every(({manifolds}) => manifolds[0]?.points.length === 2));
const hashOf = ({file}) => `#case=${encodeURIComponent(file)}`;

let browser;
let path;
before(async () => {
  browser = await startBrowser();
  path = browser.write(reportOf({cases}));
});
after(() => browser.stop());

/** A test on a case that was opened by its link. */
function onCase(name, one, check, options = {}) {
  test(name, async () => {
    const opened = await browser.open(path, {hash: hashOf(one), ...options});
    await opened.page.locator('#stage .target').first().waitFor({state: 'attached'});
    await check(opened.page, opened);
    assert.deepEqual(opened.troubles, []);
    await opened.close();
  });
}

/** Where a contact point of `role` is drawn, in the window. */
async function drawnAt(page, role = 'subject', index = 0) {
  const box = await page.locator(`[data-key="point ${role} ${index}"]`).boundingBox();
  return [box.x + box.width / 2, box.y + box.height / 2];
}

/** Waits until all that was asked for is drawn. */
function drawn(page) {
  return page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
}

/** What the picture was drawn with: the world's place in its middle, and pixels a world length. */
async function cameraOf(page) {
  await drawn(page);
  const [x, y, scale] = (await page.getAttribute('#stage svg', 'data-camera')).split(' ').map(Number);
  return {x, y, scale};
}

/** Zooms 2^20 times by the wheel, the pointer on a contact point; a pointer is no more exact than a pixel, so it aims anew. */
async function zoomToPoint(page) {
  for (let i = 0; i < 20; ++i) {
    const at = await drawnAt(page);
    await page.mouse.move(...at);
    await page.mouse.wheel(0, -240);
    await drawn(page);
    near(await drawnAt(page), at, 2);
  }
}

function near(actual, expected, tolerance) {
  actual.forEach((value, i) => assert.ok(Math.abs(value - expected[i]) <= tolerance, `${actual} is not within ${tolerance} of ${expected}`));
}

onCase('a link opens its case, and says everything of it', witness, async (page) => {
  const text = await page.textContent('#viewer');
  for (const part of [witness.file, witness.note, 'no contact', 'leaves out 1 point', '100.0009994506836', witness.bucket, '32,168']) {
    assert.ok(text.includes(part), part);
  }
});

onCase('the penetration curve stands beside it, drawn and in words', witness, async (page) => {
  const curve = page.locator('img[alt^="How deep they overlap"]');
  await curve.scrollIntoViewIfNeeded();
  assert.ok(await curve.evaluate((image) => image.decode().then(() => image.naturalWidth > 0)));
  assert.match(await page.textContent('#viewer'), /the least depths?[:,]/);
});

onCase('a point says its collider, position, depth and features', tie, async (page) => {
  await drawn(page);
  await page.mouse.move(...await drawnAt(page));
  const text = await page.textContent('#tooltip');
  const point = tie.answers[1].manifolds[0].points[0];
  for (const part of ['clip (subject)', String(point.world[0]), String(point.world[1]), String(point.depth), point.features[0], point.features[1]]) {
    assert.ok(text.includes(part), `${part} in ${text}`);
  }
});

onCase('vertices and faces are explained too, by keys alone', witness, async (page) => {
  await page.locator('#stage svg').focus();
  const seen = new Set();
  for (let i = 0; i < 16; ++i) {
    await page.keyboard.press('.');
    seen.add((await page.textContent('#tooltip strong')).split(',')[0]);
  }
  for (const title of ['clip (subject)', 'judge (truth)', 'A vertex 1', 'B vertex 2', 'A face 0', 'B face 2']) assert.ok(seen.has(title), title);
});

onCase('points can be reached by the tab key, and keep the focus while the picture moves', witness, async (page) => {
  await page.locator('#stage svg').focus();
  await page.keyboard.press('Tab');
  const key = () => page.evaluate(() => document.activeElement.dataset.key);
  assert.match(await key(), /^point /);
  const before = await key();
  await page.keyboard.press('Shift+ArrowLeft');
  await drawn(page);
  assert.equal(await key(), before);
  assert.ok(await page.locator('#tooltip').isVisible());
});

onCase('the wheel zooms a million times at the pointer, and points stay where they belong', tie, async (page) => {
  const start = await cameraOf(page);
  await zoomToPoint(page);
  const camera = await cameraOf(page);
  assert.ok(camera.scale / start.scale > 1e6 && camera.scale / start.scale < 1.1e6);
  // Its place, computed from the camera that the page says it has.
  const stage = await page.locator('#stage').boundingBox();
  const [x, y] = tie.answers[1].manifolds[0].points[0].position;
  const at = [stage.x + stage.width / 2 + (x - camera.x) * camera.scale, stage.y + stage.height / 2 - (y - camera.y) * camera.scale];
  near(await drawnAt(page), at, 0.6);
});

onCase('nothing is drawn far outside the picture, however close', tie, async (page) => {
  await drawn(page);
  await zoomToPoint(page);
  assert.ok(await page.locator('#stage .edge').count() > 0);
  const greatest = await page.evaluate(() => Math.max(...[...document.querySelectorAll('#stage svg [d]')]
    .flatMap((node) => node.getAttribute('d').match(/-?[\d.]+(e[+-]?\d+)?/g)).map((value) => Math.abs(Number(value)))));
  assert.ok(greatest < 5000, String(greatest));
});

onCase('dragging moves, and a double click, 0 and the button reset', witness, async (page) => {
  await drawn(page);
  const start = await drawnAt(page);
  const stage = await page.locator('#stage').boundingBox();
  const [x, y] = [stage.x + 120, stage.y + 120];
  const drag = async () => {
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 40, y + 25, {steps: 4});
    await page.mouse.up();
    await drawn(page);
    near(await drawnAt(page), [start[0] + 40, start[1] + 25], 1);
  };
  for (const reset of [() => page.mouse.dblclick(x, y), () => page.keyboard.press('0'), () => page.click('text=Whole')]) {
    await drag();
    await reset();
    await drawn(page);
    near(await drawnAt(page), start, 0.6);
  }
});

onCase('two fingers zoom', witness, async (page) => {
  const before = (await cameraOf(page)).scale;
  await page.evaluate(() => {
    const svg = document.querySelector('#stage svg');
    svg.setPointerCapture = () => {};
    const touch = (type, pointerId, clientX) => svg.dispatchEvent(new PointerEvent(type, {pointerId, clientX, clientY: 400, bubbles: true, button: 0}));
    touch('pointerdown', 11, 300);
    touch('pointerdown', 12, 400);
    touch('pointermove', 12, 500);
    touch('pointerup', 11, 300);
    touch('pointerup', 12, 500);
  });
  const after = (await cameraOf(page)).scale;
  assert.ok(Math.abs(after / before - 2) < 1e-9, String(after / before));
});

onCase('the picture fits the contact on demand', witness, async (page) => {
  await page.click('text=Fit points');
  await drawn(page);
  const [stage, at] = [await page.locator('#stage').boundingBox(), await drawnAt(page)];
  assert.ok(at[0] > stage.x && at[0] < stage.x + stage.width && at[1] > stage.y && at[1] < stage.y + stage.height);
});

onCase('an overlap too thin to see is brought close', witness, async (page) => {
  await drawn(page);
  const width = async () => (await page.locator('#stage .overlap').boundingBox()).width;
  assert.ok(await width() < 1);
  await page.click('text=Fit thickness');
  await drawn(page);
  assert.ok(await width() > 100);
});

onCase('switches hide and show what they name', tie, async (page) => {
  const parts = {truth: '.mark.truth', subject: '.mark.subject', oracle: '.mark.oracle', planes: '#stage .plane', numbers: '#stage text.vertex'};
  await drawn(page);
  for (const [name, selector] of Object.entries(parts)) {
    const all = await page.locator(`#stage ${selector.replace('#stage ', '')}`).count();
    assert.ok(all > 0, name);
    await page.locator(`input[data-show=${name}]`).uncheck();
    await drawn(page);
    assert.equal(await page.locator(`#stage ${selector.replace('#stage ', '')}`).count(), 0, name);
    await page.locator(`input[data-show=${name}]`).check();
    await drawn(page);
    assert.equal(await page.locator(`#stage ${selector.replace('#stage ', '')}`).count(), all, name);
  }
});

onCase('each of several right manifolds is stepped to', tie, async (page) => {
  const rights = tie.answers[0].manifolds.length;
  assert.equal(await page.textContent('#right-count'), `right manifold 1 of ${rights}`);
  const truth = () => page.textContent('.answer.truth');
  const first = await truth();
  await page.click('[aria-label="next right manifold"]');
  assert.equal(await page.textContent('#right-count'), `right manifold 2 of ${rights}`);
  assert.notEqual(await truth(), first);
  await page.keyboard.press('[');
  assert.equal(await truth(), first);
});

onCase('a finger that taps a point gets it explained', witness, async (page) => {
  await drawn(page);
  await page.touchscreen.tap(...await drawnAt(page));
  await page.locator('#tooltip:visible', {hasText: /clip \(subject\)/}).waitFor();
}, {hasTouch: true});

onCase('points of the next case are explained too', tie, async (page) => {
  for (let i = 0; i < 2; ++i) {
    await drawn(page);
    await page.locator('#stage .target.point').last().focus();
    assert.ok(await page.locator('#tooltip').isVisible());
    await page.keyboard.press('j');
    assert.ok(!await page.locator('#tooltip').isVisible());
  }
});

onCase('j and k go through the cases, and the address follows', cases[3], async (page) => {
  const title = () => page.textContent('.viewer-title p');
  const first = await title();
  await page.keyboard.press('j');
  assert.notEqual(await title(), first);
  const hash = await page.evaluate(() => location.hash);
  assert.ok((await title()).includes(decodeURIComponent(hash.slice('#case='.length))));
  await page.keyboard.press('k');
  assert.equal(await title(), first);
  await page.keyboard.press('Escape');
  // The dialog tells that it was closed some time after it is gone from sight.
  await page.waitForFunction(() => location.hash === '');
  assert.ok(!await page.locator('#viewer').isVisible());
});

const clipboard = (page) => page.evaluate(() => navigator.clipboard.readText());

onCase('the command, the case and the file name are copied', witness, async (page) => {
  await page.locator('.details .copy-line button').first().click();
  await page.locator('.copy.done').waitFor();
  assert.equal(await clipboard(page), witness.commands[0]);
  await page.getByText('Copy the case').click();
  await page.waitForFunction(async (text) => await navigator.clipboard.readText() === text, witness.case);
  await page.getByText('Copy the file name').click();
  await page.waitForFunction(async (text) => await navigator.clipboard.readText() === text, witness.file);
}, {permissions: ['clipboard-read', 'clipboard-write']});

onCase('copying works where the page may not use the clipboard itself', witness, async (page) => {
  await page.locator('.details .copy-line button').first().click();
  await page.locator('.copy.done').waitFor();
  await page.keyboard.press('Escape');
  await page.focus('#search');
  await page.keyboard.press('Control+V');
  assert.equal(await page.inputValue('#search'), witness.commands[0]);
}, {init: () => Object.defineProperty(navigator, 'clipboard', {value: undefined})});

test('a link to a case that is not there leaves the page as it is', async () => {
  const {page, troubles, close} = await browser.open(path, {hash: '#case=%E0%A4%A'});
  assert.ok(await page.locator('.card').first().isVisible());
  assert.ok(!await page.locator('#viewer').isVisible());
  assert.deepEqual(troubles, []);
  await close();
});
