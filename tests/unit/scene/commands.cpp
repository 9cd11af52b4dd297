#include "unit/scene/commands.hpp"

#include <rapidcheck.h>
#include <rapidcheck/state.h>

#include "unit/scene/model.hpp"
#include "unit/scene/motion.hpp"

namespace manifuzz::test {
namespace {

constexpr std::size_t kBodiesMax = 16;

using Command = rc::state::Command<Model, Subject>;

/// Something that a seed decides, about one of the bodies.
struct Seeded : Command {
  std::uint64_t seed = *rc::gen::arbitrary<std::uint64_t>();

  std::size_t body(const Model& model) const {
    const auto alive = model.alive();
    return alive[(seed >> 32) % alive.size()];
  }
  std::uint32_t shape() const {
    static const std::size_t count = shapes_for_scenes().size();
    return static_cast<std::uint32_t>((seed >> 8) % count);
  }
  virtual const char* name() const = 0;
  void show(std::ostream& out) const override { out << name() << ' ' << seed; }
};

struct Add : Seeded {
  void checkPreconditions(const Model& model) const override {
    RC_PRE(model.alive().size() < kBodiesMax);
  }
  void apply(Model& model) const override {
    model.bodies.push_back({true, shape(), anywhere(seed)});
  }
  void run(const Model&, Subject& subject) const override { subject.add(shape(), anywhere(seed)); }
  const char* name() const override { return "add"; }
};

/// Something done to a body that is there.
struct ToBody : Seeded {
  void checkPreconditions(const Model& model) const override { RC_PRE(!model.alive().empty()); }
};

struct Remove : ToBody {
  void apply(Model& model) const override { model.bodies[body(model)].alive = false; }
  void run(const Model& model, Subject& subject) const override { subject.remove(body(model)); }
  const char* name() const override { return "remove"; }
};

struct SetShape : ToBody {
  void apply(Model& model) const override { model.bodies[body(model)].shape = shape(); }
  void run(const Model& model, Subject& subject) const override {
    subject.scene->set_shape(subject.handles[body(model)], shape());
  }
  const char* name() const override { return "set shape"; }
};

struct Moving : ToBody {
  virtual Pose<float> moved(const Model& model, const Pose<float>& pose) const = 0;
  void apply(Model& model) const override {
    Pose<float>& pose = model.bodies[body(model)].pose;
    pose = moved(model, pose);
  }
  void run(const Model& model, Subject& subject) const override {
    const std::size_t ordinal = body(model);
    subject.moves.push_back({subject.handles[ordinal], moved(model, model.bodies[ordinal].pose)});
  }
};

struct Shift : Moving {
  Pose<float> moved(const Model&, const Pose<float>& pose) const override {
    return shifted(pose, seed);
  }
  const char* name() const override { return "move"; }
};

struct Approach : Moving {
  Pose<float> moved(const Model& model, const Pose<float>& pose) const override {
    const auto alive = model.alive();
    const auto& other = model.bodies[alive[(seed >> 16) % alive.size()]];
    return nearer(pose, other.pose.position, seed);
  }
  const char* name() const override { return "approach"; }
};

struct Turn : Moving {
  Pose<float> moved(const Model&, const Pose<float>& pose) const override {
    return turned(pose, seed);
  }
  const char* name() const override { return "turn"; }
};

struct Teleport : Moving {
  Pose<float> moved(const Model&, const Pose<float>&) const override { return anywhere(seed); }
  const char* name() const override { return "teleport"; }
};

struct QuarterTurn : Moving {
  Pose<float> moved(const Model&, const Pose<float>& pose) const override {
    return quarter_turned(pose);
  }
  const char* name() const override { return "quarter turn"; }
};

struct OneUlp : Moving {
  Pose<float> moved(const Model&, const Pose<float>& pose) const override {
    return stepped_by_one_ulp(pose, seed);
  }
  const char* name() const override { return "one ulp"; }
};

struct Step : Command {
  void apply(Model&) const override {}
  void run(const Model& model, Subject& subject) const override {
    if (const auto complaint = subject.step(model)) RC_FAIL(*complaint);
  }
  void show(std::ostream& out) const override { out << "step"; }
};

}  // namespace

void check_commands(MakeScene make) {
  Subject subject(make);
  rc::state::check(
      Model{}, subject,
      rc::state::gen::execOneOfWithArgs<Add, Add, Remove, SetShape, Shift, Approach, Turn, Teleport,
                                        QuarterTurn, OneUlp, Step, Step, Step>());
}

}  // namespace manifuzz::test
