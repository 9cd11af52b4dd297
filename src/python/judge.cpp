#include "judging/judge.hpp"

#include <cmath>
#include <memory>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "judging/by_curve.hpp"
#include "judging/unjudged.hpp"
#include "python/shapes.hpp"

namespace manifuzz {

/// Whoever is judged here is no engine that the ledger knows.
std::vector<LedgerEntry> built_ledger() {
  return {};
}

}  // namespace manifuzz

namespace manifuzz::python {
namespace {

/// What an engine declares, and what its manifolds leave out.
struct Convention {
  Declaration declaration;
  bool in_world = false;  ///< positions and normals; else they are in A's frame
  bool names_reference = false;
  bool names_features = false;
};

/// The enumerations come as their places in `Declaration`'s own, which _judge.py lists.
Convention convention(int scalar, int frame, int normals, int points, int claims, bool clips,
                      double tie_bias, bool takes_angles, bool one_point_enough, bool shares_depth,
                      bool in_world, bool names_reference, bool names_features) {
  return {.declaration = {.name = "python",
                          .scalar = static_cast<ScalarType>(scalar),
                          .frame = static_cast<RoundingFrame>(frame),
                          .takes_angles = takes_angles,
                          .normals = static_cast<NormalsFrom>(normals),
                          .tie_bias = {tie_bias},
                          .min_vertices = 1,
                          .takes_round = true,
                          .claims = static_cast<Claims>(claims),
                          .clips = clips,
                          .points = static_cast<PointsAt>(points),
                          .shares_depth = shares_depth,
                          .one_point_enough = one_point_enough},
          .in_world = in_world,
          .names_reference = names_reference,
          .names_features = names_features};
}

/// The answer by the contract of `Manifold`, as far as it is given.
PartialManifold answer_of(const Manifold<double>& given, const PairCase& pair,
                          const Convention& by) {
  PartialManifold answer{.manifold = given,
                         .names_reference = by.names_reference,
                         .names_features = by.names_features,
                         .has_midpoints = by.declaration.points == PointsAt::midpoint &&
                                          !is_judged_by_curve(by.declaration, pair)};
  Manifold<double>& manifold = answer.manifold;
  if (by.in_world) manifold.normal = local_normal(pair, manifold.normal);
  for (ContactPoint<double>& point : manifold.points) {
    if (by.in_world) point.position = to_local(pair.a.pose, point.position);
    if (!by.names_features) point.features = {};
  }
  order_points(manifold);
  return answer;
}

PlainErrorRecord record_of(const ManifoldError& error) {
  return {error.normal, error.position, error.depth};
}

/// The right manifold that the answer is nearest to: the one that its error is held against, else
/// the first.
Manifold<double> right_manifold(const std::vector<Manifold<double>>& all,
                                const std::optional<ErrorAgainstClip>& nearest) {
  if (nearest) return true_manifold(*nearest->clip);
  return all.empty() ? Manifold<double>{} : all.front();
}

/// The plain errors of an answer that is well formed, and the right manifold nearest to it.
void put_plain_errors(const Admissible& right, const exact::PenetrationCurve& curve,
                      const ColliderAnswer& given, JudgementRecord& record) {
  const exact::Truth& truth = *right.truth;
  const std::vector<Manifold<double>> all = right_manifolds(right);
  record.right_count = static_cast<std::int32_t>(all.size());
  std::optional<ErrorAgainstClip> nearest;
  const bool is_well_formed = !why_malformed(truth.pair(), given);
  if (is_well_formed && is_judged_by_curve(given.declaration, truth.pair())) {
    if (const auto error = error_against(curve, truth, given)) {
      record.of_size = record_of(share_of_size(error->error, truth.size()));
      record.of_bound = record_of(error->of_bound);
      record.of_size.position = record.of_bound.position = NAN;  // the curve has none
    }
  } else if (const auto* const manifold = manifold_in(given.answer); is_well_formed) {
    ClipFiguresCache figures;
    nearest = error_if_right(*manifold, right, figures);
    if (!nearest) nearest = nearest_error(*manifold, right, figures);
    if (nearest) {
      record.of_size = record_of(share_of_size(nearest->error, truth.size()));
      record.of_bound = record_of(nearest->of_bound);
    }
  }
  record.right = right_manifold(all, nearest);
}

JudgementRecord judgement_of(const PairCase& pair, const Manifold<double>& given,
                             const Convention& by) {
  const auto truth = std::make_shared<const exact::Truth>(pair);
  const Admissible right = admissible(truth, by.declaration);
  const Answer answer = whole(answer_of(given, pair, by), right, by.declaration);
  const ColliderAnswer asked{by.declaration, answer};
  const Judgement judgement = judge_alone(truth, asked);
  const exact::PenetrationCurve curve(*truth, exact::skin_of(*truth));
  const Vector2<double> normal = curve.minima(0).front();
  const PlainErrorRecord none{NAN, NAN, NAN};
  Bucket bucket = judgement.bucket;
  // Nobody else is there to be wrong as well, or right in another way.
  if (bucket.verdict == Verdict::both_wrong) bucket.verdict = Verdict::subject_wrong;
  if (bucket.verdict == Verdict::tie) bucket = {};
  JudgementRecord record{.verdict = static_cast<std::uint8_t>(bucket.verdict),
                         .kind = static_cast<std::uint8_t>(bucket.kind),
                         .touching = standing(*truth).touching,
                         .right_count = 0,
                         .separation = exact::separation_of(*truth),
                         .depth = curve.least(),
                         .normal = {normal.x(), normal.y()},
                         .size = truth->size(),
                         .magnitude = judgement.of_subject.magnitude,
                         .bound = judgement.of_subject.bound,
                         .errors = judgement.of_subject.errors.all(),
                         .of_size = none,
                         .of_bound = none,
                         .right = {}};
  put_plain_errors(right, curve, asked, record);
  return record;
}

/// Cases from `begin` to before `end`.
void judge_answers(const In<ShapeRecord<float>>& a, const In<ShapeRecord<float>>& b,
                   const In<PosesRecord<float>>& poses, const In<Manifold<double>>& answers,
                   const Convention& by, const Out<JudgementRecord>& out, std::size_t begin,
                   std::size_t end) {
  const auto shapes_a = records<ShapeRecord<float>>(a);
  const auto shapes_b = records<ShapeRecord<float>>(b);
  const auto placed = records<PosesRecord<float>>(poses);
  const auto given = records<Manifold<double>>(answers);
  const auto judgements = records<JudgementRecord>(out);
  for (std::size_t i = begin; i < end; ++i) {
    const PairCase pair{{checked_shape(shapes_a, i, "cases.a"), checked_pose(placed, i, Side::a)},
                        {checked_shape(shapes_b, i, "cases.b"), checked_pose(placed, i, Side::b)}};
    judgements[i] = judgement_of(pair, given[i], by);
  }
}

template <std::size_t N>
std::vector<std::string> words(const std::array<std::string_view, N>& names) {
  return {names.begin(), names.end()};
}

}  // namespace

void define_judge(nanobind::module_& module) {
  nanobind::class_<Convention>(module, "Convention");
  module.def("convention", convention);
  module.def("judge", judge_answers, Unlocked());
  module.attr("verdicts") = nanobind::cast(words(kVerdictNames));
  module.attr("kinds") = nanobind::cast(words(kKindNames));
  module.attr("components") = nanobind::cast(words(kComponentNames));
}

}  // namespace manifuzz::python
