#include <array>
#include <cstddef>
#include <cstring>
#include <dlfcn.h>

#include <fmt/format.h>

#include "base/file.hpp"
#include "base/text.hpp"
#include "exchange/json.hpp"
#include "external/external_collider.hpp"

namespace manifuzz {
namespace {

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

/// How much of a declaration a library has, by its interface.
constexpr std::array kBytesOfInterface{
    offsetof(manifuzz_declaration, claims),
    offsetof(manifuzz_declaration, claims) + offsetof(manifuzz_claims, vertices_min),
    offsetof(manifuzz_declaration, claims) + offsetof(manifuzz_claims, least_polygon_turn),
    offsetof(manifuzz_declaration, claims) + offsetof(manifuzz_claims, normals),
    sizeof(manifuzz_declaration)};
static_assert(kBytesOfInterface.size() == MANIFUZZ_INTERFACE);

std::optional<UsedShapes> shapes_of(const manifuzz_manifold& manifold) {
  if (manifold.shapes[0].count == 0 && manifold.shapes[1].count == 0) return std::nullopt;
  UsedShapes used;
  for (const Side side : {Side::a, Side::b}) {
    const manifuzz_shape& shape = manifold.shapes[static_cast<std::size_t>(side)];
    used[side].count = shape.count;
    for (int i = 0; i < shape.count; ++i) used[side].all[i] = from_c(shape.vertices[i]);
  }
  return used;
}

bool has_shapes_to_read(const manifuzz_manifold& manifold) {
  const auto is_said = [](const manifuzz_shape& shape) {
    return shape.count >= 1 && shape.count <= kMaxVertices;
  };
  const auto& [a, b] = manifold.shapes;
  return (a.count == 0 && b.count == 0) || (is_said(a) && is_said(b));
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

void* open_library(const std::string& path) {
  // dlopen searches elsewhere for a name without a slash.
  const std::string file = path.find('/') == std::string::npos ? "./" + path : path;
  const CallWatch loading;
  void* const library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (const SideEffect effect = loading.end(); effect != SideEffect::none) {
    // As code that is linked with -ffast-math does.
    write_error(fmt::format("{} {} while it was loaded; that is undone\n", printable(path, 200),
                            in_words(effect)));
  }
  if (library == nullptr) {
    throw UserError(
        fmt::format("{}: cannot be loaded: {}", printable(path, 200), printable(dlerror(), 300)));
  }
  return library;
}

Library::Library(const std::string& path) {
  void* const library = open_library(path);
  const void* const declared = dlsym(library, "manifuzz_collider");
  collide_ = reinterpret_cast<decltype(collide_)>(dlsym(library, "manifuzz_collide"));
  if (declared == nullptr || collide_ == nullptr) {
    throw UserError(fmt::format("{}: has no {}; see manifuzz_collider.h", printable(path, 200),
                                declared == nullptr ? "manifuzz_collider" : "manifuzz_collide"));
  }
  // An earlier one ends before what later ones added.
  std::memcpy(&declaration_, declared, kBytesOfInterface[0]);
  if (declaration_.interface > 1 && declaration_.interface <= MANIFUZZ_INTERFACE) {
    std::memcpy(&declaration_, declared, kBytesOfInterface[declaration_.interface - 1]);
  }
}

namespace {

SecondPoint second_point_of(const manifuzz_claims& claims) {
  switch (claims.second_point) {
    case MANIFUZZ_SECOND_POINT_NEVER:
      return SecondPoint::never();
    case MANIFUZZ_SECOND_POINT_WITHIN_ANGLE:
      return SecondPoint::within(claims.second_point_angle);
    default:
      return {};
  }
}

}  // namespace

Declaration declaration_of(const manifuzz_declaration& declared) {
  expect_between(declared.interface, 1, MANIFUZZ_INTERFACE, "interface");
  expect_between(declared.scalar, MANIFUZZ_FLOAT32, MANIFUZZ_FLOAT64, "scalar");
  expect_between(declared.rounds_in, MANIFUZZ_WORLD, MANIFUZZ_FRAME_OF_A, "rounds_in");
  expect_between(declared.answers_in, MANIFUZZ_WORLD, MANIFUZZ_FRAME_OF_A, "answers_in");
  expect_between(declared.points, MANIFUZZ_CLIP_POINTS, MANIFUZZ_ON_SURFACE_B, "points");
  expect_between(declared.normal, MANIFUZZ_A_TO_B, MANIFUZZ_B_TO_A, "normal");
  expect_between(declared.vertices_max, 3, kMaxVertices, "vertices_max");
  expect_between(declared.claims.answers, MANIFUZZ_CLAIMS_MANIFOLD, MANIFUZZ_CLAIMS_TOUCHING,
                 "claims.answers");
  expect_between(declared.claims.tie_bias_towards, MANIFUZZ_NO_REFERENCE, MANIFUZZ_B,
                 "claims.tie_bias_towards");
  expect_between(declared.claims.vertices_min, 0, kMinVertices, "claims.vertices_min");
  expect_between(declared.claims.second_point, MANIFUZZ_SECOND_POINT_BY_CLIP,
                 MANIFUZZ_SECOND_POINT_WITHIN_ANGLE, "claims.second_point");
  expect_between(declared.claims.normals, MANIFUZZ_NORMALS_GIVEN,
                 MANIFUZZ_NORMALS_OF_WORLD_VERTICES, "claims.normals");
  Declaration declaration{
      .name = text_of(declared.name),
      .version = text_of(declared.version),
      .description = "a shared library",
      .scalar = declared.scalar == MANIFUZZ_FLOAT32 ? ScalarType::float32 : ScalarType::float64,
      .frame = declared.rounds_in == MANIFUZZ_WORLD ? RoundingFrame::world : RoundingFrame::local,
      .takes_angles = declared.claims.takes_angles != 0,
      .normals = static_cast<NormalsFrom>(declared.claims.normals),
      .tie_bias = {declared.tie_bias, declared.claims.tie_bias_relative,
                   declared.claims.tie_bias_towards == MANIFUZZ_B ? Side::b : Side::a},
      .max_vertices = declared.vertices_max,
      .takes_radius = declared.takes_radius != 0,
      .min_vertices =
          declared.claims.vertices_min == 0 ? kMinVertices : declared.claims.vertices_min,
      .takes_round = declared.claims.takes_round != 0,
      .least_polygon = {declared.claims.least_polygon_turn, declared.claims.least_polygon_area},
      .second_point = second_point_of(declared.claims),
      .claims = static_cast<Claims>(declared.claims.answers),
      .clips = declared.claims.does_not_clip == 0,
      .points = static_cast<PointsAt>(declared.points),
      .shares_depth = declared.claims.shares_depth != 0,
      .one_point_enough = declared.claims.one_point_enough != 0,
      .speculative = declared.claims.speculative,
      .least_depth = declared.claims.least_depth,
      .alters_shapes = declared.claims.alters_shapes != 0,
      .tolerance = {declared.claims.tolerance_absolute, declared.claims.tolerance_relative},
      .tolerance_source = text_of(declared.claims.tolerance_source),
      .normal_from_b = declared.normal == MANIFUZZ_B_TO_A,
      .snippet = text_of(declared.snippet)};
  check_declaration(declaration, "manifuzz_collider.");
  return declaration;
}

namespace {

/// The answer of a library that claims no points.
Penetration penetration_of(const manifuzz_manifold& manifold, bool has_normal,
                           const Conventions& conventions, const PairCase& pair) {
  Penetration result{.touches = manifold.touching != 0, .used = shapes_of(manifold)};
  const Vector2<double> normal = from_c(manifold.normal);
  if (!has_normal || (!result.touches && normal.isZero(0))) return result;
  result.normal = normal_in_frame_of_a(normal, conventions, pair);
  result.depth = manifold.depth;
  return result;
}

Answer manifold_of(const manifuzz_manifold& manifold, const Conventions& conventions,
                   const PairCase& pair) {
  if (manifold.count < 0 || manifold.count > 2) {
    return malformed(fmt::format("{} points; 0 to 2 are expected", manifold.count));
  }
  ReportedManifold reported{
      .count = manifold.count, .normal = from_c(manifold.normal), .used = shapes_of(manifold)};
  if (manifold.reference != MANIFUZZ_NO_REFERENCE) {
    reported.reference = manifold.reference == MANIFUZZ_B ? Side::b : Side::a;
  }
  for (int i = 0; i < manifold.count; ++i) {
    const manifuzz_point& point = manifold.points[i];
    if (!is_feature(point.feature_a, pair.a) || !is_feature(point.feature_b, pair.b)) {
      return malformed("names a feature that the polygon does not have");
    }
    auto& position = conventions.normal_in_a ? reported.points[i].local : reported.points[i].world;
    position = from_c(point.position);
    reported.points[i].depth = point.depth;
    if (point.feature_a.kind != MANIFUZZ_UNSAID && point.feature_b.kind != MANIFUZZ_UNSAID) {
      reported.points[i].features = {from_c(point.feature_a), from_c(point.feature_b)};
    }
  }
  return in_frame_of_a(reported, conventions, pair);
}

}  // namespace

Answer answer_of(const LibraryCall& call, const manifuzz_manifold& manifold,
                 const Declaration& declaration, const manifuzz_declaration& declared,
                 const PairCase& pair) {
  if (call.effect != SideEffect::none) return malformed(std::string(in_words(call.effect)));
  if (call.status == 1) return Unsupported{"it declined this case"};
  if (call.status != 0) {
    return malformed(fmt::format("returned {}; 0 or 1 is expected", call.status));
  }
  if (!has_shapes_to_read(manifold)) {
    return malformed(fmt::format("shapes of {} and {} vertices; 1 to {} are expected",
                                 manifold.shapes[0].count, manifold.shapes[1].count, kMaxVertices));
  }
  Conventions conventions = conventions_of(declaration);
  conventions.normal_from_b = declaration.normal_from_b;
  conventions.normal_in_a = declared.answers_in == MANIFUZZ_FRAME_OF_A;
  const bool is_separation = conventions.claims == Claims::separation;
  const Answer answer = conventions.is_without_points()
                            ? penetration_of(manifold, is_separation, conventions, pair)
                            : manifold_of(manifold, conventions, pair);
  const auto why = contradiction(answer, conventions);
  return why ? malformed(*why) : answer;
}

}  // namespace manifuzz
