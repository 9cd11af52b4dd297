#include "support/twin.hpp"

#include <cmath>
#include <map>

#include "support/real.hpp"

namespace manifuzz {
namespace {

struct Exact {
  Ratio x;
  Ratio y;
};

Exact operator-(const Exact& p, const Exact& q) {
  return {p.x - q.x, p.y - q.y};
}
Ratio operator*(const Exact& p, const Exact& q) {
  return p.x * q.x + p.y * q.y;
}

Exact exact(const Vector2<float>& v) {
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

Outline outline(const Body& body, const Exact& origin) {
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
  double edge_length = 0;
  Real width;
  Real gap;
  std::vector<End> ends;
};

Feature feature(bool face, int index) {
  return {face ? Feature::Kind::face : Feature::Kind::vertex, static_cast<unsigned char>(index)};
}

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

  /// Of each side that the bias leaves open; `all` says which sides are in it already.
  void add_open_sides(const Real& bias, std::vector<TwinCandidate>& all) const {
    const auto has = [&](Side side) {
      return std::ranges::any_of(all, [&](const TwinCandidate& c) { return c.side == side; });
    };
    const bool has_b = has(Side::b);
    const Real lead = of_b_ - of_a_;
    if (!has(Side::a) && lead <= bias + bounds_.separation) add_faces(Side::a, all);
    if (!has_b && bias - bounds_.separation < lead) add_faces(Side::b, all);
  }

  std::vector<TwinCandidate> candidates() const {
    std::vector<TwinCandidate> all;
    add_open_sides(bias_, all);
    if (separation() < Real(bounds_.separation) &&
        std::ranges::any_of(all, [&](const TwinCandidate& c) { return may_be_shallow(clip(c)); })) {
      add_open_sides(0.0, all);
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
    const double tangent = std::sqrt(std::max(0.0, 1 - clip.cosine * clip.cosine)) / clip.cosine;
    return bounds_.separation + std::min(bounds_.separation * tangent, clip.edge_length);
  }
  bool may_miss(const TwinClip& clip) const {
    return Real(-bounds_.separation) <= clip.gap || clip.width <= Real(bounds_.separation);
  }
  bool may_be_left_out(const TwinClip& clip, const End& end) const {
    return end.depth <= Real(depth_bound(clip, end)) || may_miss(clip);
  }
  bool may_be_shallow(const TwinClip& clip) const {
    if (may_miss(clip)) return true;
    const Real deep = Real(radius_) - (clip.candidate.side == Side::a ? of_a_ : of_b_);
    return std::ranges::none_of(clip.ends, [&](const End& end) {
      return (end.crossing || Real(bounds_.separation) < end.margin) && deep <= end.depth;
    });
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
  double bias_;
  Bounds bounds_;
  Real of_a_;
  Real of_b_;
  std::vector<TwinClip> clips_;
};

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

  TwinClip result{candidate,
                  Real(local.x) / local_length,
                  Real(local.y) / local_length,
                  nearest(magnitude(at[1] - at[0]) / edge_length),
                  nearest(edge_length),
                  width,
                  gap,
                  {}};
  const auto end_at = [&](int end, bool crossing) {
    const Exact from = opposing.corner(vertices[0]);
    const Real along_end = at[static_cast<std::size_t>(end)];
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

bool same(const TwinClip& p, const TwinClip& q) {
  return p.candidate == q.candidate;
}

TieClass tie_class(const Twin& subject, const Twin& oracle) {
  const Twin& wider = subject.clips().size() > oracle.clips().size() ? subject : oracle;
  if (wider.clips().empty()) return TieClass::none;
  const TwinCandidate& first = wider.clips().front().candidate;
  for (const TwinClip& clip : wider.clips()) {
    if (clip.candidate.side != first.side || clip.candidate.reference != first.reference) {
      return TieClass::reference;
    }
  }
  if (!std::ranges::equal(subject.clips(), oracle.clips(), same)) return TieClass::reference;
  if (wider.clips().size() > 1) return TieClass::incident;
  const Twin& coarser = subject.bound() > oracle.bound() ? subject : oracle;
  if (coarser.contact_boundary()) return TieClass::contact_boundary;
  return coarser.clip_boundary() ? TieClass::clip_boundary : TieClass::none;
}

/// How two right manifolds differ.
Kind difference(const Manifold<double>& subject, const Manifold<double>& oracle) {
  if (subject.count == 0) return Kind::missed_contact;
  if (oracle.count == 0) return Kind::phantom_contact;
  if (subject.reference != oracle.reference || subject.normal != oracle.normal) return Kind::normal;
  if (subject.count != oracle.count) return Kind::count;
  double apart = 0;
  double deeper = 0;
  for (int i = 0; i < subject.count; ++i) {
    const auto far_from = [&](int j) {
      return (subject.points[i].position - oracle.points[j].position).norm();
    };
    const int nearest = oracle.count > 1 && far_from(1) < far_from(0) ? 1 : 0;
    apart = std::max(apart, far_from(nearest));
    deeper = std::max(deeper, std::abs(subject.points[i].depth - oracle.points[nearest].depth));
  }
  return apart >= deeper ? Kind::position : Kind::depth;
}

}  // namespace

TwinJudgement twin_judge(const PairCase& pair, const Testimony& subject, const Testimony& oracle) {
  TwinJudgement result;
  const Twin for_subject(pair, subject.declaration);
  result.touching = for_subject.touches();
  for (const TwinClip& clip : for_subject.clips()) result.candidates.push_back(clip.candidate);
  const auto* of_subject = std::get_if<Manifold<double>>(&subject.answer);
  const auto* of_oracle = std::get_if<Manifold<double>>(&oracle.answer);
  Bucket& bucket = result.bucket;
  if (!of_subject || !of_oracle) {
    bucket.verdict = Verdict::unsupported;
    return result;
  }
  if (is_ill_posed(pair, bounds(pair, subject.declaration)) ||
      is_ill_posed(pair, bounds(pair, oracle.declaration))) {
    bucket.verdict = Verdict::ill_posed;
    return result;
  }
  const Twin for_oracle(pair, oracle.declaration);
  const Kind wrong_subject = for_subject.wrong(*of_subject);
  const Kind wrong_oracle = for_oracle.wrong(*of_oracle);
  bucket.reference = for_subject.reference();
  const bool both_right = wrong_subject == Kind::none && wrong_oracle == Kind::none;
  if (both_right && of_subject->count == of_oracle->count) {
    bool agree = of_subject->count == 0;
    for (const TwinClip& clip : for_subject.clips()) {
      agree = agree || (for_subject.wrong(*of_subject, clip) == Kind::none &&
                        for_oracle.wrong(*of_oracle, clip) == Kind::none);
    }
    if (agree) return result;
  }
  bucket.tie_class = tie_class(for_subject, for_oracle);
  if (both_right) {
    bucket.verdict = Verdict::tie;
    bucket.kind = difference(*of_subject, *of_oracle);
  } else if (wrong_subject != Kind::none && wrong_oracle != Kind::none) {
    bucket.fault = Fault::both;
    bucket.verdict = Verdict::both_wrong;
    bucket.kind = wrong_subject;
  } else if (wrong_subject != Kind::none) {
    bucket.fault = Fault::subject;
    bucket.verdict = Verdict::subject_wrong;
    bucket.kind = wrong_subject;
  } else {
    bucket.fault = Fault::oracle;
    bucket.verdict = Verdict::oracle_wrong;
    bucket.kind = wrong_oracle;
  }
  return result;
}

}  // namespace manifuzz
