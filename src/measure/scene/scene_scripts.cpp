#include <algorithm>
#include <cmath>

#include "generating/drafts.hpp"
#include "geometry/convex_polygon.hpp"
#include "geometry/manifold.hpp"
#include "measure/scene/scene_list.hpp"
#include "measure/scene/scene_run.hpp"

namespace manifuzz {
namespace {

constexpr float kSkin = 0.01F;

/// How a body goes on from step to step.
struct Course {
  Vector2<double> by{0, 0};
  Vector2<double> turn{1, 0};
};

/// Where a body is, without the roundings of the steps before.
struct FinePose {
  Vector2<double> position;
  Vector2<double> rotation;

  void advance(const Course& course) {
    position += course.by;
    rotation = unit(rotate<double>(course.turn, rotation));
  }
  Pose<float> pose() const { return {position.cast<float>(), rotation.cast<float>()}; }
};

/// Bodies in a square grid, each turned anyhow and shifted by up to `jitter`.
std::vector<FinePose> field(std::size_t bodies, double spacing, double jitter, Random& random) {
  const auto side = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(bodies))));
  std::vector<FinePose> places;
  for (std::size_t i = 0; i < bodies; ++i) {
    const std::size_t row = i / side;
    const double x = spacing * static_cast<double>(i % side) + random.uniform(-jitter, jitter);
    const double y = spacing * static_cast<double>(row) + random.uniform(-jitter, jitter);
    places.push_back({{x, y}, random_direction(random)});
  }
  return places;
}

