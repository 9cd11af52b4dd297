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

/// Bodies by the order in which they were added; the removed ones stay, not alive.
struct Model {
  struct Body {
    bool alive = true;
    std::uint32_t shape = 0;
    Pose<float> pose;
  };
  std::vector<Body> bodies;

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
  std::vector<Moved> moves;     ///< of the next step
  std::set<Ordinals> touching;  ///< after the last step

  explicit Subject(MakeScene make);

  void add(std::uint32_t shape, const Pose<float>& pose);
  void remove(std::size_t ordinal);

  /// Steps, and says what is not as it is afresh.
  std::optional<std::string> step(const Model& model);
};

}  // namespace manifuzz::test
