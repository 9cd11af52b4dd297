#include "scene/query.hpp"

#include <algorithm>
#include <limits>

#include "afresh/boxes.hpp"

namespace manifuzz::scene {

/// Bounds are finite from here on: places of the cells that hold nobody lie at infinity.
void Scene::near(const Box& box, std::vector<BodyHandle>& found) {
  found.clear();
  constexpr float most = std::numeric_limits<float>::max();
  const Box within{std::max(box.x_min, -most), std::max(box.y_min, -most),
                   std::min(box.x_max, most), std::min(box.y_max, most)};
  if (!(within.x_min <= within.x_max && within.y_min <= within.y_max)) return;
  const std::span<const std::uint32_t> around = cells_.near(within);
  bodies_.assign(around.begin(), around.end());
  std::ranges::sort(bodies_);
  draw_tight_boxes(bodies_);
  for (const std::uint32_t body : bodies_) {
    if (scene::overlap(tight_[body], within)) found.push_back(handle(body));
  }
}

namespace {

/// A long ray is followed in so many pieces: what lies behind the first hit need not be asked.
constexpr int kPieces = 16;

/// The box of a piece of a ray, grown by more than the roundings of its ends.
Box box_of_piece(const Ray& ray, int piece) {
  const Vector2<double> from = ray.from.cast<double>();
  const Vector2<double> along = ray.along.cast<double>();
  const Vector2<double> first = from + along * (static_cast<double>(piece) / kPieces);
  const Vector2<double> last = from + along * (static_cast<double>(piece + 1) / kPieces);
  const double by = 1e-6 * (from.cwiseAbs().maxCoeff() + along.cwiseAbs().maxCoeff());
  const auto rounded = [](double bound) {
    constexpr auto most = static_cast<double>(std::numeric_limits<float>::max());
    return static_cast<float>(std::clamp(bound, -most, most));
  };
  return {rounded(std::min(first.x(), last.x()) - by), rounded(std::min(first.y(), last.y()) - by),
          rounded(std::max(first.x(), last.x()) + by), rounded(std::max(first.y(), last.y()) + by)};
}

/// Whether a hit comes before the first one so far.
bool is_before(const SceneHit& hit, const std::optional<SceneHit>& first) {
  if (!first || hit.hit.share < first->hit.share) return true;
  return hit.hit.share == first->hit.share && hit.handle.index < first->handle.index;
}

}  // namespace

std::optional<SceneHit> cast_ray(Scene& scene, const Ray& ray, const Filter& filter) {
  std::optional<SceneHit> first;
  std::vector<BodyHandle> near;
  for (int piece = 0; piece < kPieces; ++piece) {
    if (first && first->hit.share * kPieces < piece) break;
    scene.near(box_of_piece(ray, piece), near);
    for (const BodyHandle handle : near) {
      const Rules rules = scene.rules(handle);
      if (rules.is_sensor || !may_touch(filter, rules.filter)) continue;
      const auto [shape, pose] = scene.placement(handle);
      const auto hit = manifuzz::cast_ray(scene.shape(shape), pose, ray);
      if (hit && is_before({handle, *hit}, first)) first = {handle, *hit};
    }
  }
  return first;
}

}  // namespace manifuzz::scene
