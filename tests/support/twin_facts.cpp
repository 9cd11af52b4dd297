#include "support/twin_facts.hpp"

namespace manifuzz::twin {
namespace {

Feature feature(bool face, int index) {
  return {face ? Feature::Kind::face : Feature::Kind::vertex, static_cast<unsigned char>(index)};
}

}  // namespace

TwinClip Twin::clip(const TwinCandidate& candidate) const {
  const Side side = candidate.side;
  const Outline& own = of(side);
  const Outline& opposing = of(other(side));
  const int face = candidate.reference;
  const std::array<int, 2> vertices{(candidate.incident + 1) % opposing.size(), candidate.incident};
  const Exact edge = opposing.corner(vertices[1]) - opposing.corner(vertices[0]);
  const Real length = own.length(face);
  const Real radius(radius_);

  // The normal from A to B in A's frame: R^T of it, made unit.
  const Exact turn = exact(pair_.a.pose.rotation);
  const Exact out = own.normal(face);
  const Ratio sign_of_side = side == Side::a ? 1 : -1;
  const Exact local{sign_of_side * (turn.x * out.x + turn.y * out.y),
                    sign_of_side * (turn.x * out.y - turn.y * out.x)};
  const Real local_length = square_root(local * local);

  const auto along = [&](int end) {
    return Real(own.edge(face) *
                (opposing.corner(vertices[static_cast<std::size_t>(end)]) - own.corner(face))) /
               length +
           radius;
  };
  const std::array<Real, 2> at{along(0), along(1)};
  const Real width = length + radius + radius;
  const Real gap = greater(Real(0.0) - greater(at[0], at[1]), lesser(at[0], at[1]) - width);
  const Real edge_length = square_root(edge * edge);

  const Exact face_edge = own.edge(face);
  const Real rise = magnitude(Real(face_edge.x * edge.y - face_edge.y * edge.x)) / length;
  const Real run = magnitude(at[1] - at[0]);
  TwinClip result{candidate,
                  Real(local.x) / local_length,
                  Real(local.y) / local_length,
                  nearest(run / edge_length),
                  nearest(rise / edge_length) / nearest(run / edge_length),
                  nearest(edge_length),
                  width,
                  gap,
                  {}};
  const auto end_at = [&](int end, bool crossing) {
    const Exact from = opposing.corner(vertices[0]);
    const Real& along_end = at[static_cast<std::size_t>(end)];
    const bool before = along_end < Real(0.0);
    Real x = opposing.corner(vertices[static_cast<std::size_t>(end)]).x;
    Real y = opposing.corner(vertices[static_cast<std::size_t>(end)]).y;
    if (crossing) {
      const Real share = ((before ? Real(0.0) : width) - at[0]) / (at[1] - at[0]);
      x = Real(from.x) + share * Real(edge.x);
      y = Real(from.y) + share * Real(edge.y);
    }
    const Real front = (Real(out.x) * (x - Real(own.corner(face).x)) +
                        Real(out.y) * (y - Real(own.corner(face).y))) /
                       length;
    const Ratio scale = turn * turn;
    const Feature of_reference =
        crossing ? feature(false, before ? face : (face + 1) % own.size()) : feature(true, face);
    const Feature of_incident = crossing ? feature(true, candidate.incident)
                                         : feature(false, vertices[static_cast<std::size_t>(end)]);
    result.ends.push_back({(Real(turn.x) * x + Real(turn.y) * y) / Real(scale),
                           (Real(turn.x) * y - Real(turn.y) * x) / Real(scale), radius - front,
                           lesser(magnitude(along_end), magnitude(along_end - width)), crossing,
                           side == Side::a ? FeaturePair{of_reference, of_incident}
                                           : FeaturePair{of_incident, of_reference}});
  };
  if (Real(0.0) < gap) {
    const auto margin = [&](std::size_t end) {
      return lesser(magnitude(at[end]), magnitude(at[end] - width));
    };
    end_at(margin(1) < margin(0) ? 1 : 0, false);
  } else {
    for (const int end : {0, 1}) {
      const Real& a = at[static_cast<std::size_t>(end)];
      end_at(end, a < Real(0.0) || width < a);
    }
  }
  return result;
}

Kind Twin::wrong(const Manifold<double>& manifold, const TwinClip& clip) const {
  if (manifold.count > 0) {
    const Real within(bounds_.normal);
    if (manifold.reference != clip.candidate.side ||
        within * within < squared_distance(manifold.normal, clip.normal_x, clip.normal_y)) {
      return Kind::normal;
    }
    if (Real(bounds_.separation) < clip.gap) return Kind::position;
  }
  for (int i = 0; i < manifold.count; ++i) {
    Kind best = wrong(manifold.points[i], clip, clip.ends[0]);
    if (clip.ends.size() > 1 && best != Kind::none) {
      const Kind second = wrong(manifold.points[i], clip, clip.ends[1]);
      if (second == Kind::none || second > best) best = second;
    }
    if (best != Kind::none) return best;
  }
  for (const End& end : clip.ends) {
    if (may_be_left_out(clip, end)) continue;
    bool found = false;
    for (int i = 0; i < manifold.count && !found; ++i) {
      const Kind kind = wrong(manifold.points[i], clip, end);
      found = kind != Kind::position && kind != Kind::depth;
    }
    if (!found) return Kind::count;
  }
  return Kind::none;
}

Kind Twin::wrong(const Manifold<double>& manifold) const {
  if (manifold.count > 0 && !may_touch()) return Kind::phantom_contact;
  if (manifold.count == 0 && (!may_touch() || (may_be_apart() && !must_touch()))) return Kind::none;
  if (manifold.count == 0 && must_touch()) return Kind::missed_contact;
  Kind best = Kind::missed_contact;
  for (const TwinClip& clip : clips_) {
    Kind kind = wrong(manifold, clip);
    if (kind == Kind::none) return Kind::none;
    if (manifold.count == 0) kind = Kind::missed_contact;
    best = std::max(best, kind);
  }
  return best;
}

bool Twin::contact_boundary() const {
  if (may_touch() && may_be_apart()) return true;
  return std::ranges::any_of(clips_.front().ends, [&](const End& end) {
    return magnitude(end.depth) <= Real(depth_bound(clips_.front(), end));
  });
}

bool Twin::clip_boundary() const {
  const TwinClip& clip = clips_.front();
  return clip.ends.size() < 2 || may_miss(clip) ||
         std::ranges::any_of(
             clip.ends, [&](const End& end) { return end.margin <= Real(bounds_.separation); });
}

}  // namespace manifuzz::twin
