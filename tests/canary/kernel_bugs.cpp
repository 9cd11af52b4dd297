#include <algorithm>
#include <limits>
#include <memory>
#include <string_view>

#include "canary/blame.hpp"
#include "canary/company.hpp"
#include "canary/planted.hpp"
#include "canary/search.hpp"
#include "clipping/collide.hpp"
#include "corpus/shrink.hpp"
#include "generating/regime.hpp"
#include "oracle/box2d/box2d.hpp"
#include "own_colliders/own_colliders.hpp"

// Bugs planted into the kernels: a manifold must differ from the clean code's, or a hint must
// change an answer. What the judge says of such a manifold is reported first.

namespace manifuzz::canary {
namespace {

constexpr std::uint64_t kKernelCases = 40'000;

/// Something that a kernel promises and does not keep.
struct Broken {
  std::string promise;
  std::string kernel{};            ///< whose manifold it is about, where it is about one
  std::optional<Answer> answer{};  ///< that manifold
  Declaration declaration{};
};

/// About a case, the number of which tells in which company, by which bias and by which motion.
using Look = std::function<std::optional<Broken>(std::uint64_t number, const PairCase& pair)>;

std::optional<Noticed> noticed_by_judge(const Look& look, std::uint64_t number,
                                        const PairCase& pair) {
  static const Collider oracle = make_box2d();
  const auto broken = look(number, pair);
  if (!broken || !broken->answer) return std::nullopt;
  const Answer of_oracle = oracle.collide(pair);
  const auto blamed = blame(pair, ColliderAnswer{broken->declaration, *broken->answer},
                            ColliderAnswer{oracle.declaration, of_oracle});
  if (!blamed) return std::nullopt;
  return Noticed{"judge of " + broken->kernel, to_string(blamed->bucket)};
}

std::optional<Noticed> noticed_by_promise(const Look& look, std::uint64_t number,
                                          const PairCase& pair) {
  const auto broken = look(number, pair);
  if (!broken) return std::nullopt;
  return Noticed{broken->promise, broken->promise};
}

using NoticeOf = std::optional<Noticed> (*)(const Look&, std::uint64_t, const PairCase&);

std::optional<Sighting> search_with(const Haystack& haystack, const Look& look, NoticeOf notice) {
  return search(
      haystack,
      [&](std::uint64_t number, const PairCase& pair) { return notice(look, number, pair); },
      [&](std::uint64_t number, const PairCase& pair, const Noticed& noticed) {
        return shrink(pair, [&](const PairCase& smaller) {
          const auto again = notice(look, number, smaller);
          return again && again->look == noticed.look;
        });
      });
}

/// What the judge sees first, which is asked about that many cases at most (it need not see every
/// bug), then the first promise that is not kept. `look` at all of them, `look_at_manifold` is
/// cheaper.
void add_kernel(const Bug& bug, const Look& look, const Look& look_at_manifold,
                std::uint64_t judged_max) {
  const std::string_view name = bug.name;
  const bool is_of_round = name.starts_with("circles_") || name.starts_with("round_");
  const auto search_both = [=](Haystack haystack) {
    const Acting acting(bug);
    haystack.regimes = is_of_round ? round_regimes() : polygon_regimes();
    Haystack to_judge = haystack;
    to_judge.cases_max = std::min(haystack.cases_max, haystack.first + judged_max);
    auto judged = search_with(to_judge, look_at_manifold, noticed_by_judge);
    auto broken = search_with(haystack, look, noticed_by_promise);
    if (!judged) return broken;
    if (broken) judged->noticed.by += ", " + broken->noticed.by;
    return judged;
  };
  add_planted_bug(
      {.name = bug.name, .cases_max = kKernelCases, .search = search_both, .in_kernel = true});
}

/// Every other round of the regimes.
float tie_bias(std::uint64_t number) {
  return number / polygon_regimes().size() % 2 == 0 ? 0.0F : 0.0005F;
}

/// What the clean code says of a pair.
PairAnswers clean_answers(const PairCase& pair, float bias) {
  const ConvexPolygon<float>& a = pair.a.polygon;
  const auto b = transform(relative_pose(pair.a.pose, pair.b.pose), pair.b.polygon);
  if (is_round(pair)) {
    const auto manifold = clipping::collide_in_frame(a, b, bias);
    const bool touches = clipping::collide_in_frame(a, b).count > 0;
    return {manifold, touches, touches, 0};
  }
  constexpr float no_limit = std::numeric_limits<float>::infinity();
  const float separation = std::max(clipping::greatest_separation(a, b, no_limit).separation,
                                    clipping::greatest_separation(b, a, no_limit).separation);
  const bool touches = !(separation > a.radius + b.radius);
  return {clipping::collide_in_frame(a, b, bias), touches, touches, separation};
}

/// Names the answer about a pair that is wrong, or nothing: where shapes do not touch, any
/// separation by more than the total radius is right, and where round ones do, any that is not.
std::string difference(const PairAnswers& said, const PairAnswers& right, const PairCase& pair) {
  if (said.manifold != right.manifold) return "pair";
  if (said.touches != right.touches) return "touches";
  const float total_radius = pair.a.polygon.radius + pair.b.polygon.radius;
  const bool separation_is_right = right.touches
                                       ? said.separation == right.separation ||
                                             (is_round(pair) && said.separation <= total_radius)
                                       : said.separation > total_radius;
  return separation_is_right && said.separation_touches == right.touches ? "" : "separation";
}

/// The pair, a little farther, turned, another pair, the pair again, far apart, and again.
std::vector<PairCase> motion(std::uint64_t number, const PairCase& pair) {
  Random random(number, "motion", 0);
  const auto farther = [&](double sizes) {
    PairCase moved = pair;
    const double x = random.uniform(-1, 1) * sizes * size(pair);
    const double y = random.uniform(-1, 1) * sizes * size(pair);
    moved.b.pose.position += Vector2<double>(x, y).cast<float>();
    return moved;
  };
  const PairCase near = farther(0.1);
  PairCase turned = pair;
  turned.b.pose.rotation = companions()[number % companions().size()].b.pose.rotation;
  const PairCase& other = companions()[(number + 7) % companions().size()];
  return {pair, near, turned, other, pair, farther(2), pair, near};
}

/// By answers without hints.
std::optional<Broken> broken_by_pair(AskPair ask, std::uint64_t number, const PairCase& pair) {
  const float bias = tie_bias(number);
  const PairAnswers said = ask({&pair, 1}, bias, false)[0];
  const std::string what = difference(said, clean_answers(pair, bias), pair);
  if (what.empty()) return std::nullopt;
  if (what != "pair") return Broken{what + " differs from clip"};
  return Broken{"pair differs from clip", "pair", manifold_cast<double>(said.manifold),
                make_clip(static_cast<double>(bias)).declaration};
}

/// By answers that are others with hints than without.
std::optional<Broken> broken_by_hints(AskPair ask, std::uint64_t number, const PairCase& pair) {
  const std::vector<PairCase> steps = motion(number, pair);
  const std::vector<PairAnswers> without = ask(steps, tie_bias(number), false);
  const std::vector<PairAnswers> with_hints = ask(steps, tie_bias(number), true);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const std::string what = difference(with_hints[i], without[i], steps[i]);
    if (!what.empty()) return Broken{"a hint misleads " + what};
  }
  return std::nullopt;
}

template <class Scalar>
Answer answer(Manifold<Scalar> manifold, Scalar local_per_world) {
  for (ContactPoint<Scalar>& point : manifold.points) point.position *= local_per_world;
  return manifold_cast<double>(manifold);
}

/// Whether the pair, wherever it stands, has another manifold than by the clean code.
template <class Scalar>
std::optional<Broken> broken_by_batch(typename PlantedBatch<Scalar>::Collide collide,
                                      const std::string& kernel, const Collider& clean,
                                      std::uint64_t number, const PairCase& pair) {
  const Scalar bias = tie_bias(number);
  const auto placed = clipping::placed_pair<Scalar>(pair);
  const auto right =
      clipping::collide(placed.a, placed.b, relative_pose(placed.pose_a, placed.pose_b), bias);
  const auto all = company(number, placed);
  std::vector<Manifold<Scalar>> manifolds(all.size());
  collide(all, bias, manifolds.data());
  for (const std::size_t i : {std::size_t{0}, all.size() / 2, all.size() - 1}) {
    if (manifolds[i] == right) continue;
    return Broken{kernel + " differs from " + clean.declaration.name, kernel,
                  answer(manifolds[i], placed.local_per_world),
                  clean.with_tie_bias(static_cast<double>(bias)).declaration};
  }
  return std::nullopt;
}

/// Asked in one of four ways, in turn; each regime in all of them, by either bias.
std::optional<Broken> broken_by_batches(const PlantedBatch<float>& batch,
                                        const PlantedBatch<double>& batch64, std::uint64_t number,
                                        const PairCase& pair) {
  static const Collider clip = make_clip();
  static const Collider clip64 = make_clip64();
  switch ((number + number / polygon_regimes().size() / 2) % 4) {
    case 0:
      return broken_by_batch<float>(batch.from_indices, "batch", clip, number, pair);
    case 1:
      return broken_by_batch<float>(batch.packed, "batch packed", clip, number, pair);
    case 2:
      return broken_by_batch<double>(batch64.from_indices, "batch64", clip64, number, pair);
    default:
      return broken_by_batch<double>(batch64.packed, "batch64 packed", clip64, number, pair);
  }
}

}  // namespace

bool add_pairs(const std::vector<Bug>& bugs, AskPair ask) {
  const auto look_at_manifold = [ask](std::uint64_t number, const PairCase& pair) {
    return broken_by_pair(ask, number, pair);
  };
  const auto look = [ask](std::uint64_t number, const PairCase& pair) {
    auto broken = broken_by_pair(ask, number, pair);
    return broken ? broken : broken_by_hints(ask, number, pair);
  };
  for (const Bug& bug : bugs) add_kernel(bug, look, look_at_manifold, kKernelCases / 4);
  return true;
}

bool add_batches(const std::vector<Bug>& bugs, const PlantedBatch<float>& batch,
                 const PlantedBatch<double>& batch64) {
  const auto look = [batch, batch64](std::uint64_t number, const PairCase& pair) {
    return broken_by_batches(batch, batch64, number, pair);
  };
  for (const Bug& bug : bugs) {
    add_kernel(bug, look, look, kKernelCases / 20);  // twenty-three pairs a case
  }
  return true;
}

}  // namespace manifuzz::canary
