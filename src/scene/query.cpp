#include "scene/query.hpp"

#include <algorithm>

#include "afresh/boxes.hpp"

namespace manifuzz::scene {

std::span<const BodyHandle> Scene::near(const Box& box) {
  const std::span<const std::uint32_t> found = cells_.near(box);
  bodies_.assign(found.begin(), found.end());
  std::ranges::sort(bodies_);
  draw_tight_boxes(bodies_);
  near_.clear();
  for (const std::uint32_t body : bodies_) {
    if (scene::overlap(tight_[body], box)) near_.push_back(handle(body));
  }
  return near_;
}

namespace {

/// A long ray is followed in so many pieces: what lies behind the first hit need not be asked.
constexpr int kPieces = 16;

/// The box of a piece of a ray, grown by more than the roundings of its ends.
Box box_of_piece(const Ray& ray, int piece) {
  const auto end = [&](int of) {
    return Vector2<float>(ray.from + static_cast<float>(of) / kPieces * ray.along);
  };
  const Vector2<float> first = end(piece);
  const Vector2<float> last = end(piece + 1);
  const Vector2<float> low = first.cwiseMin(last);
  const Vector2<float> high = first.cwiseMax(last);
  const float by =
      4 * kRoundoff * (ray.from.cwiseAbs().maxCoeff() + ray.along.cwiseAbs().maxCoeff());
  return grown({low.x(), low.y(), high.x(), high.y()}, by);
}

}  // namespace

std::optional<SceneHit> cast_ray(Scene& scene, const Ray& ray, const Filter& filter) {
  std::optional<SceneHit> first;
  for (int piece = 0; piece < kPieces; ++piece) {
    if (first && first->hit.share * kPieces < piece) break;
    for (const BodyHandle handle : scene.near(box_of_piece(ray, piece))) {
      const Rules rules = scene.rules(handle);
      if (rules.is_sensor || !may_touch(filter, rules.filter)) continue;
      const auto [shape, pose] = scene.placement(handle);
      const auto hit = manifuzz::cast_ray(scene.shape(shape), pose, ray);
      if (hit && (!first || hit->share < first->hit.share)) first = {handle, *hit};
    }
  }
  return first;
}

}  // namespace manifuzz::scene
