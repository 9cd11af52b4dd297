#include "unit/scene/crowd.hpp"

#include "unit/scene/model.hpp"
#include "unit/scene/motion.hpp"

namespace manifuzz::test {
namespace {

/// How a body of the crowd goes on, while nothing happens to it.
struct Course {
  Vector2<float> by{0, 0};
  Vector2<double> turn{1, 0};
};

Course course(Random& random, double resting) {
  Course course;
  if (random.chance(resting)) return course;
  const double length = random.magnitude(-16, -3);
  course.by = (length * random_direction(random)).cast<float>();
  if (random.chance(0.5)) course.turn = turn_by(random.either_sign(random.magnitude(-16, -4)));
  return course;
}

class Crowd {
 public:
  Crowd(MakeScene make, std::uint64_t seed, std::size_t bodies)
      : random_(seed, "crowd", 0), resting_(seed % 2 == 0 ? 0.4 : 0.96), subject_(make) {
    for (std::size_t i = 0; i < bodies; ++i) add();
  }

  /// What is wrong after so many steps, if anything.
  std::optional<std::string> run(int steps) {
    for (int step = 0; step < steps; ++step) {
      for (const std::size_t body : model_.alive()) advance(body);
      if (const auto complaint = subject_.step(model_)) {
        return "step " + std::to_string(step) + ": " + *complaint;
      }
    }
    return std::nullopt;
  }

 private:
  void add() {
    const std::uint32_t shape = any_shape();
    Pose<float> pose = anywhere(random_.bits());
    pose.position *= 3;
    model_.add({true, shape, pose});
    subject_.add(model_.bodies.back());
    courses_.push_back(course(random_, resting_));
  }

  std::uint32_t any_shape() {
    static const int last = static_cast<int>(shapes_for_scenes().size()) - 1;
    return static_cast<std::uint32_t>(random_.integer(0, last));
  }

  void advance(std::size_t body) {
    Model::Body& b = model_.bodies[body];
    if (random_.chance(0.01)) {
      b.alive = false;
      subject_.remove(body);
      return add();
    }
    if (random_.chance(0.01)) {
      b.shape = any_shape();
      subject_.scene->set_shape(subject_.handles[body], b.shape);
    }
    if (random_.chance(0.02)) courses_[body] = course(random_, resting_);
    const Course& on = courses_[body];
    if (on.by == Vector2<float>(0, 0)) return;
    b.pose.position += on.by;
    b.pose.rotation = unit(rotate<double>(on.turn, b.pose.rotation.cast<double>())).cast<float>();
    subject_.moves.push_back({subject_.handles[body], b.pose});
  }

  Random random_;
  double resting_;  // the share of bodies: where few move, a scene goes another way
  Model model_;
  Subject subject_;
  std::vector<Course> courses_;
};

}  // namespace

std::optional<std::string> crowd_complaint(MakeScene make, std::uint64_t seed) {
  return Crowd(make, seed, 100).run(60);
}

std::optional<std::string> dense_crowd_complaint(MakeScene make) {
  return Crowd(make, 0, 1800).run(3);
}

}  // namespace manifuzz::test
