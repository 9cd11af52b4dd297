#pragma once

#include <vector>

#include "methods/cached_as_bullet.hpp"

namespace manifuzz::test {

/// Points kept as it should be, B's place and what is detected being told frame by frame.
struct Kept {
  methods::PointCache<double> cache;
  methods::KeepLimits<double> limits{0.25, 0.25, 0.25, 0.25};

  void frame(const Pose<double>& b_in_a,
             const std::optional<methods::DetectedPoint<double>>& found) {
    methods::next_frame(cache, b_in_a, limits, [&] { return found; });
  }
};

/// Points kept as Bullet keeps them.
struct KeptAsBullet {
  methods::PointCache<double> cache;
  double threshold = 0.25;

  void frame(const Pose<double>& b_in_a, const std::optional<methods::DetectedPoint<double>>& found,
             const Vector2<double>& rotation_a = {1, 0}) {
    methods::next_frame_as_bullet(cache, b_in_a, rotation_a, threshold, [&] { return found; });
  }
};

/// A point of B as deep as that below the top of A, y = 0.
inline methods::DetectedPoint<double> below_top(double x, double depth, Side carrier = Side::a) {
  return {{0, 1}, {x, 0}, {x, -depth}, carrier};
}

template <class Kept>
std::vector<int> ids(const Kept& kept) {
  std::vector<int> all;
  for (const auto& point : kept.cache.all()) all.push_back(point.id);
  return all;
}

/// At A's place, turned by the angle of this sine.
inline Pose<double> turned(double sine) {
  return {{0, 0}, {std::sqrt(1 - sine * sine), sine}};
}

}  // namespace manifuzz::test
