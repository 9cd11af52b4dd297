#pragma once

#include <rapidcheck.h>
#include <rapidcheck/state.h>

#include "unit/scene/motion.hpp"

// What may happen to a scene of at most 16 bodies, for rc::state.

namespace manifuzz::test {

inline constexpr std::size_t kBodiesMax = 16;

template <class Api>
using Command = rc::state::Command<Model, Subject<Api>>;

/// Something that a seed decides, about one of the bodies.
template <class Api>
struct Seeded : Command<Api> {
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

template <class Api>
struct Add : Seeded<Api> {
  void checkPreconditions(const Model& model) const override {
    RC_PRE(model.alive().size() < kBodiesMax);
  }
  void apply(Model& model) const override {
    model.bodies.push_back({true, this->shape(), anywhere(this->seed)});
  }
  void run(const Model&, Subject<Api>& subject) const override {
    subject.add(this->shape(), anywhere(this->seed));
  }
  const char* name() const override { return "add"; }
};

/// Something done to a body that is there.
template <class Api>
struct ToBody : Seeded<Api> {
  void checkPreconditions(const Model& model) const override { RC_PRE(!model.alive().empty()); }
};

template <class Api>
struct Remove : ToBody<Api> {
  void apply(Model& model) const override { model.bodies[this->body(model)].alive = false; }
  void run(const Model& model, Subject<Api>& subject) const override {
    subject.remove(this->body(model));
  }
  const char* name() const override { return "remove"; }
};

template <class Api>
struct SetShape : ToBody<Api> {
  void apply(Model& model) const override { model.bodies[this->body(model)].shape = this->shape(); }
  void run(const Model& model, Subject<Api>& subject) const override {
    subject.scene.set_shape(subject.handles[this->body(model)], this->shape());
  }
  const char* name() const override { return "set shape"; }
};

template <class Api>
struct Moving : ToBody<Api> {
  virtual Pose<float> moved(const Model& model, const Pose<float>& pose) const = 0;
  void apply(Model& model) const override {
    Pose<float>& pose = model.bodies[this->body(model)].pose;
    pose = moved(model, pose);
  }
  void run(const Model& model, Subject<Api>& subject) const override {
    const std::size_t body = this->body(model);
    subject.moves.push_back({subject.handles[body], moved(model, model.bodies[body].pose)});
  }
};

template <class Api>
struct Shift : Moving<Api> {
  Pose<float> moved(const Model&, const Pose<float>& pose) const override {
    return shifted(pose, this->seed);
  }
  const char* name() const override { return "move"; }
};

template <class Api>
struct Approach : Moving<Api> {
  Pose<float> moved(const Model& model, const Pose<float>& pose) const override {
    const auto alive = model.alive();
    const auto& other = model.bodies[alive[(this->seed >> 16) % alive.size()]];
    return nearer(pose, other.pose.position, this->seed);
  }
  const char* name() const override { return "approach"; }
};

template <class Api>
struct Turn : Moving<Api> {
  Pose<float> moved(const Model&, const Pose<float>& pose) const override {
    return turned(pose, this->seed);
  }
  const char* name() const override { return "turn"; }
};

template <class Api>
struct Teleport : Moving<Api> {
  Pose<float> moved(const Model&, const Pose<float>&) const override {
    return anywhere(this->seed);
  }
  const char* name() const override { return "teleport"; }
};

template <class Api>
struct QuarterTurn : Moving<Api> {
  Pose<float> moved(const Model&, const Pose<float>& pose) const override {
    return quarter_turned(pose);
  }
  const char* name() const override { return "quarter turn"; }
};

template <class Api>
struct OneUlp : Moving<Api> {
  Pose<float> moved(const Model&, const Pose<float>& pose) const override {
    return stepped_by_one_ulp(pose, this->seed);
  }
  const char* name() const override { return "one ulp"; }
};

template <class Api>
struct Step : Command<Api> {
  void apply(Model&) const override {}
  void run(const Model& model, Subject<Api>& subject) const override {
    if (const auto complaint = subject.step(model)) RC_FAIL(*complaint);
  }
  void show(std::ostream& out) const override { out << "step"; }
};

/// The property of one run of commands.
template <class Api>
void check_commands() {
  Subject<Api> subject;
  rc::state::check(
      Model{}, subject,
      rc::state::gen::execOneOfWithArgs<Add<Api>, Add<Api>, Remove<Api>, SetShape<Api>, Shift<Api>,
                                        Approach<Api>, Turn<Api>, Teleport<Api>, QuarterTurn<Api>,
                                        OneUlp<Api>, Step<Api>, Step<Api>, Step<Api>>());
}

}  // namespace manifuzz::test
