#pragma once

#include <array>
#include <bit>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

#include "cases/placing.hpp"
#include "cases/random.hpp"
#include "kernel/batch.hpp"

// Scenes held against colliding every pair afresh. Everything that knows a scene's own types takes
// them from `Api`, so that copies with planted bugs can be held against the same.

namespace manifuzz::test {

inline constexpr float kTieBias = 0.0005F;

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
using Contacts = std::map<Ordinals, Manifold<float>>;

/// Boxes, a long bar, a sliver, polygons of every count, with and without a radius.
inline std::vector<ConvexPolygon<float>> shapes_for_scenes() {
  std::vector<ConvexPolygon<float>> shapes;
  const auto add = [&](const Outline& outline, float radius) {
    if (const auto polygon = rounded(outline, radius)) shapes.push_back(*polygon);
  };
  add(box(0.5, 0.5), 0);
  add(box(3, 0.05), 0);
  add(stretched(regular_outline(3), 1, 0.001), 0);
  add(box(0.25, 0.5), 0.01F);
  for (int count = kMinVertices; count <= kMaxVertices; ++count) {
    Random random(1, "scene shapes", static_cast<std::uint64_t>(count));
    add(stretched(random_outline(random, count), 0.5, 0.5), count % 2 == 0 ? 0.0F : 0.02F);
  }
  add(moved(box(0.2, 0.2), {1, 1}), 0);  // its origin lies outside
  return shapes;
}

inline bool same_bits(float x, float y) {
  return std::bit_cast<std::uint32_t>(x) == std::bit_cast<std::uint32_t>(y);
}

inline bool same_bits(const Vector2<float>& v, const Vector2<float>& w) {
  return same_bits(v.x(), w.x()) && same_bits(v.y(), w.y());
}

inline bool same_bits(const Manifold<float>& m, const Manifold<float>& n) {
  if (m.count != n.count || m.reference != n.reference || !same_bits(m.normal, n.normal))
    return false;
  for (int i = 0; i < m.count; ++i) {
    const auto& [p, q] = std::tie(m.points[i], n.points[i]);
    if (!same_bits(p.position, q.position) || !same_bits(p.depth, q.depth) ||
        p.features != q.features) {
      return false;
    }
  }
  return true;
}

/// A scene under test, and what is to come to it.
template <class Api>
struct Subject {
  typename Api::Scene scene{kTieBias};
  std::vector<typename Api::BodyHandle> handles;  // by ordinal
  std::vector<typename Api::Move> moves;          // of the next step
  std::set<Ordinals> touching;                    // after the last step

  Subject() {
    for (const auto& shape : shapes_for_scenes()) scene.add_shape(shape);
  }

  void add(std::uint32_t shape, const Pose<float>& pose) {
    handles.push_back(std::get<typename Api::BodyHandle>(scene.add(shape, pose)));
  }

  void remove(std::size_t ordinal) {
    std::erase_if(moves, [&](const auto& move) { return move.body == handles[ordinal]; });
    scene.remove(handles[ordinal]);
  }

  Ordinals ordered(std::size_t i, std::size_t j) const {
    return handles[i].index < handles[j].index ? Ordinals{i, j} : Ordinals{j, i};
  }

  /// All pairs of bodies by the kernel, nothing skipped.
  Contacts afresh(const Model& model) const {
    kernel::Shapes<float> shapes;
    for (const auto& shape : shapes_for_scenes()) shapes.add(shape);
    std::vector<kernel::Placement<float>> placements;
    for (const Model::Body& body : model.bodies) placements.push_back({body.shape, body.pose});
    std::vector<kernel::BodyPair> pairs;
    const auto alive = model.alive();
    for (std::size_t i = 0; i < alive.size(); ++i) {
      for (std::size_t j = i + 1; j < alive.size(); ++j) {
        const auto [a, b] = ordered(alive[i], alive[j]);
        pairs.push_back({static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b)});
      }
    }
    std::vector<Manifold<float>> manifolds(pairs.size());
    kernel::collide_pairs(shapes, placements, pairs, kTieBias, manifolds);
    Contacts contacts;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      if (manifolds[i].count > 0) contacts[{pairs[i].a, pairs[i].b}] = manifolds[i];
    }
    return contacts;
  }

  /// The last body that had a handle; of the removed ones, too.
  std::optional<std::size_t> ordinal_of(const typename Api::BodyHandle& handle) const {
    for (std::size_t i = handles.size(); i-- > 0;) {
      if (handles[i] == handle) return i;
    }
    return std::nullopt;
  }

  /// Steps, and says what is not as it is afresh.
  std::optional<std::string> step(const Model& model) {
    const auto stepped = scene.step(moves);
    moves.clear();
    const auto* const result = std::get_if<typename Api::StepResult>(&stepped);
    if (result == nullptr) return "the step is refused";
    std::set<Ordinals> now;
    const Contacts right = afresh(model);
    for (const auto& contact : result->contacts) {
      const auto a = ordinal_of(contact.a);
      const auto b = ordinal_of(contact.b);
      if (!a || !b) return "a contact of nobody";
      const auto found = right.find({*a, *b});
      if (found == right.end()) return "a contact that is none";
      if (!same_bits(found->second, contact.manifold)) return "another manifold";
      if (!now.insert({*a, *b}).second) return "a contact twice";
    }
    if (now.size() != right.size()) return "a contact is missing";
    const auto complaint = changes_complaint(*result, now);
    touching = std::move(now);
    return complaint;
  }

  /// What is wrong with what began, stayed and ended, and with the counters.
  std::optional<std::string> changes_complaint(const typename Api::StepResult& result,
                                               const std::set<Ordinals>& now) const {
    std::set<Ordinals> began;
    for (const std::uint32_t i : result.began) {
      const auto& contact = result.contacts[i];
      began.insert({*ordinal_of(contact.a), *ordinal_of(contact.b)});
    }
    std::set<Ordinals> expected = touching;
    expected.insert(began.begin(), began.end());
    for (const auto& ended : result.ended) {
      const auto a = ordinal_of(ended.a);
      const auto b = ordinal_of(ended.b);
      if (!a || !b || expected.erase({*a, *b}) == 0) return "an end that was none";
    }
    if (expected != now) return "begun and ended do not lead from the contacts before to these";
    for (const Ordinals& pair : began) {
      if (touching.count(pair) > 0) return "a contact begins again";
    }
    if (result.stayed + began.size() != now.size()) return "the contacts that stayed";
    const auto& counts = result.counts.pairs;
    if (counts.at_rest + counts.separated + counts.collided != counts.candidates ||
        counts.candidates != scene.pair_count() || counts.candidates < now.size()) {
      return "the counters do not add up";
    }
    return std::nullopt;
  }
};

}  // namespace manifuzz::test
