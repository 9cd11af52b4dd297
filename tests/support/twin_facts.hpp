#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "support/real.hpp"
#include "support/twin.hpp"

// What is true of a case, and what is right, as the twin has it.

namespace manifuzz::twin {

struct Exact {
  Ratio x;
  Ratio y;
};

inline Exact operator-(const Exact& p, const Exact& q) {
  return {p.x - q.x, p.y - q.y};
}
inline Ratio operator*(const Exact& p, const Exact& q) {
  return p.x * q.x + p.y * q.y;
}

inline Exact exact(const Vector2<float>& v) {
  return {Ratio(static_cast<double>(v.x())), Ratio(static_cast<double>(v.y()))};
}

struct Outline {
  std::vector<Exact> corners;
  std::vector<Real> lengths;      ///< of the faces
  std::vector<Real> separations;  ///< of the faces

  int size() const { return static_cast<int>(corners.size()); }
  const Exact& corner(int i) const { return corners[static_cast<std::size_t>(i % size())]; }
  Exact edge(int i) const { return corner(i + 1) - corner(i); }
  Exact normal(int i) const { return {edge(i).y, -edge(i).x}; }
  const Real& length(int i) const { return lengths[static_cast<std::size_t>(i)]; }
  const Real& separation(int i) const { return separations[static_cast<std::size_t>(i)]; }
};

inline Outline outline(const Body& body, const Exact& origin) {
  const Exact turn = exact(body.pose.rotation);
  const Exact place = exact(body.pose.position) - origin;
  Outline result;
  for (int i = 0; i < body.polygon.count; ++i) {
    const Exact v = exact(body.polygon.vertices[i]);
    result.corners.push_back(
        {turn.x * v.x - turn.y * v.y + place.x, turn.y * v.x + turn.x * v.y + place.y});
  }
  for (int i = 0; i < result.size(); ++i) {
    result.lengths.push_back(square_root(result.edge(i) * result.edge(i)));
  }
  return result;
}

struct End {
  Real x;
  Real y;
  Real depth;
  Real margin;
  bool crossing = false;
  FeaturePair features;
};

struct TwinClip {
  TwinCandidate candidate;
  Real normal_x;
  Real normal_y;
  double cosine = 0;
  double tangent = 0;
  double edge_length = 0;
  Real width;
  Real gap;
  std::vector<End> ends;
};

/// A case, for a collider with this declaration.
class Twin {
 public:
  Twin(const PairCase& pair, const Declaration& declaration)
      : pair_(pair),
        outlines_{outline(pair.a, exact(pair.a.pose.position)),
                  outline(pair.b, exact(pair.a.pose.position))},
        radius_(Ratio(static_cast<double>(pair.a.polygon.radius)) +
                Ratio(static_cast<double>(pair.b.polygon.radius))),
        bias_(declaration.tie_bias),
        bounds_(bounds(pair, declaration)),
        of_a_(greatest(Side::a)),
        of_b_(greatest(Side::b)) {
    if (!may_touch()) return;
    for (const TwinCandidate& c : candidates()) clips_.push_back(clip(c));
  }

  Real separation() const { return greater(of_a_, of_b_); }
  bool touches() const { return separation() <= Real(radius_); }
  bool must_touch() const { return separation() < Real(-bounds_.separation); }
  bool may_touch() const { return separation() <= Real(radius_) + bounds_.separation; }
  bool may_be_apart() const { return Real(radius_) - bounds_.separation <= separation(); }
  Side reference() const { return of_a_ < of_b_ ? Side::b : Side::a; }
  const std::vector<TwinClip>& clips() const { return clips_; }

  Kind wrong(const Manifold<double>& manifold) const;
  Kind wrong(const Manifold<double>& manifold, const TwinClip& clip) const;
  bool contact_boundary() const;
  bool clip_boundary() const;
  double bound() const { return bounds_.separation; }

 private:
  const Outline& of(Side side) const { return outlines_[side == Side::a ? 0 : 1]; }

  Real greatest(Side side) {
    Outline& own = outlines_[side == Side::a ? 0 : 1];
    const Outline& opposing = of(other(side));
    for (int i = 0; i < own.size(); ++i) {
      Ratio least = own.normal(i) * (opposing.corner(0) - own.corner(i));
      for (const Exact& v : opposing.corners) {
        least = std::min<Ratio>(least, own.normal(i) * (v - own.corner(i)));
      }
      own.separations.push_back(Real(least) / own.length(i));
    }
    Real most = own.separation(0);
    for (const Real& separation : own.separations) most = greater(most, separation);
    return most;
  }

