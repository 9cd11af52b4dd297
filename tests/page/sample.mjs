// Data as the program makes it, from the corpus of this repository: what the tests show.

import {readdirSync, readFileSync} from 'node:fs';
import {join} from 'node:path';
import {fileURLToPath} from 'node:url';

export const top = fileURLToPath(new URL('../../', import.meta.url));

function brief(value) {
  return Number.isFinite(value) ? String(Number(value.toPrecision(4))) : 'not finite';
}

function worldVertices(body, origin) {
  const [c, s] = body.rotation ?? [1, 0];
  const [x, y] = body.position ?? [0, 0];
  return body.vertices.map(([u, v]) => [c * u - s * v + (x - origin[0]), s * u + c * v + (y - origin[1])]);
}

function greatestSeparation(vertices, other) {
  return Math.max(...vertices.map((from, i) => {
    const to = vertices[(i + 1) % vertices.length];
    const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
    const normal = [(to[1] - from[1]) / length, (from[0] - to[0]) / length];
    return Math.min(...other.map((point) => normal[0] * (point[0] - from[0]) + normal[1] * (point[1] - from[1])));
  }));
}

function diameter(vertices) {
  return Math.max(...vertices.flatMap((p) => vertices.map((q) => Math.hypot(p[0] - q[0], p[1] - q[1]))));
}

/** The index that the features at `side` name: a face itself, or the face between two vertices. */
function faceIndex(points, side, count) {
  const features = points.map((point) => point.features?.[side] ?? '');
  const face = features.find((feature) => feature.startsWith('f'));
  if (face) return Number(face.slice(1));
  const vertices = features.map((feature) => Number(feature.slice(1)));
  return vertices.find((v) => vertices.includes((v + 1) % count)) ?? null;
}

/** Of the two faces at a vertex, the one that looks most against `normal`. */
function facingAt(vertices, vertex, normal) {
  const towards = (face) => {
    const [from, to] = [vertices[face], vertices[(face + 1) % vertices.length]];
    const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
    return ((to[1] - from[1]) * normal[0] - (to[0] - from[0]) * normal[1]) / length;
  };
  const before = (vertex + vertices.length - 1) % vertices.length;
  return towards(before) < towards(vertex) ? before : vertex;
}

function incidentIndex(points, side, body, normal) {
  const index = faceIndex(points, side, body.vertices.length);
  const feature = points[0].features?.[side] ?? '';
  if (index !== null || !normal || !feature.startsWith('v')) return index;
  const outward = side === 0 ? normal.map((x) => -x) : normal;
  return facingAt(worldVertices(body, body.position ?? [0, 0]), Number(feature.slice(1)), outward);
}

function manifoldOf(manifold, given, origin) {
  const points = manifold.points ?? [];
  if (points.length === 0) return {normal: null, reference: null, face: null, edge: null, points: []};
  const reference = manifold.reference ?? null;
  const side = reference === 'b' ? 1 : 0;
  const bodies = [given.a, given.b];
  return {
    normal: manifold.normal ?? null, reference,
    face: faceIndex(points, side, bodies[side].vertices.length),
    edge: incidentIndex(points, 1 - side, bodies[1 - side], manifold.normal),
    points: points.map(({position, depth, features}) => ({
      position: [position[0] - origin[0], position[1] - origin[1]], world: position, depth, features,
    })),
  };
}

function answerWords(manifold) {
  if (manifold.unsupported) return `unsupported: ${manifold.unsupported}`;
  const depths = (manifold.points ?? []).map(({depth}) => brief(depth));
  if (depths.length === 0) return 'no contact';
  return depths.length === 1 ? `1 point, depth ${depths[0]}` : `2 points, depths ${depths.join(' and ')}`;
}

function answersOf(given, origin) {
  const {subject, oracle, manifolds = []} = given.expect ?? {};
  const role = (role, name, all) => ({
    role, name, words: all.length > 0 ? answerWords(all[0]) : 'no answer', version: given.found?.versions?.[name] ?? '',
    manifolds: all.filter((manifold) => !manifold.unsupported).map((manifold) => manifoldOf(manifold, given, origin)),
  });
  const by = (name) => manifolds.filter(({collider}) => collider === name);
  return [role('truth', 'judge', by('judge')), role('subject', subject ?? 'clip', by(subject)),
    role('oracle', oracle ?? 'box2d', by(oracle))];
}

function sentenceOf(verdict, bucket, overlap) {
  if (verdict === 'known') return `oracle wrong (known): ${(bucket ?? '').split('/')[2]?.replaceAll('_', ' ')}, true overlap ${brief(overlap)}`;
  return verdict === 'tie' ? 'tie, both are right: two faces or edges are nearer than rounding can tell' : verdict;
}

/** A case of the corpus, as the page takes it. */
export function caseOf(given, file) {
  const origin = given.a.position ?? [0, 0];
  const bodies = [given.a, given.b].map((body) => ({
    vertices: worldVertices(body, origin), radius: body.radius ?? 0, position: body.position ?? [0, 0],
  }));
  const [a, b] = bodies.map(({vertices}) => vertices);
  const separation = Math.max(greatestSeparation(a, b), greatestSeparation(b, a));
  const {subject = 'clip', oracle = 'box2d', verdict = '', bucket = '', severity = null} = given.expect ?? {};
  const worst = file.endsWith('.worst.json');
  return {
    file, role: worst ? 'worst' : 'smallest', smallest: worst ? file.replace('.worst.json', '.json') : null,
    bucket, verdict, regime: given.found?.regime ?? '', subject, oracle,
    sentence: sentenceOf(verdict, bucket, -separation), note: given.note ?? '', severity,
    magnitude: verdict && verdict !== 'agree' ? Math.abs(separation) / Math.min(diameter(a), diameter(b)) : null,
    count: null, property: given.property ?? '', found: given.found ?? null,
    commands: [`manifuzz show ${file} --svg picture.svg`], case: JSON.stringify(given),
    separation, total_radius: bodies[0].radius + bodies[1].radius, size: Math.min(diameter(a), diameter(b)),
    extent: diameter(a) + diameter(b), origin, bodies, answers: answersOf(given, origin), map: null, map_words: [],
  };
}

function filesUnder(folder) {
  return readdirSync(join(top, folder), {withFileTypes: true}).flatMap((entry) => {
    const path = `${folder}/${entry.name}`;
    if (entry.isDirectory()) return filesUnder(path);
    return path.endsWith('.json') ? [path] : [];
  }).sort();
}

/** Every case of the corpus. */
export function corpusCases() {
  return filesUnder('corpus').map((file) => caseOf(JSON.parse(readFileSync(join(top, file), 'utf8')), file));
}

/** A page of these parts and nothing else. */
export function reportOf(parts = {}) {
  return {
    format: 'manifuzz/report/1', version: '0.1.0', command: 'manifuzz report corpus run.json --output page.html',
    sources: [{path: 'corpus', kind: 'cases', cases: parts.cases?.length ?? 0}], errors: [],
    fuzz: [], replay: [], bench: [], stress: [], scene: [], cases: [], ...parts,
  };
}

/** What a measuring command wrote, kept beside the tests. */
export function fixture(kind) {
  const path = new URL(`fixtures/${kind}.json`, import.meta.url);
  return {path: `${kind}.json`, result: JSON.parse(readFileSync(path, 'utf8'))};
}
