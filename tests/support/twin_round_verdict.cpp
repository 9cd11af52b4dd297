#include "judging/by_curve.hpp"
#include "support/twin_round.hpp"
#include "support/twin_view.hpp"

namespace manifuzz::twin {
namespace {

/// Their difference, rounded, is no matter.
bool is_near(const Real& value, double to, double bound) {
  return Real(to - bound) <= value && value <= Real(to + bound);
}

}  // namespace

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
        distance_(twin.is_deep() ? twin.greatest()->separation : square_root(twin.squared_)),
        least_(Real(twin.radius_) - distance_),
        is_inside_face_(is_apart_ && !twin.is_between_vertices_ && is_in_front_of_inside()) {}

  Kind kind() const {
    if (manifold_.count == 0) {
      return Real(of_clip_.separation + declaration_.least_depth) < least_ ? Kind::missed_contact
                                                                           : Kind::none;
    }
    if (least_ < Real(-of_clip_.separation - declaration_.speculative))
      return Kind::phantom_contact;
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
    const View seen = view(direction);
    return Real(seen.overlap()) / seen.length() + Real(twin_.radius_);
  }
  int deepest() const {
    return manifold_.count > 1 && manifold_.points[1].depth > manifold_.points[0].depth ? 1 : 0;
  }
  /// Whether cores overlap by no more than rounding.
  bool may_be_apart() const {
    return !twin_.greatest() || Real(-of_clip_.separation) <= twin_.greatest()->separation;
  }
  /// Whether cores are apart by so many bounds.
  bool is_apart_by(double bounds) const {
    return is_apart_ && Real(bounds * of_clip_.separation) < distance_;
  }

  /// Whether vertices of the other core, the nearest of all to a face that is as near, are in front
  /// of the face's inside, a separation bound from its ends.
  bool is_in_front_of_inside() const {
    for (const Side side : kSides) {
      for (int i = 0; i < twin_.of(side).size() && twin_.of(side).size() > 1; ++i) {
        if (is_in_front_of_inside(side, i)) return true;
      }
    }
    return false;
  }
  bool is_in_front_of_inside(Side side, int face) const {
    const Real margin(of_clip_.separation);
    const Outline& core = twin_.of(side);
    std::optional<Span> nearest;
    for (const Exact& corner : twin_.of(other(side)).corners) {
      const Ratio above = core.normal(face) * (corner - core.corner(face));
      const Ratio squared = core.edge(face) * core.edge(face);
      if (signed_square(above) < twin_.squared_ * squared) return false;
      if (distance_ + margin < Real(above) / core.length(face)) continue;
      const Real at = Real(core.edge(face) * (corner - core.corner(face))) / core.length(face);
      nearest = nearest ? Span{lesser(nearest->low, at), greater(nearest->high, at)} : Span{at, at};
    }
    return nearest && !nearest->within({margin, core.length(face) - margin}).is_empty();
  }

  /// The depth is the radii less the distance, within a separation's bound; that along the normal
  /// where cores overlap, or rounding may take them to.
  bool has_depth(const Exact& direction) const {
    const double depth = manifold_.points[static_cast<std::size_t>(deepest())].depth;
    if (may_be_apart() && is_near(least_, depth, of_clip_.separation)) return true;
    return !is_apart_by(1) && is_near(depth_along(direction), depth, allowed_.consistency);
  }

