// Finds free places for words in a picture.

const LABEL_HEIGHT = 15;

function labelWidth(text, size = 12) {
  return text.length * size * 0.56 + 4;
}

function overlapArea(box, other) {
  const across = Math.min(box.right, other.right) - Math.max(box.left, other.left);
  const down = Math.min(box.bottom, other.bottom) - Math.max(box.top, other.top);
  return across > 0 && down > 0 ? across * down : 0;
}

// The eight sides of an anchor, `gap` away; screen coordinates, the preferred direction first.
function placesAround([x, y], width, gap, [toX, toY]) {
  const directions = [[1, 0], [-1, 0], [0, -1], [0, 1], [0.8, -0.8], [-0.8, -0.8], [0.8, 0.8], [-0.8, 0.8]];
  const liking = ([dx, dy]) => dx * toX + dy * toY;
  directions.sort((p, q) => liking(q) - liking(p));
  return directions.map(([dx, dy]) => {
    const left = x + dx * gap + (dx > 0 ? 0 : dx < 0 ? -width : -width / 2);
    const top = y + dy * (gap + LABEL_HEIGHT / 2) - LABEL_HEIGHT / 2;
    return { left, right: left + width, top, bottom: top + LABEL_HEIGHT };
  });
}

// Keeps account of the places that are taken, within `frame`.
function makeLabels(frame) {
  const taken = [];
  const cost = (box) => {
    const outside = box.left < frame.left || box.right > frame.right || box.top < frame.top || box.bottom > frame.bottom;
    return taken.reduce((sum, other) => sum + overlapArea(box, other), outside ? 1e4 : 0);
  };
  return {
    take(box) {
      taken.push(box);
    },
    // The best place beside the anchor, in the order of `gaps`; null if all are taken and the label may be left out.
    find(anchor, text, { gaps, towards = [1, -0.2], size = 12, isOptional = false }) {
      const places = gaps.flatMap((gap) => placesAround(anchor, labelWidth(text, size), gap, towards));
      const costs = places.map(cost);
      const least = Math.min(...costs);
      if (least > 0 && isOptional) return null;
      const box = places[costs.indexOf(least)];
      taken.push(box);
      return box;
    },
  };
}
