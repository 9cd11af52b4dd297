#pragma once

#include <array>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/random.hpp"
#include "generating/drafts.hpp"
#include "unit/scene/any_scene.hpp"

// Scenes held against colliding every pair afresh.

namespace manifuzz::test {

/// Bodies by the order in which they were added, each part of one for itself; the removed ones
/// stay, not alive.
struct Model {
  struct Body {
    bool alive = true;
    std::uint32_t shape = 0;
    Pose<float> pose;
    scene::Rules rules{};
    std::size_t first = 0;                 ///< the first part of its body, which may be itself
    std::optional<Pose<float>> in_body{};  ///< of a part
    Pose<float> body_pose{};               ///< of a first part's body
  };
  std::vector<Body> bodies;

  void add(Body body) {
    body.first = bodies.size();
    bodies.push_back(body);
  }
  /// A body of parts.
  void add(const std::vector<scene::BodyPart>& parts, const Pose<float>& pose,
           const scene::Rules& rules) {
    const std::size_t first = bodies.size();
    for (const auto& [shape, at] : parts) {
      bodies.push_back({true, shape, scene::composed(pose, at), rules, first, at, pose});
    }
  }

  const Pose<float>& pose(std::size_t body) const {
    return bodies[body].in_body ? bodies[body].body_pose : bodies[body].pose;
  }

  template <class Change>
  void change_parts(std::size_t body, const Change& change) {
    for (Body& part : bodies) {
      if (part.first == body) change(part);
    }
  }
  void move(std::size_t body, const Pose<float>& to) {
    change_parts(body, [&](Body& part) {
      part.pose = part.in_body ? scene::composed(to, *part.in_body) : to;
      part.body_pose = to;
    });
  }

  std::vector<std::size_t> alive() const {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (bodies[i].alive) found.push_back(i);
    }
    return found;
  }
};

/// Two bodies of a model, A first.
using Ordinals = std::array<std::size_t, 2>;

/// Boxes, a long bar, a sliver, polygons of every count, with and without a radius; circles, a
/// segment, a capsule, polygons with round corners.
const std::vector<ConvexPolygon<float>>& shapes_for_scenes();

/// A scene under test, and what is to be done to it next.
struct Subject {
  std::unique_ptr<AnyScene> scene;
  std::vector<Handle> handles;  ///< by ordinal
  bool is_named_twice = false;  ///< one of them is another's
  std::vector<Moved> moves;     ///< of the next step
  std::set<Ordinals> touching;  ///< after the last step
  std::vector<Ordinals> pairs;  ///< by contact, after the last step

  explicit Subject(MakeScene make);

  void keep(const Handle& handle);
  void add(const Model::Body& body);
  void add(const std::vector<scene::BodyPart>& parts, const Pose<float>& pose,
           const scene::Rules& rules);
  void remove(std::size_t ordinal);

  /// Steps, and says what is not as it is afresh.
  std::optional<std::string> step(const Model& model);
};

}  // namespace manifuzz::test
