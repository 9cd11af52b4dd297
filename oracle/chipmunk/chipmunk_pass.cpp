#include "oracle/chipmunk/chipmunk_pass.hpp"

#include <array>
#include <chipmunk/chipmunk.h>
#include <memory>
#include <vector>

namespace manifuzz {
namespace {

struct Freed {
  void operator()(cpShape* shape) const { cpShapeFree(shape); }
};

struct Placed {
  std::unique_ptr<cpShape, Freed> shape;
  cpTransform transform{};
};

/// What segments ask for their rotation.
cpBody* any_body() {
  static cpBody* const body = cpBodyNew(1, 1);
  return body;
}

Placed placed(const Body& body) {
  std::array<cpVect, kMaxVertices> vertices;
  for (int i = 0; i < body.polygon.count; ++i) {
    const Vector2<double> vertex = body.polygon.vertices[i].cast<double>();
    vertices[i] = cpv(vertex.x(), vertex.y());
  }
  const Vector2<double> position = body.pose.position.cast<double>();
  const Vector2<double> rotation = body.pose.rotation.cast<double>();
  const auto radius = static_cast<double>(body.polygon.radius);
  const int count = body.polygon.count;
  cpShape* const shape = count == 1 ? cpCircleShapeNew(any_body(), radius, vertices[0])
                         : count == 2
                             ? cpSegmentShapeNew(any_body(), vertices[0], vertices[1], radius)
                             : cpPolyShapeNewRaw(any_body(), count, vertices.data(), radius);
  return {std::unique_ptr<cpShape, Freed>(shape),
          cpTransformNew(rotation.x(), rotation.y(), -rotation.y(), rotation.x(), position.x(),
                         position.y())};
}

struct Prepared {
  Placed a;
  Placed b;
  cpContactPointSet found{};
};

}  // namespace

std::function<void()> chipmunk_pass(std::span<const PairCase> pairs) {
  const auto all = std::make_shared<std::vector<Prepared>>();
  for (const PairCase& pair : pairs) all->push_back({placed(pair.a), placed(pair.b), {}});
  return [all] {
    for (Prepared& pair : *all) {
      for (Placed* body : {&pair.a, &pair.b}) cpShapeUpdate(body->shape.get(), body->transform);
      pair.found = cpShapesCollide(pair.a.shape.get(), pair.b.shape.get());
    }
  };
}

}  // namespace manifuzz
