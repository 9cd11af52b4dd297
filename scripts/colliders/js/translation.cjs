// A minimum translation for manifuzz, to start from: it claims the separation alone, no points.
const place = ({vertices, position: [x, y] = [0, 0], rotation: [c, s] = [1, 0]}) => vertices.map(([u, v]) => [c*u - s*v + x, s*u + c*v + y]);
const faces = (p, q, sign) => p.map(([x, y], i) => {
  const [u, v] = p[(i + 1) % p.length], l = Math.hypot(u - x, v - y), n = [(v - y)/l, (x - u)/l];
  return {depth: -Math.min(...q.map(([z, w]) => n[0]*(z - x) + n[1]*(w - y))), normal: n.map((c) => sign*c)};
});
console.log('{"declaration": {"name": "translation", "scalar": "float64", "claims": "separation", "normals": "world_vertices"}}');
require("readline").createInterface({input: process.stdin}).on("line", (line) => {
  const {a, b} = JSON.parse(line), [p, q] = [place(a), place(b)];
  const least = [...faces(p, q, 1), ...faces(q, p, -1)].reduce((one, other) => other.depth < one.depth ? other : one);
  console.log(JSON.stringify({...least, depth: least.depth + (a.radius ?? 0) + (b.radius ?? 0)}));
});
