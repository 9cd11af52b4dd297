#include "oracle/external/library.hpp"

#include <array>
#include <cmath>
#include <dlfcn.h>
#include <memory>

#include <fmt/format.h>

#include "base/text.hpp"
#include "base/user_error.hpp"
#include "oracle/external/limits.hpp"

namespace manifuzz {
namespace {

manifuzz_float2 to_c(const Vector2<float>& v) {
  return {v.x(), v.y()};
}

manifuzz_body to_c(const Body& body) {
  manifuzz_body result{};
  result.count = body.polygon.count;
  for (int i = 0; i < body.polygon.count; ++i) {
    result.vertices[i] = to_c(body.polygon.vertices[i]);
    result.normals[i] = to_c(body.polygon.normals[i]);
  }
  result.radius = body.polygon.radius;
  result.position = to_c(body.pose.position);
  result.rotation = to_c(body.pose.rotation);
  return result;
}

Vector2<double> from_c(const manifuzz_double2& v) {
  return {v.x, v.y};
}

/// A normal of the world in A's frame, as long as it was.
Vector2<double> normal_in_a(const PairCase& pair, const Vector2<double>& normal) {
  const Vector2<double> rotation = pair.a.pose.rotation.cast<double>();
  return rotate_back<double>(rotation, normal) / rotation.norm();
}

bool is_feature(const manifuzz_feature& feature, const Body& body) {
  return feature.kind == MANIFUZZ_UNSAID ||
         (feature.kind <= MANIFUZZ_FACE && feature.index < body.polygon.count);
}

Feature from_c(const manifuzz_feature& feature) {
  return {feature.kind == MANIFUZZ_FACE ? Feature::Kind::face : Feature::Kind::vertex,
          feature.index};
}

Lost malformed(std::string why) {
  return {Lost::How::malformed, std::move(why)};
}

void expect_between(int value, int least, int most, std::string_view field) {
  if (value >= least && value <= most) return;
  throw UserError(
      fmt::format("manifuzz_collider.{} is {}; {} to {} is expected", field, value, least, most));
}

std::string text_of(const char* text) {
  return text == nullptr ? "" : text;
}

}  // namespace

Library::Library(const std::string& path) {
  // dlopen searches elsewhere for a name without a slash.
  const std::string file = path.find('/') == std::string::npos ? "./" + path : path;
  void* const library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    throw UserError(fmt::format("{}: cannot be loaded: {}", path, printable(dlerror(), 300)));
  }
  says_ = static_cast<const manifuzz_declaration*>(dlsym(library, "manifuzz_collider"));
  collide_ = reinterpret_cast<decltype(collide_)>(dlsym(library, "manifuzz_collide"));
  if (says_ == nullptr || collide_ == nullptr) {
    throw UserError(fmt::format("{}: has no {}; see manifuzz_collider.h", path,
                                says_ == nullptr ? "manifuzz_collider" : "manifuzz_collide"));
  }
}

int Library::collide(const PairCase& pair, manifuzz_manifold& manifold) const {
  const manifuzz_body a = to_c(pair.a);
  const manifuzz_body b = to_c(pair.b);
  manifold = {};
  return collide_(&a, &b, &manifold);
}

Declaration declaration_of(const manifuzz_declaration& says) {
  if (says.interface != MANIFUZZ_INTERFACE) {
    throw UserError(fmt::format("manifuzz_collider.interface is {}; {} is what this program speaks",
                                says.interface, static_cast<int>(MANIFUZZ_INTERFACE)));
  }
  expect_between(says.scalar, MANIFUZZ_FLOAT32, MANIFUZZ_FLOAT64, "scalar");
  expect_between(says.rounds_in, MANIFUZZ_WORLD, MANIFUZZ_FRAME_OF_A, "rounds_in");
  expect_between(says.answers_in, MANIFUZZ_WORLD, MANIFUZZ_FRAME_OF_A, "answers_in");
  expect_between(says.points, MANIFUZZ_CLIP_POINTS, MANIFUZZ_MIDPOINTS, "points");
  expect_between(says.normal, MANIFUZZ_A_TO_B, MANIFUZZ_B_TO_A, "normal");
  expect_between(says.vertices_max, 3, kMaxVertices, "vertices_max");
  Declaration declaration{
      .name = text_of(says.name),
      .version = text_of(says.version),
      .description = "a shared library",
      .scalar = says.scalar == MANIFUZZ_FLOAT32 ? ScalarType::float32 : ScalarType::float64,
      .frame = says.rounds_in == MANIFUZZ_WORLD ? RoundingFrame::world : RoundingFrame::local,
      .tie_bias = says.tie_bias,
      .max_vertices = says.vertices_max,
      .takes_radius = says.takes_radius != 0,
      .snippet = text_of(says.snippet)};
  check_declaration(declaration, "manifuzz_collider.");
  return declaration;
}

Answer answer_of(int status, const manifuzz_manifold& manifold, const manifuzz_declaration& says,
                 const PairCase& pair) {
  if (status == 1) return Unsupported{"it declined this case"};
  if (status != 0) return malformed(fmt::format("returned {}; 0 or 1 is expected", status));
  if (manifold.count < 0 || manifold.count > 2) {
    return malformed(fmt::format("{} points; 0 to 2 are expected", manifold.count));
  }
  PartialManifold result{.names_features = true,
                         .has_midpoints = says.points == MANIFUZZ_MIDPOINTS};
  Manifold<double>& answered = result.manifold;
  answered.count = manifold.count;
  if (manifold.count == 0) return answered;
  result.names_reference = manifold.reference != MANIFUZZ_NO_REFERENCE;
  answered.reference = manifold.reference == MANIFUZZ_B ? Side::b : Side::a;
  answered.normal = from_c(manifold.normal) * (says.normal == MANIFUZZ_A_TO_B ? 1 : -1);
  const bool in_world = says.answers_in == MANIFUZZ_WORLD;
  if (in_world) answered.normal = normal_in_a(pair, answered.normal);
  for (int i = 0; i < manifold.count; ++i) {
    const manifuzz_point& point = manifold.points[i];
    if (!is_feature(point.feature_a, pair.a) || !is_feature(point.feature_b, pair.b)) {
      return malformed("names a feature that the polygon does not have");
    }
    const Vector2<double> position = from_c(point.position);
    answered.points[i] = {in_world ? to_local(pair.a.pose, position) : position,
                          point.depth,
                          {from_c(point.feature_a), from_c(point.feature_b)}};
    result.names_features = result.names_features && point.feature_a.kind != MANIFUZZ_UNSAID &&
                            point.feature_b.kind != MANIFUZZ_UNSAID;
  }
  order_points(answered);
  return result;
}

Collider collider_in_process(const std::string& path) {
  const auto library = std::make_shared<const Library>(path);
  Collider collider;
  collider.declaration = declaration_of(library->says());
  collider.collide = [library, declaration = collider.declaration](const PairCase& pair) -> Answer {
    if (auto declined = beyond_limits(declaration, pair)) return *declined;
    manifuzz_manifold manifold;
    const int status = library->collide(pair, manifold);
    return answer_of(status, manifold, library->says(), pair);
  };
  return collider;
}

}  // namespace manifuzz
