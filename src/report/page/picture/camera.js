// A camera is {x, y, scale, width, height}: the world point at the middle, pixels a world length, pixels.
// Everything is clipped to what can be seen before it becomes pixels: browsers draw in floats, which zoom 1e6 exceeds.

const CLOSEST = 1e12;  // times the scale that shows everything: there doubles end
const FARTHEST = 1e-2;

function toScreen(camera, [x, y]) {
  return [(x - camera.x) * camera.scale + camera.width / 2, camera.height / 2 - (y - camera.y) * camera.scale];
}

function toWorld(camera, [x, y]) {
  return [camera.x + (x - camera.width / 2) / camera.scale, camera.y - (y - camera.height / 2) / camera.scale];
}

function fitBox(box, width, height, margin) {
  const [across, up] = [box.right - box.left, box.top - box.bottom];
  const scale = Math.min((width - 2 * margin) / across, (height - 2 * margin) / up);
  return { x: box.left + across / 2, y: box.bottom + up / 2, width, height,
    scale: Number.isFinite(scale) && scale > 0 ? scale : 1 };
}

function zoomAt(camera, [x, y], factor) {
  const share = (1 - 1 / factor) / camera.scale;
  return { ...camera, scale: camera.scale * factor,
    x: camera.x + (x - camera.width / 2) * share, y: camera.y - (y - camera.height / 2) * share };
}

function panBy(camera, right, down) {
  return { ...camera, x: camera.x - right / camera.scale, y: camera.y + down / camera.scale };
}

// Stays within reach of the camera that shows everything.
function limited(camera, whole) {
  const scale = Math.min(Math.max(camera.scale, whole.scale * FARTHEST), whole.scale * CLOSEST);
  return { ...camera, scale };
}

// What can be seen, and a little around it, in the world.
function seenBox(camera, around = 40) {
  const [left, top] = toWorld(camera, [-around, -around]);
  const [right, bottom] = toWorld(camera, [camera.width + around, camera.height + around]);
  return { left, right, bottom, top };
}

function meets(box, other) {
  return box.left <= other.right && other.left <= box.right && box.bottom <= other.top && other.bottom <= box.top;
}

// Whether a piece of an arc looks straight, or cannot be seen.
function flatFor(camera) {
  const seen = seenBox(camera);
  return (from, to, sagitta) =>
    sagitta * camera.scale < 0.15 || !meets(boxOf([from, to], sagitta), seen);
}

// A round length that is about `pixels` wide: 1, 2 or 5 times a power of ten.
function roundLength(camera, pixels) {
  const wanted = pixels / camera.scale;
  const power = 10 ** Math.floor(Math.log10(wanted));
  const factor = [5, 2, 1].find((step) => step * power <= wanted) ?? 1;
  return factor * power;
}
