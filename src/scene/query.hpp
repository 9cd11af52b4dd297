#pragma once

#include <optional>

#include "geometry/ray.hpp"
#include "scene/scene.hpp"

namespace manifuzz::scene {

/// What a ray meets first in a scene.
struct SceneHit {
  BodyHandle handle;  ///< as a contact's: `Scene::part` says whose part it is
  RayHit hit;         ///< where
};

/// The first of the scene's shapes that a ray meets, as of the last step; of those met at the same
/// share, the one of the lowest handle. Each shape's answer is that of `cast_ray`
/// (geometry/ray.hpp). Shapes that the filter lets through are asked, sensors left out. The ray's
/// ends must be finite.
std::optional<SceneHit> cast_ray(Scene& scene, const Ray& ray, const Filter& filter = {});

}  // namespace manifuzz::scene