  bool is_excess_small(const Exact& direction) const {
    return magnitude(depth_along(direction) - least_) <= Real(allowed_.minimality);
  }
  /// The nearest direction within its bound; or, where that says nothing, the least depth.
  bool is_minimal(const Exact& direction) const {
    if (is_apart_by(1) && !is_inside_face_) {
      const Real bound = Real(of_clip_.normal) +
                         Real(of_clip_.separation) / (distance_ - Real(of_clip_.separation));
      if (is_towards(direction, twin_.apart_, distance_, bound)) return true;
      if (is_apart_by(2)) return is_of_near_vertices(direction, bound);
    }
    return is_excess_small(direction) || is_let_by_bias(direction);
  }
  /// The direction between two vertices that would be the nearest if each moved by a bound.
  bool is_of_near_vertices(const Exact& direction, const Real& bound) const {
    bool is_found = false;
    for (const Exact& from : twin_.a_.corners) {
      for (const Exact& to : twin_.b_.corners) {
        const Exact between = to - from;
        const Real apart = square_root(between * between);
        const Real within = Real(2 * of_clip_.separation) * apart;
        bool are_near = is_towards(direction, between, apart, bound);
        for (const Exact& at : twin_.a_.corners) {
          are_near = are_near && Real(between * (at - from)) <= within;
        }
        for (const Exact& at : twin_.b_.corners) {
          are_near = are_near && Real(between * (to - at)) <= within;
        }
        is_found = is_found || are_near;
      }
    }
    return is_found;
  }
  /// A bias lets a side's best face stand though the other's has less depth.
  bool is_let_by_bias(const Exact& direction) const {
    const TieBias& bias = declaration_.tie_bias;
    if (bias.is_none() || !twin_.greatest_of(Side::a) || !twin_.greatest_of(Side::b)) return false;
    const auto separation = [&](Side side) { return twin_.greatest_of(side)->separation; };
    const Real lead =
        separation(other(bias.towards)) - Real(1 - bias.relative) * separation(bias.towards);
    return std::ranges::any_of(kSides, [&](Side side) {
      const bool is_let = side == bias.towards ? lead <= Real(bias.absolute + of_clip_.separation)
                                               : Real(bias.absolute - of_clip_.separation) < lead;
      const Real off = depth_along(direction) - (Real(twin_.radius_) - separation(side));
      return is_let && magnitude(off) <= Real(allowed_.minimality);
    });
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
    const auto about = [&](const Real& value, double bound) {
      return Span{value - seen.scaled(bound), value + seen.scaled(bound)};
    };
    const Span near = about(seen.place(at), allowed_.along);
    const Real narrow = seen.scaled(allowed_.narrow);
    const auto top = seen.heights(twin_.a_, 1, near, narrow);
    const auto bottom = seen.heights(twin_.b_, -1, near, narrow);
    if (!top || !bottom) return false;
    const Real overlap = seen.scaled(Real(point.depth) - Real(twin_.radius_));
    Span overlaps = about(overlap, allowed_.consistency);
    if (index == deepest() && !is_apart_by(1)) {
      overlaps.low = greater(overlaps.low, Real(seen.overlap()) - seen.scaled(allowed_.minimality));
    }
    const auto surface = [&](double offset) {
      return about(Real(seen.height(at)) - seen.scaled(offset), allowed_.across);
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
    const Ratio farthest = seen.farthest(core, towards);
    const Real behind = seen.scaled(2 * of_clip_.separation);
    std::vector<Seen> all;
    for (int i = 0; i < core.size() && core.size() > 1; ++i) {
      if (behind < Real(towards * (farthest - seen.height(core.corner(i))))) continue;
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
    const Ratio low = std::max(seen.place(a.from), seen.place(b.from));
    const Ratio high = std::min(seen.place(a.to), seen.place(b.to));
    const auto height_at = [&](const Seen& edge, const Ratio& at) -> Ratio {
      const Ratio run = seen.place(edge.to) - seen.place(edge.from);
      const Ratio from = seen.height(edge.from);
      if (run == 0) return from;
      return from + (seen.height(edge.to) - from) * (at - seen.place(edge.from)) / run;
    };
    const auto overlap_at = [&](const Ratio& at) -> Ratio {
      return height_at(a, at) - height_at(b, at);
    };
    const Real cosine = lesser(a.cosine, b.cosine);
    const Real off =
        Real(2 * of_clip_.separation) * (Real(1.0) + Real(1.0) / greater(cosine, 1e-3));
    const Real run = Real(Ratio(high - low)) / seen.length();
    Real shallower = 0.0;
    if (low < high) {
      const Ratio overlap = std::min(overlap_at(low), overlap_at(high));
      shallower = Real(overlap) / seen.length() + Real(twin_.radius_);
    }
    const Real least(declaration_.second_point.least_cosine);
    const Real band(of_clip_.normal + of_clip_.incident_dot);
    const bool may_be_edges = least - band <= cosine;
    const bool are_edges = least + band <= cosine || least <= Real(0.0);
    return {may_be_edges && Real(-2.0) * off <= run && Real(0.0) - off <= shallower,
            are_edges && Real(2.0) * (Real(of_clip_.position) + off) < run && off < shallower, run,
            off};
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
    if (manifold_.count < 2) return declaration_.one_point_enough ? Kind::none : Kind::count;
    const Exact between =
        in_world(manifold_.points[1].position) - in_world(manifold_.points[0].position);
    const Real spanned = magnitude(Real(seen.place(between)) / seen.length());
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
