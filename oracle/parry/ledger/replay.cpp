#include "oracle/parry/ledger/replay.hpp"

#include <algorithm>

#include "oracle/parry/ledger/ball.hpp"
#include "oracle/parry/ledger/clip.hpp"

// contact_manifolds_pfm_pfm.rs, contact_manifolds_capsule_capsule.rs and what they call.

namespace manifuzz::parry {
namespace {

/// An eighth of a turn, in utils/consts.rs, for capsules.
constexpr double kCosineOfEighth = 0.92387953251;
constexpr double kSineOfEighth = 0.38268343236;

template <class Real>
void clip_features(Replay<Real>& replay, const Vector2<Real>& on_a, const Vector2<Real>& on_b) {
  replay.faces = {replay.a.shape.support_face(replay.normal),
                  replay.b.shape.support_face(normal_of_b(replay))};
  replay.points = clipped_by(replay, replay.faces);
  replay.is_clipped = !replay.points.empty();
  if (replay.is_clipped) return;
  const Vector2<Real> apart = on_b - on_a;
  replay.points.push_back(
      {on_a, inverse_transform(replay.between, on_b), apart.dot(replay.normal)});
  add_radii(replay, replay.points);
}

template <class Real>
void collide_features(Replay<Real>& replay) {
  const Real radii = replay.prediction + replay.a.shape.radius + replay.b.shape.radius;
  const auto places = searched<Real>(replay, false, radii);
  if (places) clip_features(replay, (*places)[0], (*places)[1]);
}

/// closest_points_segment_segment_with_locations_nD: the shares of both second ends.
template <class Real>
std::array<Real, 2> nearest_shares(const Ends<Real>& a, const Ends<Real>& b) {
  const Vector2<Real> d1 = a[1] - a[0];
  const Vector2<Real> d2 = b[1] - b[0];
  const Vector2<Real> r = a[0] - b[0];
  const auto clamped = [](Real share) { return std::clamp(share, Real(0), Real(1)); };
  const Real aa = d1.dot(d1);
  const Real e = d2.dot(d2);
  const Real f = d2.dot(r);
  if (aa <= kEpsilon<Real> && e <= kEpsilon<Real>) return {0, 0};
  if (aa <= kEpsilon<Real>) return {0, clamped(f / e)};
  const Real c = d1.dot(r);
  if (e <= kEpsilon<Real>) return {clamped(-c / aa), 0};
  const Real b12 = d1.dot(d2);
  const Real ae = aa * e;
  const Real bb = b12 * b12;
  const Real denominator = ae - bb;
  // ulps_eq! with its defaults: within epsilon, or four floats.
  const Real least = std::min(ae, bb);
  Real fourth = least;
  for (int i = 0; i < 4; ++i) fourth = std::nextafter(fourth, std::numeric_limits<Real>::max());
  const bool are_equal = std::abs(ae - bb) <= kEpsilon<Real> || std::max(ae, bb) <= fourth;
  Real s = 0;
  if (denominator > kEpsilon<Real> && !are_equal) s = clamped((b12 * f - c * e) / denominator);
  const Real t = (b12 * s + f) / e;
  if (t < 0) return {clamped(-c / aa), 0};
  if (t > 1) return {clamped((b12 - c) / aa), 1};
  return {s, t};
}

template <class Real>
Vector2<Real> between_ends(const Ends<Real>& ends, Real share) {
  return ends[0] * (Real(1) - share) + ends[1] * share;
}

/// The second point, where cores are nearly parallel and beside each other.
template <class Real>
void add_second(Replay<Real>& replay, const Ends<Real>& a, const Ends<Real>& b,
                const Vector2<Real>& first) {
  for (const ClippedPoint<Real>& end : clipped(a, b, replay.normal)) {
    replay.both_ends.push_back(tracked(replay, end));
  }
  const auto along_a = try_normalize(Vector2<Real>(a[1] - a[0]));
  const auto along_b = try_normalize(Vector2<Real>(b[1] - b[0]));
  if (!along_a || !along_b || replay.both_ends.empty()) return;
  if (!(std::abs(along_a->dot(*along_b)) >= Real(kCosineOfEighth)) ||
      !(std::abs(along_a->dot(replay.normal)) < Real(kSineOfEighth))) {
    return;
  }
  const Vector2<Real> off = replay.both_ends[0].on_a - first;
  replay.points.push_back(off.dot(off) > kEpsilon<Real> * Real(100) ? replay.both_ends[0]
                                                                    : replay.both_ends[1]);
}

template <class Real>
void collide_capsules(Replay<Real>& replay) {
  const Ends<Real> a = face_of(replay.a.shape, 0);
  Ends<Real> b = face_of(replay.b.shape, 0);
  for (Vector2<Real>& end : b) end = transform(replay.between, end);
  const auto [s, t] = nearest_shares(a, b);
  const Vector2<Real> on_a = between_ends(a, s);
  const Vector2<Real> on_b = between_ends(b, t);
  replay.apart = on_b - on_a;
  replay.normal = try_normalize(replay.apart).value_or(Vector2<Real>(0, 1));
  const Real distance = replay.apart.dot(replay.normal);
  if (!(distance <= replay.prediction + replay.a.shape.radius + replay.b.shape.radius)) return;
  replay.points.push_back({on_a, inverse_transform(replay.between, on_b), distance});
  add_second(replay, a, b, on_a);
  add_radii(replay, replay.points);
  add_radii(replay, replay.both_ends);
}

template <class Real>
void collide_balls(Replay<Real>& replay) {
  replay.apart = replay.between.position;
  const Real centres = length_of(replay.apart);
  const Real distance = centres - replay.a.shape.radius - replay.b.shape.radius;
  if (!(distance < replay.prediction)) return;
  replay.normal = centres != 0 ? Vector2<Real>(replay.apart / centres) : Vector2<Real>(0, 1);
  replay.points.push_back({replay.normal * replay.a.shape.radius,
                           normal_of_b(replay) * replay.b.shape.radius, distance});
}

template <class Real>
std::vector<TrackedPoint<Real>> points_of(const Replay<Real>& replay, const Ends<Real>& a,
                                          const Ends<Real>& b) {
  std::vector<TrackedPoint<Real>> points;
  for (const ClippedPoint<Real>& point : clipped(a, b, replay.normal)) {
    points.push_back(tracked(replay, point));
  }
  add_radii(replay, points);
  return points;
}

}  // namespace

template <class Real>
std::vector<TrackedPoint<Real>> clipped_by(const Replay<Real>& replay,
                                           const std::array<std::size_t, 2>& faces) {
  return points_of(replay, face_of(replay.a.shape, faces[0]), face_of_b(replay, faces[1]));
}

template <class Real>
std::vector<TrackedPoint<Real>> clipped_at(const Replay<Real>& replay, Side side, std::size_t end,
                                           double bound) {
  Ends<Real> along = face_of(replay.a.shape, replay.faces[0]);
  Ends<Real> other = face_of_b(replay, replay.faces[1]);
  if (side == Side::b) std::swap(along, other);
  const Vector2<Real> tangent(-replay.normal.y(), replay.normal.x());
  const Real run = (along[1] - along[0]).dot(tangent);
  // Where it is beside the other by roundings alone it is beneath its end.
  const std::array<Real, 2> range{other[0].dot(tangent), other[1].dot(tangent)};
  const auto [low, high] = std::minmax(range[0], range[1]);
  const Real place = along[end].dot(tangent);
  const Real beneath = std::clamp(place, low, high);
  if (!(static_cast<double>(std::abs(beneath - place)) <= bound)) return {};
  const Vector2<Real> moved = along[end] + (beneath - place) * tangent;
  const Vector2<Real> opposite = point_at(other, range, beneath);
  const ClippedPoint<Real> point =
      side == Side::a ? ClippedPoint<Real>{moved, opposite} : ClippedPoint<Real>{opposite, moved};
  std::vector<TrackedPoint<Real>> points{tracked(replay, point)};
  add_radii(replay, points);
  if (static_cast<double>(std::abs(run)) <= bound) return points;
  // From a face that is not along the normal parry took this end itself, or the other's beside it.
  std::vector<TrackedPoint<Real>> all = clipped_by(replay, replay.faces);
  if (beneath == place || all.empty()) return {};
  all[place < beneath ? 0 : 1] = points[0];
  return all;
}

template <class Real>
std::optional<Replay<Real>> replayed_with_signs(const Replay<Real>& replay) {
  if (!replay.epa_with_signs || replay.route != Route::features) return std::nullopt;
  const EpaResult<Real>& epa = *replay.epa_with_signs;
  if (epa.end == EpaEnd::lost) return std::nullopt;
  Replay<Real> mended = replay;
  mended.points.clear();
  mended.normal = epa.normal;
  clip_features(mended, epa.on_a, epa.on_b);
  return mended;
}

template <class Real>
std::optional<Replay<Real>> replayed_after_step(const Replay<Real>& replay) {
  const auto& after = replay.gjk.after;
  if (!after || (replay.route != Route::features && replay.route != Route::ball)) {
    return std::nullopt;
  }
  Replay<Real> mended = replay;
  mended.points.clear();
  mended.normal = after->direction;
  if (replay.route == Route::ball) {
    collide_ball_at(mended, {after->on_a, false});
  } else {
    clip_features(mended, after->on_a, after->on_b);
  }
  return mended;
}

template <class Real>
std::array<Real, 2> clipped_runs(const Replay<Real>& replay) {
  const Vector2<Real> tangent(-replay.normal.y(), replay.normal.x());
  const auto run = [&](const Ends<Real>& ends) {
    return std::abs(ends[1].dot(tangent) - ends[0].dot(tangent));
  };
  return {run(face_of(replay.a.shape, replay.faces[0])), run(face_of_b(replay, replay.faces[1]))};
}

template <class Real>
void collide(Replay<Real>& replay) {
  const Shape<Real>& a = replay.a.shape;
  const Shape<Real>& b = replay.b.shape;
  if (a.is_ball() && b.is_ball()) {
    replay.route = Route::balls;
    collide_balls(replay);
  } else if (a.is_ball() || b.is_ball()) {
    replay.route = Route::ball;
    collide_ball(replay);
  } else if (a.is_capsule() && b.is_capsule()) {
    replay.route = Route::capsules;
    collide_capsules(replay);
  } else {
    collide_features(replay);
  }
}

template <class Real>
Replay<Real> replayed(const Placed<Real>& a, const Placed<Real>& b, Real prediction) {
  Replay<Real> replay{
      .a = a, .b = b, .between = composed(inverse(a.pose), b.pose), .prediction = prediction};
  collide(replay);
  return replay;
}

template <class Real>
Replay<Real> replayed_with_unrounded_feet(const Replay<Real>& replay) {
  Replay<Real> mended{.a = replay.a,
                      .b = replay.b,
                      .between = replay.between,
                      .prediction = replay.prediction,
                      .is_swapped = replay.is_swapped,
                      .is_foot_unrounded = true};
  collide(mended);
  return mended;
}

template Replay<float> replayed(const Placed<float>&, const Placed<float>&, float);
template Replay<double> replayed(const Placed<double>&, const Placed<double>&, double);
template Replay<float> replayed_with_unrounded_feet(const Replay<float>&);
template Replay<double> replayed_with_unrounded_feet(const Replay<double>&);
template std::optional<Replay<float>> replayed_after_step(const Replay<float>&);
template std::optional<Replay<double>> replayed_after_step(const Replay<double>&);
template std::optional<Replay<float>> replayed_with_signs(const Replay<float>&);
template std::optional<Replay<double>> replayed_with_signs(const Replay<double>&);
template std::array<float, 2> clipped_runs(const Replay<float>&);
template std::array<double, 2> clipped_runs(const Replay<double>&);
template std::vector<TrackedPoint<float>> clipped_by(const Replay<float>&,
                                                     const std::array<std::size_t, 2>&);
template std::vector<TrackedPoint<double>> clipped_by(const Replay<double>&,
                                                      const std::array<std::size_t, 2>&);
template std::vector<TrackedPoint<float>> clipped_at(const Replay<float>&, Side, std::size_t,
                                                     double);
template std::vector<TrackedPoint<double>> clipped_at(const Replay<double>&, Side, std::size_t,
                                                      double);

}  // namespace manifuzz::parry
