// How far an answer is from the truth: from the right manifold that is nearest to it.

function nearestPoint(point, manifold) {
  let nearest = null;
  for (const right of manifold.points) {
    if (!isPoint(right.position) || !isPoint(point.position)) continue;
    const position = distance(right.position, point.position);
    if (nearest === null || position < nearest.position) nearest = { position, depth: Math.abs((right.depth ?? NaN) - (point.depth ?? NaN)) };
  }
  return nearest;
}

function angleBetween(p, q) {
  if (!isPoint(p) || !isPoint(q)) return null;
  return Math.atan2(Math.abs(cross(p, q)), p[0] * q[0] + p[1] * q[1]);
}

function manifoldDifference(manifold, right) {
  const points = manifold.points.map((point) => nearestPoint(point, right));
  const count = manifold.points.length - right.points.length;
  const worst = greatest(points.map((one) => one?.position)) ?? Infinity;
  return { points, count, normal: angleBetween(manifold.normal, right.normal), worst };
}

// Of the nearest right manifold; null where there is nothing to compare.
function differenceToTruth(one, answer) {
  const [manifold] = answer.manifolds;
  const rights = answerOf(one, "truth")?.manifolds ?? [];
  if (!manifold || rights.length === 0 || answer.role === "truth") return null;
  const all = rights.map((right) => manifoldDifference(manifold, right));
  const cost = (difference) => [Math.abs(difference.count), difference.worst];
  return all.reduce((best, next) => {
    const [[p, q], [r, s]] = [cost(best), cost(next)];
    return r < p || (r === p && s < q) ? next : best;
  });
}

function differenceInWords(difference, one) {
  if (!difference) return "";
  if (difference.points.length === 0) return difference.count === 0 ? "as the truth" : `leaves out ${counted(-difference.count, "point")}`;
  const parts = [];
  if (difference.count !== 0) parts.push(`${counted(Math.abs(difference.count), "point")} too ${difference.count > 0 ? "many" : "few"}`);
  if (difference.worst === 0) parts.push("position as the truth");
  else if (Number.isFinite(difference.worst)) {
    const share = one.size > 0 ? `, ${short(difference.worst / one.size)} of the size` : "";
    parts.push(`position off by ${short(difference.worst)}${share}`);
  }
  const depth = greatest(difference.points.map((point) => point?.depth));
  if (depth !== null) parts.push(`depth by ${short(depth)}`);
  if (Number.isFinite(difference.normal)) parts.push(`normal by ${short(difference.normal)} rad`);
  return parts.join("; ");
}
