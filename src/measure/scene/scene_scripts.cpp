#include "measure/scene/scene_scripts.hpp"

#include <cmath>

#include "generating/placing.hpp"

namespace manifuzz {
namespace {

constexpr float kSkin = 0.01F;

/// How a body goes on from step to step.
struct Course {
  Vector2<double> by{0, 0};
  Vector2<double> turn{1, 0};
};

/// Where a body is, without the roundings of the steps before.
struct Place {
  Vector2<double> position;
  Vector2<double> rotation;

  void advance(const Course& course) {
    position += course.by;
    rotation = unit(rotate<double>(course.turn, rotation));
  }
  Pose<float> pose() const { return {position.cast<float>(), rotation.cast<float>()}; }
};

/// Bodies in a square grid, each turned anyhow and shifted by up to `jitter`.
std::vector<Place> field(std::size_t bodies, double spacing, double jitter, Random& random) {
  const auto side = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(bodies))));
  std::vector<Place> places;
  for (std::size_t i = 0; i < bodies; ++i) {
    const double x = spacing * static_cast<double>(i % side) + random.uniform(-jitter, jitter);
    const double y = spacing * static_cast<double>(i / side) + random.uniform(-jitter, jitter);
    places.push_back({{x, y}, random_direction(random)});
  }
  return places;
}

/// All bodies on their courses; shapes in turn.
Trajectory moving(std::vector<ConvexPolygon<float>> shapes, std::vector<Place> places,
                  const std::vector<Course>& courses, int steps) {
  Trajectory trajectory{std::move(shapes), {}, {}};
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto shape = static_cast<std::uint32_t>(i % trajectory.shapes.size());
    trajectory.start.push_back({shape, places[i].pose()});
  }
  for (int step = 0; step < steps; ++step) {
    std::vector<BodyMove>& moves = trajectory.steps.emplace_back();
    for (std::uint32_t i = 0; i < courses.size(); ++i) {
      places[i].advance(courses[i]);
      moves.push_back({i, places[i].pose()});
    }
  }
  return trajectory;
}

/// For each body a direction and a turn of its own.
std::vector<Course> courses_of(std::size_t bodies, double length, double t, Random& random) {
  std::vector<Course> courses;
  for (std::size_t i = 0; i < bodies; ++i) {
    const Vector2<double> direction = random_direction(random);
    courses.push_back({length * direction, turn_by(random.uniform(-t, t))});
  }
  return courses;
}

}  // namespace

std::vector<ConvexPolygon<float>> mixed_shapes() {
  std::vector<ConvexPolygon<float>> shapes;
  for (std::uint64_t i = 0; shapes.size() < 48; ++i) {
    Random random(1, "scene shapes", i);
    const int count = kMinVertices + static_cast<int>(i % (kMaxVertices - kMinVertices + 1));
    const Outline outline = random_outline(random, count);
    const Outline centred = moved(outline, -middle(outline));
    const double scale = 1 / span(centred);
    if (const auto polygon = rounded(stretched(centred, scale, scale), kSkin)) {
      shapes.push_back(*polygon);
    }
  }
  return shapes;
}

Trajectory make_sparse_drift(std::size_t bodies, int steps) {
  Random random(1, "sparse drift", 0);
  std::vector<Place> places = field(bodies, 4, 1.5, random);
  return moving(mixed_shapes(), std::move(places), courses_of(bodies, 0.02, 0.01, random), steps);
}

Trajectory make_spinning_grid(std::size_t bodies, int steps) {
  Random random(1, "spinning grid", 0);
  std::vector<Place> places = field(bodies, 1.2, 0, random);
  return moving({*rounded(box(0.5, 0.5), kSkin)}, std::move(places),
                courses_of(bodies, 0, 0.02, random), steps);
}

Trajectory make_one_mover(std::size_t bodies, int steps) {
  Random random(1, "one mover", 0);
  std::vector<Place> places = field(bodies, 1.1, 0.1, random);
  return moving(mixed_shapes(), std::move(places), {{{0.05, 0.03}, turn_by(0.01)}}, steps);
}

Trajectory make_slivers(std::size_t bodies, int steps) {
  Random random(1, "slivers", 0);
  std::vector<ConvexPolygon<float>> shapes;
  for (const double width : {0.002, 0.005, 0.01, 0.02}) {
    shapes.push_back(*rounded(stretched(regular_outline(3), width, 1), 0));
    shapes.push_back(*rounded(stretched(regular_outline(6), 1, width), 0));
  }
  std::vector<Place> places = field(bodies, 0.7, 0.2, random);
  return moving(std::move(shapes), std::move(places), courses_of(bodies, 0.005, 0.002, random),
                steps);
}

Trajectory make_still(std::size_t bodies, int steps) {
  Random random(1, "still", 0);
  return moving(mixed_shapes(), field(bodies, 0.8, 0.05, random), {}, steps);
}

}  // namespace manifuzz
