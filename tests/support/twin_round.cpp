#include "support/twin_round.hpp"

namespace manifuzz::twin {
namespace {

Exact along_edge(const Exact& from, const Ratio& share, const Exact& edge) {
  return {from.x + share * edge.x, from.y + share * edge.y};
}

}  // namespace

RoundTwin::RoundTwin(const PairCase& pair)
    : pair_(pair),
      turn_of_a_(exact(pair.a.pose.rotation)),
      a_(outline(pair.a, exact(pair.a.pose.position))),
      b_(outline(pair.b, exact(pair.a.pose.position))),
      radius_(Ratio(static_cast<double>(pair.a.polygon.radius)) +
              Ratio(static_cast<double>(pair.b.polygon.radius))),
      apart_(b_.corners[0] - a_.corners[0]) {
  squared_ = apart_ * apart_;
  look_at_vertices();
  for (const Side side : kSides) look_at_edges(side);
  for (const Side side : kSides) look_at_faces(side);
  if (!greatest_[0] || (greatest_[1] && greatest_[1]->squared > greatest_[0]->squared)) {
    reference_ = greatest_[1] ? Side::b : Side::a;
  }
}

void RoundTwin::look_at_vertices() {
  for (const Exact& of_a : a_.corners) {
    for (const Exact& of_b : b_.corners) {
      const Exact apart = of_b - of_a;
      if (apart * apart >= squared_) continue;
      squared_ = apart * apart;
      apart_ = apart;
    }
  }
}

void RoundTwin::look_at_edges(Side side) {
  const Outline& core = of(side);
  if (core.size() == 1) return;
  for (int i = 0; i < core.size(); ++i) {
    for (const Exact& corner : of(other(side)).corners) {
      const Ratio share = core.edge(i) * (corner - core.corner(i)) / (core.edge(i) * core.edge(i));
      if (share <= 0 || share >= 1) continue;
      const Exact foot = along_edge(core.corner(i), share, core.edge(i));
      const Exact apart = side == Side::a ? corner - foot : foot - corner;
      if (apart * apart >= squared_) continue;
      squared_ = apart * apart;
      apart_ = apart;
      is_between_vertices_ = false;
    }
  }
}

void RoundTwin::look_at_faces(Side side) {
  const Outline& core = of(side);
  if (core.size() == 1) return;
  for (int i = 0; i < core.size(); ++i) {
    std::optional<Ratio> least;
    for (const Exact& corner : of(other(side)).corners) {
      const Ratio above = core.normal(i) * (corner - core.corner(i));
      if (!least || above < *least) least = above;
    }
    const Ratio squared = signed_square(*least) / (core.edge(i) * core.edge(i));
    auto& greatest = greatest_[side == Side::a ? 0 : 1];
    if (!greatest || squared > greatest->squared) {
      greatest = Greatest{squared, Real(*least) / core.length(i)};
    }
  }
}

}  // namespace manifuzz::twin
