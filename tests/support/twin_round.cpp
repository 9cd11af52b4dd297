#include "support/twin_round.hpp"

#include "judging/by_curve.hpp"

namespace manifuzz::twin {
namespace {

constexpr Side kSides[] = {Side::a, Side::b};

Exact along_edge(const Exact& from, const Ratio& share, const Exact& edge) {
  return {from.x + share * edge.x, from.y + share * edge.y};
}

bool is_near(const Real& one, const Real& another, double bound) {
  return magnitude(one - another) <= Real(bound);
}

/// From one real number to another; empty where the first is greater.
struct Span {
  Real low;
  Real high;

  bool is_empty() const { return high < low; }
  Span within(const Span& other) const {
    return {greater(low, other.low), lesser(high, other.high)};
  }
};

/// Both cores along a direction of any length.
class View {
 public:
  View(const Outline& a, const Outline& b, const Exact& direction)
      : a_(a), b_(b), direction_(direction), length_(square_root(direction * direction)) {}

  Real height(const Exact& p) const { return Real(direction_ * p) / length_; }
  Real place(const Exact& p) const { return Real(tangent() * p) / length_; }
  /// The cosine of the angle with another direction.
  Real cosine(const Exact& other, const Real& length) const {
    return Real(direction_ * other) / (length_ * length);
  }
  /// The largest height of A's core over B's.
  Real overlap() const { return height(farthest(a_, 1)) - height(farthest(b_, -1)); }
  const Exact& farthest(const Outline& core, int sign) const {
    const Exact* most = &core.corners[0];
    for (const Exact& corner : core.corners) {
      if (sign * (direction_ * (corner - *most)) > 0) most = &corner;
    }
    return *most;
  }
  /// The heights of A's top, or with -1 of B's bottom, at these places; none beside the core.
  std::optional<Span> heights(const Outline& core, int sign, const Span& places) const {
    std::vector<Real> all{places.low, places.high};
    for (const Exact& corner : core.corners) {
      const Real at = place(corner);
      if (places.low <= at && at <= places.high) all.push_back(at);
    }
    std::optional<Span> found;
    for (const Real& at : all) {
      const auto here = height_at(core, sign, at);
      if (!here) continue;
      found =
          found ? Span{lesser(found->low, *here), greater(found->high, *here)} : Span{*here, *here};
    }
    return found;
  }

 private:
  Exact tangent() const { return {-direction_.y, direction_.x}; }
  std::optional<Real> height_at(const Outline& core, int sign, const Real& at) const {
    std::optional<Real> most;
    const auto consider = [&](const Real& found) {
      if (!most) most = found;
      most = sign > 0 ? greater(*most, found) : lesser(*most, found);
    };
    for (int i = 0; i < core.size(); ++i) {
      const Real from = place(core.corner(i));
      const Real run = place(core.corner(i + 1)) - from;
      if (at <= from && from <= at) consider(height(core.corner(i)));
      if (sign_of(run) == 0) continue;
      const Real share = (at - from) / run;
      if (share < Real(0.0) || Real(1.0) < share) continue;
      consider(height(core.corner(i)) +
               share * (height(core.corner(i + 1)) - height(core.corner(i))));
    }
    return most;
  }
  static int sign_of(const Real& value) { return sign(value); }

  const Outline& a_;
  const Outline& b_;
  Exact direction_;
  Real length_;
};

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
    const Real separation = Real(*least) / core.length(i);
    if (separation_ && separation <= *separation_) continue;
    separation_ = separation;
    reference_ = side;
  }
}

/// One manifold of one collider.
class RoundVerdict {
 public:
  RoundVerdict(const RoundTwin& twin, const Declaration& declaration,
               const Manifold<double>& manifold)
      : twin_(twin),
        declaration_(declaration),
        manifold_(manifold),
        of_clip_(bounds(twin.pair_, declaration)),
        allowed_(curve_bounds(twin.pair_, declaration, extent(twin.pair_))),
        is_apart_(!twin.is_deep() && twin.squared_ > 0),
        distance_(twin.is_deep() ? *twin.separation_ : square_root(twin.squared_)),
        least_(Real(twin.radius_) - distance_),
        is_inside_face_(is_apart_ && !twin.is_between_vertices_ && is_in_front_of_inside()) {}

  Kind kind() const {
    if (manifold_.count == 0) {
      return Real(of_clip_.separation) < least_ ? Kind::missed_contact : Kind::none;
    }
    if (least_ < Real(-of_clip_.separation)) return Kind::phantom_contact;
    const Exact local{Ratio(manifold_.normal.x()), Ratio(manifold_.normal.y())};
    if (!is_near(square_root(local * local), 1, of_clip_.normal)) return Kind::normal;
    const Exact direction = in_world(manifold_.normal);
    const bool is_consistent = has_depth(direction);
    if (is_consistent && is_minimal(direction)) return kind_of_points(direction);
    const Exact back = in_world(-manifold_.normal);
    if (has_depth(back) && is_minimal(back)) return Kind::reversed;
    if (!is_consistent) return Kind::inconsistent;
    return is_excess_small(direction) ? Kind::normal : Kind::not_minimal;
  }

