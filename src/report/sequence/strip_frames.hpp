#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "campaign/sequences/sequence_case.hpp"
#include "exact/placed.hpp"
#include "report/picture/drawing.hpp"
#include "report/sequence/sequence_report.hpp"

namespace manifuzz {

/// So many frames a filmstrip has at most.
inline constexpr std::size_t kStripMax = 6;

/// The frames that tell what happened, in order: all where they are few; else the one that decides
/// and its neighbours, where its point was born, the first, and births.
std::vector<std::size_t> frames_that_matter(const JudgedSequence& judged);

/// One frame, in world directions and lengths, seen from A's position.
struct StripFrame {
  std::size_t number = 0;
  PairCase pair;
  exact::RoughPair polygons{};
  std::array<Rim, 2> rims{};        ///< A's and B's
  std::vector<KeptPoint> points{};  ///< as they were answered
  TrueOverlap truth{};
  const FrameJudgement* verdict = nullptr;  ///< none where nothing was judged

  bool decides = false;  ///< the verdict on all frames

  /// Whether anything is wrong in it.
  bool is_wrong() const { return verdict != nullptr && verdict->kind != Kind::none; }
  /// The shape with its radius.
  const Rim& rim(Side side) const { return rims[static_cast<std::size_t>(side)]; }
  /// Where a point's anchor on that side is.
  Point anchor(const KeptPoint& point, Side side) const {
    const Vector2<double> rotation = pair[side].pose.rotation.cast<double>();
    return origin(side) +
           rotate<double>(rotation, side == Side::a ? point.anchor_a : point.anchor_b);
  }
  /// Where the body's own frame stands.
  Point origin(Side side) const {
    return (pair[side].pose.position - pair.a.pose.position).cast<double>();
  }
  /// Where a point is drawn: between its anchors.
  Point place(std::size_t i) const {
    return (anchor(points[i], Side::a) + anchor(points[i], Side::b)) / 2;
  }
  /// From a body's middle to its first corner, so that a turn is seen.
  std::pair<Point, Point> spoke(Side side) const;
  /// The angle between a point's normal and the nearest true one.
  double degrees_off(std::size_t i) const;
  /// Whether it is this point with which something is wrong, and whether it is its normal.
  bool is_to_blame(std::size_t i) const;
  bool has_wrong_normal(std::size_t i) const;
  /// Around both bodies.
  Box whole() const {
    const Box a = box_around_rim(rims[0]);
    const Box b = box_around_rim(rims[1]);
    return box_around({{a.x, a.y}, {a.right(), a.bottom()}, {b.x, b.y}, {b.right(), b.bottom()}});
  }
  /// What is looked at: the kept points, or where the bodies are.
  Point middle() const {
    if (points.empty()) return whole().center();
    Point sum(0, 0);
    for (std::size_t i = 0; i < points.size(); ++i) sum += place(i);
    return sum / static_cast<double>(points.size());
  }
};

/// That frame of the sequence, which the frame refers to.
StripFrame strip_frame(const JudgedSequence& judged, std::size_t number);

/// The bodies, the kept points with their normals, and what they are called.
void draw_strip_frame(Svg& svg, const StripFrame& frame, const View& view);

/// The angle between two directions, in degrees.
double degrees_between(const Point& p, const Point& q);

/// The true normal that is nearest to this one.
Point nearest_truth(const StripFrame& frame, const Point& normal);

}  // namespace manifuzz
