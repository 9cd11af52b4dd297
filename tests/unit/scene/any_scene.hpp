#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "geometry/convex_polygon.hpp"
#include "geometry/manifold.hpp"
#include "scene/parts.hpp"

// A scene as its tests see it: the project's own, or a copy with a bug planted into it.

namespace manifuzz::test {

inline constexpr float kTieBias = 0.0005F;

struct Handle {
  std::uint32_t index = 0;
  std::uint32_t generation = 0;

  friend bool operator==(const Handle&, const Handle&) = default;
};

struct Moved {
  Handle body;
  Pose<float> pose;
};

struct Touching {
  Handle a;
  Handle b;
  Manifold<float> manifold;
};

struct Stepped {
  std::vector<Touching> contacts;
  std::vector<std::uint32_t> began;
  std::vector<std::array<std::uint32_t, 2>> renumbered;
  std::vector<std::array<Handle, 2>> ended;
  std::size_t stayed = 0;
  std::size_t at_rest = 0;
  std::size_t separated = 0;
  std::size_t collided = 0;
  std::size_t candidates = 0;
};

class AnyScene {
 public:
  virtual ~AnyScene() = default;
  virtual void add_shape(const ConvexPolygon<float>& polygon) = 0;
  virtual Handle add(std::uint32_t shape, const Pose<float>& pose, const scene::Rules& rules) = 0;
  /// The handle of each part.
  virtual std::vector<Handle> add(const std::vector<scene::BodyPart>& parts,
                                  const Pose<float>& pose, const scene::Rules& rules) = 0;
  virtual void remove(const Handle& body) = 0;
  virtual void set_shape(const Handle& body, std::uint32_t shape) = 0;
  virtual void set_filter(const Handle& body, const scene::Filter& filter) = 0;
  virtual std::optional<Stepped> step(const std::vector<Moved>& moves) = 0;
};

using MakeScene = std::unique_ptr<AnyScene> (*)();

/// `Api` names a scene's types.
template <class Api>
class Adapted : public AnyScene {
 public:
  static std::unique_ptr<AnyScene> make() { return std::make_unique<Adapted>(); }

  void add_shape(const ConvexPolygon<float>& polygon) override { scene_.add_shape(polygon); }
  Handle add(std::uint32_t shape, const Pose<float>& pose, const scene::Rules& rules) override {
    return plain(std::get<Own>(scene_.add(shape, pose, own(rules))));
  }
  std::vector<Handle> add(const std::vector<scene::BodyPart>& parts, const Pose<float>& pose,
                          const scene::Rules& rules) override {
    std::vector<typename Api::BodyPart> own_parts;
    for (const auto& [shape, at] : parts) own_parts.push_back({shape, at});
    const Own body = std::get<Own>(scene_.add(own_parts, pose, own(rules)));
    std::vector<Handle> handles;
    for (std::uint32_t part = 0; part < parts.size(); ++part) {
      handles.push_back(plain(scene_.handle({body, part})));
    }
    return handles;
  }
  void remove(const Handle& body) override { scene_.remove(own(body)); }
  void set_shape(const Handle& body, std::uint32_t shape) override {
    scene_.set_shape(own(body), shape);
  }
  void set_filter(const Handle& body, const scene::Filter& filter) override {
    scene_.set_filter(own(body), own(filter));
  }
  std::optional<Stepped> step(const std::vector<Moved>& moves) override {
    std::vector<typename Api::Move> own_moves;
    own_moves.reserve(moves.size());
    for (const Moved& moved : moves) own_moves.push_back({own(moved.body), moved.pose});
    const auto stepped = step_with(own_moves);
    const auto* const result = std::get_if<0>(&stepped);
    if (result == nullptr) return std::nullopt;
    const auto& pairs = result->counts.pairs;
    Stepped plainly{{},
                    {result->began.begin(), result->began.end()},
                    {},
                    {},
                    result->stayed,
                    pairs.at_rest,
                    pairs.separated,
                    pairs.collided,
                    pairs.candidates};
    for (const auto& c : result->contacts) {
      plainly.contacts.push_back({plain(c.a), plain(c.b), c.manifold});
    }
    for (const auto& [from, to] : result->renumbered) plainly.renumbered.push_back({from, to});
    for (const auto& ended : result->ended) {
      plainly.ended.push_back({plain(ended.a), plain(ended.b)});
    }
    return plainly;
  }

 private:
  using Own = typename Api::BodyHandle;
  auto step_with(const std::vector<typename Api::Move>& moves) {
    if constexpr (requires { Api::executor(); }) {
      return scene_.step(moves, Api::executor());
    } else {
      return scene_.step(moves);
    }
  }
  static Own own(const Handle& handle) { return {handle.index, handle.generation}; }
  static typename Api::Rules own(const scene::Rules& rules) {
    return {own(rules.filter), rules.is_static, rules.is_sensor};
  }
  static typename Api::Filter own(const scene::Filter& filter) {
    return {filter.category, filter.mask, filter.group};
  }
  static Handle plain(const Own& handle) { return {handle.index, handle.generation}; }

  typename Api::Scene scene_{{.tie_bias = kTieBias}};
};

}  // namespace manifuzz::test
