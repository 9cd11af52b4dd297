#include "report/picture/labels.hpp"

#include <algorithm>
#include <limits>

namespace manifuzz {
namespace {

constexpr double kImpossible = std::numeric_limits<double>::infinity();
constexpr double kStep = 4;        // between the places that are tried
constexpr double kPadding = 3;     // around the text
constexpr double kLeaderMin = 14;  // nearer labels need no line to what they name

/// What a place costs, in pixels of distance.
constexpr double kPerLineCovered = 40;
constexpr double kPerLineCrossed = 12;
constexpr double kWrongDirection = 14;
constexpr double kPerLabelCrossed = 60;

double box_height(double font_size) {
  return font_size + 2 * kPadding;
}

std::optional<Segment> leader_to(const Label& label, const Box& box) {
  if (distance(box, label.anchor) < kLeaderMin) return std::nullopt;
  return Segment(nearest(box, label.anchor), label.anchor);
}

bool cross_each_other(const Segment& s, const Segment& t) {
  const auto side = [](const Segment& line, const Point& p) {
    return cross<double>(line.second - line.first, p - line.first);
  };
  return side(s, t.first) * side(s, t.second) < 0 && side(t, s.first) * side(t, s.second) < 0;
}

}  // namespace

bool LabelLayer::is_blocked(const Box& box) const {
  return std::any_of(blocked_.begin(), blocked_.end(),
                     [&](const Box& other) { return other.overlaps(box); });
}

bool LabelLayer::is_free(const Box& box) const {
  return !is_blocked(box) && std::none_of(lines_.begin(), lines_.end(), [&](const Segment& line) {
    return inside(line, box).has_value();
  });
}

double LabelLayer::cost(const Label& label, const Box& box, double best) const {
  const double far = distance(box, label.anchor);
  if (far > label.reach) return kImpossible;
  const Point away = box.center() - label.anchor;
  const double turned = 1 - label.towards.dot(away) / std::max(length(away), 1.0);
  double sum = far + kWrongDirection * turned;
  if (sum >= best) return kImpossible;
  if (is_blocked(box)) return kImpossible;
  const auto leader = leader_to(label, box);
  for (const Segment& line : lines_) {
    if (inside(line, box)) sum += kPerLineCovered;
    if (leader && cross_each_other(*leader, line)) sum += kPerLineCrossed;
    if (sum >= best) return kImpossible;
  }
  if (!leader) return sum;
  for (const Placed& other : placed_) {
    if (inside(*leader, other.box)) sum += kPerLabelCrossed;
  }
  return sum;
}

bool LabelLayer::place(const Label& label) {
  const double width = text_width(label.text, label.font) + 2 * kPadding;
  const double height = box_height(label.font.size);
  const Point from = label.anchor - Point(width, height) / 2;
  double best = kImpossible;
  Box chosen;
  const auto try_at = [&](int i, int j) {
    const Box box{from.x() + kStep * i, from.y() + kStep * j, width, height};
    if (!frame_.contains(box)) return;
    const double price = cost(label, box, best);
    if (price >= best) return;
    best = price;
    chosen = box;
  };
  // Rings around the anchor, until the next one is farther than what is found.
  const double farthest = std::min(label.reach, frame_.width + frame_.height);
  const double half = std::max(width, height) / 2;
  for (int ring = 0; kStep * ring - half < std::min(best, farthest); ++ring) {
    for (int i = -ring; i <= ring; ++i) {
      const int step = std::abs(i) == ring ? 1 : 2 * ring;
      for (int j = -ring; j <= ring; j += step) try_at(i, j);
    }
  }
  if (best == kImpossible) return false;
  const auto leader = leader_to(label, chosen);
  if (leader) avoid(*leader);
  block(chosen);
  placed_.push_back({label, chosen, leader});
  return true;
}

void LabelLayer::draw(Svg& svg) const {
  for (const Placed& placed : placed_) {
    if (placed.leader) svg.line(*placed.leader, "leader");
  }
  for (const Placed& placed : placed_) {
    const Box& box = placed.box;
    svg.box(box, "label", 3);
    svg.text({box.x + kPadding, box.bottom() - kPadding - 0.2 * placed.label.font.size},
             placed.label.text, placed.label.font, placed.label.css);
  }
}

}  // namespace manifuzz
