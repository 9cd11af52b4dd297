#include <catch2/catch.hpp>

#include "judging/by_curve.hpp"

namespace manifuzz {
TEST_CASE(
    "where a spike's skin passes a corner, no contact is right of points, not of separations") {
  const std::array<Vector2<float>, 3> up{Vector2<float>(0, 0), {-0.5F, -4}, {0.5F, -4}};
  const std::array<Vector2<float>, 3> down{Vector2<float>(0, 0), {0.5F, 4}, {-0.5F, 4}};
  const auto found = [&](float apart, Claims claims) {
    const PairCase pair{{make_polygon<float>(up, 0.125F), {}},
                        {make_polygon<float>(down, 0.125F), {{0, apart}, {1, 0}}}};
    const exact::Truth truth(pair);
    Declaration declaration;
    declaration.claims = claims;
    return claims == Claims::point ? judge_by_curve(truth, declaration, Manifold<double>{}).kind
                                   : judge_by_curve(truth, declaration, Penetration{}).kind;
  };
  // Faces lean by 7.1 degrees: along their normals tips that are d apart are 0.99 d apart along the
  // tangent, which skins of 0.25 in all reach up to twice.
  CHECK(found(0.45F, Claims::point) == Kind::missed_contact);
  CHECK(found(0.55F, Claims::point) == Kind::none);
  CHECK(found(0.55F, Claims::separation) == Kind::missed_contact);
}

}  // namespace manifuzz