  void add_faces(Side side, std::vector<TwinCandidate>& all) const {
    const Real least_allowed = (side == Side::a ? of_a_ : of_b_) - bounds_.separation;
    const Outline& opposing = of(other(side));
    for (int i = 0; i < of(side).size(); ++i) {
      if (of(side).separation(i) < least_allowed) continue;
      std::vector<Real> dots;
      dots.reserve(static_cast<std::size_t>(opposing.size()));
      for (int j = 0; j < opposing.size(); ++j) {
        dots.push_back(Real(of(side).normal(i) * opposing.normal(j)) /
                       (of(side).length(i) * opposing.length(j)));
      }
      Real least = dots.front();
      for (const Real& dot : dots) least = lesser(least, dot);
      for (int j = 0; j < opposing.size(); ++j) {
        if (dots[static_cast<std::size_t>(j)] <= least + bounds_.incident_dot) {
          all.push_back({side, i, j});
        }
      }
    }
  }

  /// Adds a candidate of each side that the bias leaves open; `all` says which sides are in it
  /// already.
  void add_open_sides(const TieBias& bias, std::vector<TwinCandidate>& all) const {
    const auto has = [&](Side side) {
      return std::ranges::any_of(all, [&](const TwinCandidate& c) { return c.side == side; });
    };
    const std::array before{has(Side::a), has(Side::b)};
    const bool is_a = bias.towards == Side::a;
    const Real lead = (is_a ? of_b_ : of_a_) - Real(1 - bias.relative) * (is_a ? of_a_ : of_b_);
    for (const Side side : {Side::a, Side::b}) {
      const bool is_open = side == bias.towards
                               ? lead <= Real(bias.absolute) + Real(bounds_.separation)
                               : Real(bias.absolute) - Real(bounds_.separation) < lead;
      if (is_open && !before[side == Side::a ? 0 : 1]) add_faces(side, all);
    }
  }

  std::vector<TwinCandidate> candidates() const {
    std::vector<TwinCandidate> all;
    add_open_sides(bias_, all);
    if (separation() < Real(bounds_.separation) &&
        std::ranges::any_of(all, [&](const TwinCandidate& c) { return may_be_empty(clip(c)); })) {
      add_open_sides({}, all);
    }
    return all;
  }

  TwinClip clip(const TwinCandidate& candidate) const;
  bool near_plane(const TwinClip& clip, const End& end) const {
    return end.crossing || clip.ends.size() < 2 || end.margin <= Real(bounds_.separation);
  }
  double position_bound(const TwinClip& clip, const End& end) const {
    if (!near_plane(clip, end)) return bounds_.position;
    return bounds_.position + std::min(bounds_.separation / clip.cosine, clip.edge_length);
  }
  double depth_bound(const TwinClip& clip, const End& end) const {
    if (!near_plane(clip, end)) return bounds_.separation;
    return bounds_.separation + std::min(bounds_.separation * clip.tangent, clip.edge_length);
  }
  bool may_miss(const TwinClip& clip) const {
    return Real(-bounds_.separation) <= clip.gap || clip.width <= Real(bounds_.separation);
  }
  bool may_be_left_out(const TwinClip& clip, const End& end) const {
    return end.depth <= Real(depth_bound(clip, end)) || may_miss(clip);
  }
  bool may_be_empty(const TwinClip& clip) const {
    return std::ranges::all_of(clip.ends,
                               [&](const End& end) { return may_be_left_out(clip, end); });
  }
  static Real squared_distance(const Vector2<double>& p, const Real& x, const Real& y) {
    const Real dx = Real(p.x()) - x;
    const Real dy = Real(p.y()) - y;
    return dx * dx + dy * dy;
  }
  Kind wrong(const ContactPoint<double>& point, const TwinClip& clip, const End& end) const {
    const Real within = Ratio(position_bound(clip, end));
    if (within * within < squared_distance(point.position, end.x, end.y)) return Kind::position;
    if (Real(depth_bound(clip, end)) < magnitude(Real(point.depth) - end.depth)) return Kind::depth;
    if (point.features == end.features || clips_.size() > 1 || clip.ends.size() < 2 ||
        end.margin <= within) {
      return Kind::none;
    }
    const Real dx = clip.ends[1].x - clip.ends[0].x;
    const Real dy = clip.ends[1].y - clip.ends[0].y;
    const Real apart = dx * dx + dy * dy;
    return Real(4.0) * within * within < apart ? Kind::features : Kind::none;
  }

  const PairCase& pair_;
  std::array<Outline, 2> outlines_;
  Ratio radius_;
  TieBias bias_;
  Bounds bounds_;
  Real of_a_;
  Real of_b_;
  std::vector<TwinClip> clips_;
};

}  // namespace manifuzz::twin