/// All bodies on their courses; shapes in turn.
Trajectory moving(std::vector<ConvexPolygon<float>> shapes, std::vector<FinePose> places,
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

/// Polygons of 3 to 8 vertices, about one across, with Box2D's skin.
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

// Scenes whose motion is written down, not simulated. The same on every machine.

/// Far from each other, each on its way and turning.
Trajectory make_sparse_drift(std::size_t bodies, int steps) {
  Random random(1, "sparse drift", 0);
  std::vector<FinePose> places = field(bodies, 4, 1.5, random);
  return moving(mixed_shapes(), std::move(places), courses_of(bodies, 0.02, 0.01, random), steps);
}

/// Boxes in a grid, each turning on the spot, corner against corner.
Trajectory make_spinning_grid(std::size_t bodies, int steps) {
  Random random(1, "spinning grid", 0);
  std::vector<FinePose> places = field(bodies, 1.2, 0, random);
  return moving({*rounded(box(0.5, 0.5), kSkin)}, std::move(places),
                courses_of(bodies, 0, 0.02, random), steps);
}

/// One body on its way through a field that rests.
Trajectory make_one_mover(std::size_t bodies, int steps) {
  Random random(1, "one mover", 0);
  std::vector<FinePose> places = field(bodies, 1.1, 0.1, random);
  return moving(mixed_shapes(), std::move(places), {{{0.05, 0.03}, turn_by(0.01)}}, steps);
}

/// Needles, all moving, in a crowd.
Trajectory make_slivers(std::size_t bodies, int steps) {
  Random random(1, "slivers", 0);
  std::vector<ConvexPolygon<float>> shapes;
  for (const double width : {0.002, 0.005, 0.01, 0.02}) {
    shapes.push_back(*rounded(stretched(regular_outline(3), width, 1), 0));
    shapes.push_back(*rounded(stretched(regular_outline(6), 1, width), 0));
  }
  std::vector<FinePose> places = field(bodies, 0.7, 0.2, random);
  return moving(std::move(shapes), std::move(places), courses_of(bodies, 0.005, 0.002, random),
                steps);
}

/// A dense field in which nothing moves.
Trajectory make_still(std::size_t bodies, int steps) {
  Random random(1, "still", 0);
  return moving(mixed_shapes(), field(bodies, 0.8, 0.05, random), {}, steps);
}

// Scenes recorded from Box2D's own world; larger ones are recordings side by side.

/// What is simulated at once; more would take long until they rest.
constexpr std::size_t kRecordedMax = 500;

/// A world whose bodies are polygons of a list.
struct Stage {
  std::vector<ConvexPolygon<float>> shapes;
  std::vector<WorldBody> bodies;
  std::vector<std::uint32_t> shape_of;
  double width = 0;  ///< from one recording to the next

  void add(std::uint32_t shape, double x, double y, bool is_fixed = false) {
    const Pose<float> pose{Vector2<double>(x, y).cast<float>(), {1, 0}};
    bodies.push_back({{shapes[shape], pose}, is_fixed});
    shape_of.push_back(shape);
  }

  /// A floor whose top is y = 0, as wide as the stage, and walls if they have a height.
  void enclose(double wall_height) {
    const auto add_fixed = [&](double half_width, double half_height, double x, double y) {
      shapes.push_back(*rounded(box(half_width, half_height), 0.01F));
      add(static_cast<std::uint32_t>(shapes.size() - 1), x, y, true);
    };
    add_fixed(width / 2, 0.5, width / 2, -0.5);
    if (wall_height == 0) return;
    add_fixed(0.5, wall_height / 2, 0.5, wall_height / 2);
    add_fixed(0.5, wall_height / 2, width - 0.5, wall_height / 2);
  }
};

/// The stage's recording after `warm_up` steps, side by side until there are enough bodies.
Trajectory recorded(const Stage& stage, std::size_t bodies, int warm_up, int steps,
                    const GravityTurn& gravity_turn = {}) {
  const auto poses = scene_engine().scenes.trajectory(stage.bodies, warm_up + steps, gravity_turn);
  Trajectory trajectory{stage.shapes, {}, {}};
  const std::size_t in_stage = stage.bodies.size();
  const auto pose_at = [&](std::size_t i, int step) {
    Pose<float> pose = poses[static_cast<std::size_t>(step)][i % in_stage];
    const std::size_t copy = i / in_stage;
    pose.position.x() += static_cast<float>(stage.width) * static_cast<float>(copy);
    return pose;
  };
  for (std::size_t i = 0; i < bodies; ++i) {
    trajectory.start.push_back({stage.shape_of[i % in_stage], pose_at(i, warm_up - 1)});
  }
  for (int step = warm_up; step < warm_up + steps; ++step) {
    std::vector<BodyMove>& moves = trajectory.steps.emplace_back();
    for (std::uint32_t i = 0; i < bodies; ++i) {
      const Pose<float> pose = pose_at(i, step);
      if (!same_bits(pose, pose_at(i, step - 1))) moves.push_back({i, pose});
    }
  }
  return trajectory;
}

Stage pile_stage(std::size_t bodies) {
  Stage stage;
  stage.shapes = mixed_shapes();
  const auto mixed = static_cast<std::uint32_t>(stage.shapes.size());
  const std::size_t columns = 20;
  const std::size_t dynamic = std::min(bodies, kRecordedMax) - 3;
  stage.width = 1.1 * static_cast<double>(columns) + 1.5;
  const std::size_t rows = dynamic / columns;
  stage.enclose(2.0 + 1.2 * static_cast<double>(rows));
  Random random(1, "pile", 0);
  for (std::uint32_t i = 0; i < dynamic; ++i) {
    const std::size_t row = i / columns;
    const double x = 1.4 + 1.1 * static_cast<double>(i % columns) + random.uniform(-0.1, 0.1);
    stage.add(i % mixed, x, 0.6 + 1.1 * static_cast<double>(row));
  }
  return stage;
}

/// Polygons that fall onto each other between walls.
Trajectory make_pile(std::size_t bodies, int steps) {
  return recorded(pile_stage(bodies), bodies, 90, steps);
}

/// A pile at rest that is then shaken: gravity turns by 0.05 radians a step.
Trajectory make_stirred(std::size_t bodies, int steps) {
  constexpr int kLies = 300;
  return recorded(pile_stage(bodies), bodies, kLies + 120, steps, {kLies, turn_by(0.05)});
}

/// A pile at rest; in each step a tenth of it, in turn, is nudged or falls back.
Trajectory make_resting_pile(std::size_t bodies, int steps) {
  Trajectory trajectory = recorded(pile_stage(bodies), bodies, 600, 1);
  trajectory.steps.clear();
  Random random(1, "resting pile", 0);
  std::vector<bool> is_nudged(bodies);
  for (std::size_t step = 0; step < static_cast<std::size_t>(steps); ++step) {
    std::vector<BodyMove>& moves = trajectory.steps.emplace_back();
    for (std::uint32_t i = static_cast<std::uint32_t>(step % 10); i < bodies; i += 10) {
      Pose<float> pose = trajectory.start[i].pose;
      is_nudged[i] = !is_nudged[i];
      if (is_nudged[i]) pose.position += (0.005 * random_direction(random)).cast<float>();
      moves.push_back({i, pose});
    }
  }
  return trajectory;
}

/// Boxes in pyramids that settle.
Trajectory make_pyramid(std::size_t bodies, int steps) {
  constexpr std::uint32_t kBase = 28;
  Stage stage;
  stage.shapes = {*rounded(box(0.5, 0.5), 0.01F)};
  stage.width = kBase * 1.1 + 4;
  stage.enclose(0);
  for (std::uint32_t row = 0; row < kBase; ++row) {
    for (std::uint32_t i = row; i < kBase; ++i) {
      if (stage.bodies.size() >= bodies) break;
      stage.add(0, 2.5 + 1.1 * (i - row / 2.0), 0.6 + 1.05 * row);
    }
  }
  return recorded(stage, bodies, 20, steps);
}

/// Polygons that fall far from each other, and lie where they fell.
Trajectory make_rain(std::size_t bodies, int steps) {
  Stage stage;
  stage.shapes = mixed_shapes();
  const auto mixed = static_cast<std::uint32_t>(stage.shapes.size());
  const auto dynamic = static_cast<std::uint32_t>(std::min(bodies, kRecordedMax) - 1);
  stage.width = 120;
  stage.enclose(0);
  Random random(1, "rain", 0);
  for (std::uint32_t i = 0; i < dynamic; ++i) {
    const double x = random.uniform(2, stage.width - 2);
    stage.add(i % mixed, x, 1.0 + 0.3 * i);
  }
  return recorded(stage, bodies, 120, steps);
}

#define MANIFUZZ_SPEC(name, sentence) {#name, sentence, make_##name},
constexpr SceneSpec kSpecs[] = {MANIFUZZ_SCENES(MANIFUZZ_SPEC)};
#undef MANIFUZZ_SPEC

}  // namespace

std::span<const SceneSpec> scene_specs() {
  return kSpecs;
}

}  // namespace manifuzz
