#include "bits.hpp"

#include <bit>
#include <manifuzz/clipping/collide.hpp>
#include <manifuzz/kernel/batch.hpp>
#include <manifuzz/kernel/pair.hpp>
#include <manifuzz/scene/scene.hpp>
#include <span>

using namespace manifuzz;

namespace {

class Draw {
 public:
  /// In [-1, 1).
  float operator()() {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<float>(static_cast<int>(state_ >> 40) - (1 << 23)) / (1 << 23);
  }

 private:
  unsigned long long state_ = 1;
};

/// By the tangent of half its angle.
Vector2<float> rotation_by(float t) {
  return {(1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)};
}

ConvexPolygon<float> kite(Draw& draw) {
  const auto length = [&] { return 1.5F + draw(); };
  const Vector2<float> corners[] = {{length(), 0}, {0, length()}, {-length(), 0}, {0, -length()}};
  return make_polygon<float>(corners);
}

void add(Bits& bits, const Vector2<float>& v) {
  for (const float x : {v.x(), v.y()}) {
    bits.sum = bits.sum * 1099511628211ULL + std::bit_cast<unsigned>(x);
  }
}

}  // namespace

Bits sum_of_bits() {
  Draw draw;
  Bits bits;
  kernel::Shapes<float> shapes;
  std::vector<ConvexPolygon<float>> polygons;
  std::vector<kernel::Placement<float>> bodies;
  std::vector<kernel::BodyPair> pairs;
  for (unsigned i = 0; i < 4000; ++i) {
    polygons.push_back(kite(draw));
    bodies.push_back({shapes.add(polygons[i]), {{draw(), draw()}, rotation_by(draw())}});
    if (i % 2 != 0) pairs.push_back({i - 1, i});
  }
  std::vector<Manifold<float>> manifolds(pairs.size());
  kernel::collide_pairs(shapes, bodies, pairs, 0, manifolds);
  scene::Scene scene;
  for (std::size_t i = 0; i < pairs.size(); ++i, ++bits.pairs) {
    const auto& [a, b] = pairs[i];
    const Pose<float> b_in_a = relative_pose(bodies[a].pose, bodies[b].pose);
    const Manifold<float> clipped = clipping::collide(polygons[a], polygons[b], b_in_a);
    const Manifold<float> alone =
        kernel::collide(kernel::rows_of(polygons[a]), kernel::rows_of(polygons[b]), b_in_a);
    if (!(clipped == manifolds[i]) || !(clipped == alone)) ++bits.differences;
    for (const auto& corner : polygons[a].corners()) add(bits, corner);
    add(bits, polygons[a].normals[0]);
    add(bits, b_in_a.position);
    const auto count = static_cast<std::size_t>(clipped.count);
    for (const auto& point : std::span(clipped.points).first(count)) add(bits, point.position);
    // Far from the others.
    for (const auto body : {a, b}) {
      const auto shape = std::get<std::uint32_t>(scene.add_shape(polygons[body]));
      (void)scene.add(shape, {{bodies[body].pose.position.x() + 32 * static_cast<float>(i),
                               bodies[body].pose.position.y()},
                              bodies[body].pose.rotation});
    }
  }
  const auto stepped = scene.step({});
  bits.sum += std::get<scene::StepResult>(stepped).contacts.size();
  return bits;
}
