#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include <catch2/catch.hpp>

#include "exact/witness.hpp"
#include "exchange/json.hpp"
#include "generating/regime.hpp"
#include "judging/by_curve.hpp"
#include "support/claiming.hpp"
#include "support/named_tests.hpp"
#include "support/twin.hpp"

// Right answers of every claim, rounded wherever an engine rounds: none is called wrong.
// MANIFUZZ_TWIN_CASES sets how many cases a regime.

namespace manifuzz {
namespace {

constexpr std::uint64_t kWitnessesMeasured = 20'000;  // it takes many times as long as a verdict

/// The largest shares of a bound that were used.
struct Shares {
  double consistency = 0;
  double minimality = 0;
  double witness = 0;  ///< 1, a half, a quarter, ...
  std::uint64_t judged = 0;
};

void widen(Shares& shares, const exact::Truth& truth, const Declaration& declaration,
           const Answer& answer, const CurveJudgement& judgement) {
  ++shares.judged;
  const auto said = said_along(answer);
  if (!said || !judgement.excess || std::holds_alternative<Manifold<double>>(answer)) return;
  const CurveBounds bounds = curve_bounds(truth.pair(), declaration, truth.extent());
  const double off = std::abs(said->depth - exact::Along(truth, said->normal).depth());
  shares.consistency = std::max(shares.consistency, off / bounds.consistency);
  shares.minimality = std::max(shares.minimality, *judgement.excess / bounds.minimality);
}

/// Whether a side plane cut the deepest point off an edge so steep that its depth is off by more
/// than the curve allows: a clip's is right within s (1 + tan), and only a clip's.
bool is_cut(const PairCase& pair, const Manifold<double>& manifold, const CurveBounds& bounds) {
  if (manifold.count == 0) return false;
  const bool is_second = manifold.count == 2 && manifold.points[1].depth > manifold.points[0].depth;
  const FeaturePair& features = manifold.points[is_second ? 1 : 0].features;
  const Side incident = other(manifold.reference);
  const Feature& cut = incident == Side::a ? features.a : features.b;
  if (cut.kind == Feature::Kind::vertex) return false;
  const auto along = exact::turned_back(
      pair.a, exact::direction<double>(pair, exact::FaceOf{incident, cut.index}));
  const Vector2<double> edge(along.x, along.y);
  const double rise = std::abs(edge.dot(manifold.normal));
  const double run = std::abs(edge.x() * manifold.normal.y() - edge.y() * manifold.normal.x());
  return rise * bounds.touching > run * (bounds.consistency - bounds.touching);
}

/// The least of a half, a quarter, ... of its bounds within which every point of a clip is one.
double share_of_witness(const exact::Truth& truth, const Declaration& declaration,
                        const Manifold<double>& manifold) {
  constexpr std::array<exact::Height, 2> cores{{{1, 0, 0}, {0, 1, 0}}};
  if (manifold.count == 0) return 0;
  const CurveBounds bounds = curve_bounds(truth.pair(), declaration, truth.extent());
  const exact::Along along(truth, manifold.normal);
  for (double share = 0.5; share > 1e-3; share /= 2) {
    for (int i = 0; i < manifold.count; ++i) {
      const ContactPoint<double>& point = manifold.points[i];
      const exact::PointClaim claim{.position = point.position,
                                    .heights = cores,
                                    .gap_least = point.depth,
                                    .gap_most = point.depth,
                                    .along = share * bounds.along,
                                    .across = share * bounds.across,
                                    .slack = share * bounds.consistency};
      if (!exact::is_witness(truth, along, claim)) return 2 * share;
    }
  }
  return 0;
}

void judge_all(const Regime& regime) {
  std::array<Shares, std::size(test::kClaiming)> shares;
  for (std::uint64_t i = 0; i < twin_cases(400); ++i) {
    const exact::Truth truth(generate(29, regime, i));
    const PairCase& pair = truth.pair();
    const test::Claim& claim = test::claims()[i % test::claims().size()];
    for (std::size_t c = 0; c < shares.size(); ++c) {
      const test::Claiming& claiming = test::kClaiming[c];
      const Declaration declaration = claim.declared(test::declaration_of(claiming));
      if (is_ill_posed(truth.size(), bounds(pair, declaration, truth.extent()))) continue;
      const Manifold<double> manifold = test::clipped(pair, claiming);
      // Unless cores overlap, a clip may lose the deepest vertex, or all: right for a clip alone.
      const double bound = bounds(pair, declaration, truth.extent()).separation;
      if (!is_round(pair) && total_radius(pair) > 0 && truth.compare_separation(-bound) >= 0)
        continue;
      if (is_cut(pair, manifold, curve_bounds(pair, declaration, truth.extent()))) continue;
      const Answer answer = claim.said(pair, manifold);
      const CurveJudgement judgement = judge_by_curve(truth, declaration, answer);
      widen(shares[c], truth, declaration, answer, judgement);
      if (i < kWitnessesMeasured && total_radius(pair) == 0 &&
          std::string_view(claim.name) == "points of a clip") {
        const double share =
            share_of_witness(truth, declaration, std::get<Manifold<double>>(answer));
        shares[c].witness = std::max(shares[c].witness, share);
      }
      if (judgement.kind == Kind::none) continue;
      std::string line;
      append_case_line(line, pair);
      FAIL_CHECK(claim.name << ", " << declaration.name << ", index " << i << ": "
                            << kKindNames[static_cast<std::size_t>(judgement.kind)] << " "
                            << judgement.magnitude << "\n"
                            << line);
    }
  }
  for (std::size_t c = 0; c < shares.size(); ++c) {
    std::printf("%-16s %-14s %9llu judged  consistency %.3f  minimality %.3f  witness %.3f\n",
                std::string(regime.name).c_str(), test::name_of(test::kClaiming[c]).c_str(),
                static_cast<unsigned long long>(shares[c].judged), shares[c].consistency,
                shares[c].minimality, shares[c].witness);
    CHECK(shares[c].consistency <= 1);
    CHECK(shares[c].minimality <= 1);
  }
}

[[maybe_unused]] const bool claims_registered = [] {
  for (const Regime& regime : regimes()) {
    test::add_test("no right answer of any claim is called wrong in " + std::string(regime.name),
                   "[twin]", [&regime] { judge_all(regime); });
  }
  return true;
}();

}  // namespace
}  // namespace manifuzz
