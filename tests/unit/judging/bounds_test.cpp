#include <algorithm>
#include <cstdio>
#include <string>

#include <catch2/catch.hpp>

#include "exact/clip.hpp"
#include "generating/regime.hpp"
#include "judging/judge.hpp"
#include "judging/manifold_error.hpp"
#include "oracle/box2d/box2d.hpp"
#include "own_colliders/own_colliders.hpp"

// How far right colliders use their bounds: never past them, and not a thousand times short.

using namespace manifuzz;

namespace {

using Fine = exact::Approximate<exact::DoubleDouble>;

/// What of the bounds was used, 1 being all of it: by figures, and by decisions.
struct Used {
  ManifoldError figures;
  double reference = 0;  ///< by how much the reference's separation falls short of its side's
  double incident = 0;   ///< by how much the incident edge's dot exceeds the least
  double contact = 0;    ///< how far apart a contact was seen, or how deep an overlap was not

  void widen(const Used& other) {
    manifuzz::widen(figures, other.figures);
    reference = std::max(reference, other.reference);
    incident = std::max(incident, other.incident);
    contact = std::max(contact, other.contact);
  }
};

double short_of_its_side(const Admissible& right, exact::FaceOf reference) {
  const exact::Truth& truth = *right.truth;
  return exact::leading(truth.fine_separation(truth.greatest(reference.side)) -
                        truth.fine_separation(reference));
}

double above_the_least_dot(const Admissible& right, const exact::Clip& clip) {
  const Side opposing = other(clip.reference.side);
  const auto normal = exact::true_normal<Fine>(clip);
  const auto against = [&](int edge) {  // both normals point from A to B: minus the dot
    return exact::dot(normal, exact::true_normal<Fine>(right.pair(), {opposing, edge})).value;
  };
  exact::DoubleDouble most = against(0);
  for (int j = 1; j < right.pair()[opposing].polygon.count; ++j) {
    if (exact::leading(against(j) - most) > 0) most = against(j);
  }
  return exact::leading(most - against(clip.incident));
}

/// How far a contact was seen before there is one, or an overlap not seen.
double contact_error(const Manifold<double>& manifold, const exact::Truth& truth) {
  const exact::DoubleDouble separation = truth.fine_separation(truth.greatest());
  if (manifold.count == 0) return std::max(0.0, -exact::leading(separation));
  return std::max(0.0,
                  exact::leading(separation - exact::DoubleDouble(total_radius(truth.pair()))));
}

std::optional<ErrorAgainstClip> error_if_right(const Manifold<double>& manifold,
                                               const Admissible& right) {
  ClipFiguresCache figures;
  return manifuzz::error_if_right(manifold, right, figures);
}

/// A right manifold's.
Used used_by(const Manifold<double>& manifold, const Admissible& right) {
  Used used;
  used.contact = contact_error(manifold, *right.truth) / right.bounds.separation;
  const auto measured = error_if_right(manifold, right);
  if (!measured) return used;
  used.figures = measured->of_bound;
  used.reference = short_of_its_side(right, measured->clip->reference) / right.bounds.separation;
  used.incident = above_the_least_dot(right, *measured->clip) / right.bounds.incident_dot;
  return used;
}

Used most_used(const Collider& collider, const Regime& regime, std::uint64_t cases) {
  Used most;
  for (std::uint64_t i = 0; i < cases; ++i) {
    const PairCase pair = generate(4, regime, i);
    const Admissible right = admissible(pair, collider.declaration);
    if (is_ill_posed(size(pair), right.bounds)) continue;
    const auto manifold = std::get<Manifold<double>>(collider.collide(pair));
    const Kind wrong = mismatch(manifold, right).kind;
    if (wrong == Kind::none) {
      most.widen(used_by(manifold, right));
    } else {
      CHECK(find_explanation(collider.declaration.name, {right, manifold, wrong}) != nullptr);
    }
  }
  return most;
}

}  // namespace

TEST_CASE("every right collider comes close to its bounds and never past them") {
  std::puts("largest share of a bound   normal  position   depth  reference  incident  contact");
  for (const Collider& collider : {make_clip(), make_clip64(), make_box2d()}) {
    for (const Regime& regime : polygon_regimes()) {
      const bool generic = regime.name == "generic";
      const Used most = most_used(collider, regime, generic ? 20'000 : 2000);
      const ManifoldError& figures = most.figures;
      std::printf("%-8s %-16s  %7.3f  %8.3f  %6.3f  %9.3f  %8.3f  %7.3f\n",
                  collider.declaration.name.c_str(), std::string(regime.name).c_str(),
                  figures.normal, figures.position, figures.depth, most.reference, most.incident,
                  most.contact);
      CHECK(figures.normal <= 1);
      CHECK(figures.position <= 1);
      CHECK(figures.depth <= 1);
      if (!generic) continue;
      CHECK(std::max({figures.normal, figures.position, figures.depth}) >= 0.1);
      CHECK(figures.position >= 0.05);
      CHECK(figures.depth >= 0.05);
    }
  }
}

TEST_CASE("an error is measured to past double") {
  const Vector2<float> corners[] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  PairCase pair{{make_polygon<float>(corners), {}}, {make_polygon<float>(corners), {}}};
  pair.b.pose.position = {0.3F, 1.75F};
  const Collider clip64 = make_clip64();
  auto manifold = std::get<Manifold<double>>(clip64.collide(pair));
  const Admissible right = admissible(pair, clip64.declaration);
  CHECK(error_if_right(manifold, right)->error.depth <= 1e-16);
  manifold.points[0].depth += 0x1p-52;
  CHECK(error_if_right(manifold, right)->error.depth >= 0x1p-53);
  manifold.count = 0;
  CHECK(!error_if_right(manifold, right));
}
