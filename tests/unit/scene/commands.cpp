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

  /// Its first part, where it has several.
  std::size_t body(const Model& model) const {
    const auto alive = model.alive();
    return model.bodies[alive[(seed >> 32) % alive.size()]].first;
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
  virtual Model::Body added() const { return {true, shape(), anywhere(seed)}; }
  void apply(Model& model) const override { model.add(added()); }
  void run(const Model&, Subject& subject) const override { subject.add(added()); }
  const char* name() const override { return "add"; }
};

/// Two categories, and three groups, one of them none.
scene::Filter filter_of(std::uint64_t seed) {
  Random random(seed, "filter", 0);
  const auto bits = [&] { return static_cast<std::uint32_t>(random.integer(1, 3)); };
  return {bits(), bits(), static_cast<std::int32_t>(random.integer(-1, 1))};
}

struct AddWithRules : Add {
  Model::Body added() const override {
    Model::Body body = Add::added();
    body.rules = {(seed & 4) != 0 ? filter_of(seed) : scene::Filter{}, (seed & 1) != 0,
                  (seed & 2) != 0};
    return body;
  }
  const char* name() const override { return "add with rules"; }
};

struct AddOfParts : AddWithRules {
  std::vector<scene::BodyPart> parts() const {
    static const std::size_t count = shapes_for_scenes().size();
    Random random(seed, "parts", 0);
    std::vector<scene::BodyPart> all(static_cast<std::size_t>(random.integer(1, 4)));
    for (scene::BodyPart& part : all) {
      part.shape = static_cast<std::uint32_t>(random.bits() % count);
      part.pose = anywhere(random.bits());
      part.pose.position *= 0.25F;
    }
    return all;
  }
  void apply(Model& model) const override { model.add(parts(), anywhere(seed), added().rules); }
  void run(const Model&, Subject& subject) const override {
    subject.add(parts(), anywhere(seed), added().rules);
  }
  const char* name() const override { return "add of parts"; }
};

/// Something done to a body that is there.
struct ToBody : Seeded {
  void checkPreconditions(const Model& model) const override { RC_PRE(!model.alive().empty()); }
};

struct Remove : ToBody {
  void apply(Model& model) const override {
    model.change_parts(body(model), [](Model::Body& part) { part.alive = false; });
  }
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

struct SetFilter : ToBody {
  void apply(Model& model) const override {
    model.change_parts(body(model),
                       [&](Model::Body& part) { part.rules.filter = filter_of(seed); });
  }
  void run(const Model& model, Subject& subject) const override {
    subject.scene->set_filter(subject.handles[body(model)], filter_of(seed));
  }
  const char* name() const override { return "set filter"; }
};

struct Moving : ToBody {
  virtual Pose<float> moved(const Model& model, const Pose<float>& pose) const = 0;
  void apply(Model& model) const override {
    const std::size_t ordinal = body(model);
    model.move(ordinal, moved(model, model.pose(ordinal)));
  }
  void run(const Model& model, Subject& subject) const override {
    const std::size_t ordinal = body(model);
    subject.moves.push_back({subject.handles[ordinal], moved(model, model.pose(ordinal))});
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
      rc::state::gen::execOneOfWithArgs<Add, Add, AddWithRules, AddOfParts, Remove, SetShape,
                                        SetFilter, Shift, Approach, Turn, Teleport, QuarterTurn,
                                        OneUlp, Step, Step, Step>());
}

}  // namespace manifuzz::test