 private:
  /// An edge along the normal: it faces the other core.
  struct Seen {
    Exact from;
    Exact to;  ///< farther along the tangent
    Real cosine;
  };
  /// What a clip of two edges keeps.
  struct Kept {
    bool is_allowed = false;
    bool is_required = false;
    Real run = 0.0;
    Real off = 0.0;
  };

  Exact in_world(const Vector2<double>& v) const {
    const Exact& turn = twin_.turn_of_a_;
    const Ratio x(v.x());
    const Ratio y(v.y());
    return {turn.x * x - turn.y * y, turn.y * x + turn.x * y};
  }
  View view(const Exact& direction) const { return {twin_.a_, twin_.b_, direction}; }
  Real depth_along(const Exact& direction) const {
    return view(direction).overlap() + Real(twin_.radius_);
  }
  int deepest() const {
    return manifold_.count > 1 && manifold_.points[1].depth > manifold_.points[0].depth ? 1 : 0;
  }
  /// Whether cores overlap by no more than rounding.
  bool may_be_apart() const {
    return !twin_.separation_ || Real(-of_clip_.separation) <= *twin_.separation_;
  }
  /// Whether cores are apart by so many bounds of a separation.
  bool is_apart_by(double bounds) const {
    return is_apart_ && Real(bounds * of_clip_.separation) < distance_;
  }

  /// Whether vertices of the other core, the nearest of all to a face that is as near, are in front
  /// of the face's inside, a separation bound from its ends.
  bool is_in_front_of_inside() const {
    const Real margin(of_clip_.separation);
    for (const Side side : kSides) {
      const Outline& core = twin_.of(side);
      for (int i = 0; i < core.size() && core.size() > 1; ++i) {
        std::optional<Span> nearest;
        bool is_nearest_face = true;
        for (const Exact& corner : twin_.of(other(side)).corners) {
          const Real above = Real(core.normal(i) * (corner - core.corner(i))) / core.length(i);
          if (above < distance_) is_nearest_face = false;
          if (distance_ + margin < above) continue;
          const Real at = Real(core.edge(i) * (corner - core.corner(i))) / core.length(i);
          nearest =
              nearest ? Span{lesser(nearest->low, at), greater(nearest->high, at)} : Span{at, at};
        }
        if (!is_nearest_face || !nearest) continue;
        if (!nearest->within({margin, core.length(i) - margin}).is_empty()) return true;
      }
    }
    return false;
  }

  /// The depth is the radii less the distance, within a separation's bound; that along the normal
  /// where cores overlap, or rounding may take them to.
  bool has_depth(const Exact& direction) const {
    const double depth = manifold_.points[static_cast<std::size_t>(deepest())].depth;
    if (may_be_apart() && is_near(least_, depth, of_clip_.separation)) return true;
    return !is_apart_by(1) && is_near(depth_along(direction), depth, allowed_.consistency);
  }

  bool is_excess_small(const Exact& direction) const {
    return is_near(depth_along(direction), least_, allowed_.minimality);
  }
  /// The nearest direction within its bound; or, where that says nothing, the least depth.
  bool is_minimal(const Exact& direction) const {
    if (is_apart_by(1) && !is_inside_face_) {
      const Real length = square_root(direction * direction);
      const Real x = Real(direction.x) / length - Real(twin_.apart_.x) / distance_;
      const Real y = Real(direction.y) / length - Real(twin_.apart_.y) / distance_;
      const Real bound = Real(of_clip_.normal) +
                         Real(of_clip_.separation) / (distance_ - Real(of_clip_.separation));
      if (x * x + y * y <= bound * bound) return true;
      if (is_apart_by(2)) return false;
    }
    return is_excess_small(direction);
  }

  Kind kind_of_points(const Exact& direction) const {
    for (int i = 0; i < manifold_.count; ++i) {
      if (!has_places(direction, i)) return Kind::witness;
    }
    return kind_of_second(direction);
  }

  /// Whether a point is on either surface, and as deep as places of both cores near its line.
  bool has_places(const Exact& direction, int index) const {
    const View seen = view(direction);
    const ContactPoint<double>& point = manifold_.points[static_cast<std::size_t>(index)];
    const Exact at = in_world(point.position);
    const Real reach(allowed_.along);
    const Span near{seen.place(at) - reach, seen.place(at) + reach};
    const auto top = seen.heights(twin_.a_, 1, near);
    const auto bottom = seen.heights(twin_.b_, -1, near);
    if (!top || !bottom) return false;
    const Real overlap = Real(point.depth) - Real(twin_.radius_);
    const Real slack(allowed_.consistency);
    Span overlaps{overlap - slack, overlap + slack};
    if (index == deepest() && !is_apart_by(1)) {
      overlaps.low = greater(overlaps.low, seen.overlap() - Real(allowed_.minimality));
    }
    const auto surface = [&](double offset) {
      const Real height = seen.height(at) - Real(offset);
      return Span{height - Real(allowed_.across), height + Real(allowed_.across)};
    };
    const auto fits = [&](const Span& upper, const Span& lower) {
      return !upper.is_empty() && !lower.is_empty() &&
             !overlaps.within({upper.low - lower.high, upper.high - lower.low}).is_empty();
    };
    const auto radius_a = static_cast<double>(twin_.pair_.a.polygon.radius);
    const auto radius_b = static_cast<double>(twin_.pair_.b.polygon.radius);
    return !overlaps.is_empty() && (fits(top->within(surface(radius_a)), *bottom) ||
                                    fits(*top, bottom->within(surface(-radius_b))));
  }

