#include <dlfcn.h>
#include <memory>

#include <fmt/format.h>

#include "base/text.hpp"
#include "exchange/json.hpp"
#include "oracle/external/external_collider.hpp"

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
  declaration_ = static_cast<const manifuzz_declaration*>(dlsym(library, "manifuzz_collider"));
  collide_ = reinterpret_cast<decltype(collide_)>(dlsym(library, "manifuzz_collide"));
  if (declaration_ == nullptr || collide_ == nullptr) {
    throw UserError(
        fmt::format("{}: has no {}; see manifuzz_collider.h", path,
                    declaration_ == nullptr ? "manifuzz_collider" : "manifuzz_collide"));
  }
}

int Library::collide(const PairCase& pair, manifuzz_manifold& manifold) const {
  const manifuzz_body a = to_c(pair.a);
  const manifuzz_body b = to_c(pair.b);
  manifold = {};
  return collide_(&a, &b, &manifold);
}

Declaration declaration_of(const manifuzz_declaration& declared) {
  if (declared.interface != MANIFUZZ_INTERFACE) {
    throw UserError(fmt::format("manifuzz_collider.interface is {}; {} is expected",
                                declared.interface, static_cast<int>(MANIFUZZ_INTERFACE)));
  }
  expect_between(declared.scalar, MANIFUZZ_FLOAT32, MANIFUZZ_FLOAT64, "scalar");
  expect_between(declared.rounds_in, MANIFUZZ_WORLD, MANIFUZZ_FRAME_OF_A, "rounds_in");
  expect_between(declared.answers_in, MANIFUZZ_WORLD, MANIFUZZ_FRAME_OF_A, "answers_in");
  expect_between(declared.points, MANIFUZZ_CLIP_POINTS, MANIFUZZ_MIDPOINTS, "points");
  expect_between(declared.normal, MANIFUZZ_A_TO_B, MANIFUZZ_B_TO_A, "normal");
  expect_between(declared.vertices_max, 3, kMaxVertices, "vertices_max");
  Declaration declaration{
      .name = text_of(declared.name),
      .version = text_of(declared.version),
      .description = "a shared library",
      .scalar = declared.scalar == MANIFUZZ_FLOAT32 ? ScalarType::float32 : ScalarType::float64,
      .frame = declared.rounds_in == MANIFUZZ_WORLD ? RoundingFrame::world : RoundingFrame::local,
      .tie_bias = declared.tie_bias,
      .max_vertices = declared.vertices_max,
      .takes_radius = declared.takes_radius != 0,
      .snippet = text_of(declared.snippet)};
  check_declaration(declaration, "manifuzz_collider.");
  return declaration;
}

Answer answer_of(int status, const manifuzz_manifold& manifold,
                 const manifuzz_declaration& declared, const PairCase& pair) {
  if (status == 1) return Unsupported{"it declined this case"};
  if (status != 0) return malformed(fmt::format("returned {}; 0 or 1 is expected", status));
  if (manifold.count < 0 || manifold.count > 2) {
    return malformed(fmt::format("{} points; 0 to 2 are expected", manifold.count));
  }
  if (manifold.count == 0) return Manifold<double>{};
  ReportedManifold reported{.count = manifold.count, .normal = from_c(manifold.normal)};
  if (manifold.reference != MANIFUZZ_NO_REFERENCE) {
    reported.reference = manifold.reference == MANIFUZZ_B ? Side::b : Side::a;
  }
  const bool in_a = declared.answers_in == MANIFUZZ_FRAME_OF_A;
  for (int i = 0; i < manifold.count; ++i) {
    const manifuzz_point& point = manifold.points[i];
    if (!is_feature(point.feature_a, pair.a) || !is_feature(point.feature_b, pair.b)) {
      return malformed("names a feature that the polygon does not have");
    }
    (in_a ? reported.points[i].local : reported.points[i].world) = from_c(point.position);
    reported.points[i].depth = point.depth;
    if (point.feature_a.kind != MANIFUZZ_UNSAID && point.feature_b.kind != MANIFUZZ_UNSAID) {
      reported.points[i].features = {from_c(point.feature_a), from_c(point.feature_b)};
    }
  }
  return in_frame_of_a(reported,
                       {.has_midpoints = declared.points == MANIFUZZ_MIDPOINTS,
                        .normal_from_b = declared.normal == MANIFUZZ_B_TO_A,
                        .normal_in_a = in_a},
                       pair);
}

Collider collider_in_process(const std::string& path) {
  const auto library = std::make_shared<const Library>(path);
  Collider collider;
  collider.declaration = declaration_of(library->declaration());
  collider.collide = [library, declaration = collider.declaration](const PairCase& pair) -> Answer {
    if (auto declined = beyond_limits(declaration, pair)) return *declined;
    manifuzz_manifold manifold;
    const int status = library->collide(pair, manifold);
    return answer_of(status, manifold, library->declaration(), pair);
  };
  return collider;
}

}  // namespace manifuzz