  /// The edges that a side may give: at its vertices that are farthest within two bounds the one
  /// more perpendicular to the normal, within the incident dot's bound.
  std::vector<Seen> edges(const Exact& direction, Side side) const {
    const View seen = view(direction);
    const Outline& core = twin_.of(side);
    const int towards = side == Side::a ? 1 : -1;
    const Real farthest = seen.height(seen.farthest(core, towards));
    std::vector<Seen> all;
    for (int i = 0; i < core.size() && core.size() > 1; ++i) {
      if (!is_near(seen.height(core.corner(i)), farthest, 2 * of_clip_.separation)) continue;
      const int faces[] = {(i + core.size() - 1) % core.size(), i};
      const auto cosine = [&](int face) {
        return Real(Ratio(towards)) * seen.cosine(core.normal(face), core.length(face));
      };
      const Real flattest = greater(cosine(faces[0]), cosine(faces[1]));
      for (const int face : faces) {
        if (cosine(face) < flattest - Real(of_clip_.incident_dot)) continue;
        Seen edge{core.corner(face), core.corner(face + 1), cosine(face)};
        if (seen.place(edge.to) < seen.place(edge.from)) std::swap(edge.from, edge.to);
        all.push_back(edge);
      }
    }
    return all;
  }

  /// Between the ends that both edges have along the tangent.
  Kept kept(const View& seen, const Seen& a, const Seen& b) const {
    const Real low = greater(seen.place(a.from), seen.place(b.from));
    const Real high = lesser(seen.place(a.to), seen.place(b.to));
    const auto height_at = [&](const Seen& edge, const Real& at) {
      const Real run = seen.place(edge.to) - seen.place(edge.from);
      const Real from = seen.height(edge.from);
      if (sign(run) == 0) return from;
      return from + (seen.height(edge.to) - from) * (at - seen.place(edge.from)) / run;
    };
    const auto depth_at = [&](const Real& at) {
      return Real(twin_.radius_) + height_at(a, at) - height_at(b, at);
    };
    const Real shallower = low < high ? lesser(depth_at(low), depth_at(high)) : Real(0.0);
    const Real cosine = lesser(a.cosine, b.cosine);
    Kept result;
    result.run = high - low;
    result.off = Real(2 * of_clip_.separation) * (Real(1.0) + Real(1.0) / greater(cosine, 1e-3));
    const Real least(declaration_.second_point.least_cosine);
    const Real band(of_clip_.normal + of_clip_.incident_dot);
    result.is_allowed = least - band <= cosine && Real(-2.0) * result.off <= result.run &&
                        Real(0.0) - result.off <= shallower;
    result.is_required = (least + band <= cosine || least <= Real(0.0)) &&
                         Real(2.0) * (Real(of_clip_.position) + result.off) < result.run &&
                         result.off < shallower;
    return result;
  }

  Kind kind_of_second(const Exact& direction) const {
    const View seen = view(direction);
    bool is_allowed = false;
    bool is_required = true;
    std::optional<Kept> shortest;
    for (const Seen& a : edges(direction, Side::a)) {
      for (const Seen& b : edges(direction, Side::b)) {
        const Kept clip = kept(seen, a, b);
        is_allowed = is_allowed || clip.is_allowed;
        is_required = is_required && clip.is_required;
        if (!shortest || clip.run < shortest->run) shortest = clip;
      }
    }
    if (manifold_.count > 1 && !is_allowed) return Kind::count;
    if (!is_allowed || !is_required) return Kind::none;
    if (manifold_.count < 2) return Kind::count;
    const Real spanned = magnitude(seen.place(in_world(manifold_.points[1].position)) -
                                   seen.place(in_world(manifold_.points[0].position)));
    const Real bound = Real(2.0) * (Real(of_clip_.position) + shortest->off);
    return shortest->run - spanned <= bound ? Kind::none : Kind::extent;
  }

  const RoundTwin& twin_;
  const Declaration& declaration_;
  const Manifold<double>& manifold_;
  Bounds of_clip_;
  CurveBounds allowed_;
  bool is_apart_;
  Real distance_;  ///< of the cores; negative: how deep they overlap
  Real least_;     ///< D*
  bool is_inside_face_;
};

Kind RoundTwin::wrong(const Declaration& declaration, const Manifold<double>& manifold) const {
  return RoundVerdict(*this, declaration, manifold).kind();
}

}  // namespace manifuzz::twin
