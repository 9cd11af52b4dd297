#pragma once

#include <functional>
#include <initializer_list>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "collider/collider.hpp"
#include "collider/sequence_collider.hpp"
#include "judging/ledger.hpp"
#include "sequence/sequence_ledger.hpp"

namespace manifuzz {

/// A collider by its name.
struct ColliderEntry {
  std::string_view name;
  std::function<Collider()> make;
  bool is_ours = false;  ///< of this repository, not one that it is held against
};

/// A collider that keeps points, by its name.
struct SequenceColliderEntry {
  std::string_view name;
  std::function<SequenceCollider()> make;
  bool is_ours = false;  ///< of this repository, not one that it is held against
};

/// One query through all pairs once, as a user of the engine asks it: gets ready what is not timed,
/// and gives what is.
struct TimedPass {
  std::string_view name;      ///< in the table of times
  std::string_view collider;  ///< whose errors stand beside its times
  std::string_view method;    ///< among the article's methods; empty: not among them
  std::function<void()> (*prepare)(std::span<const PairCase> pairs) = nullptr;
};

/// A body's new place.
struct BodyMove {
  std::uint32_t body = 0;  ///< its index
  Pose<float> pose;
};

/// A body of a world to be simulated.
struct WorldBody {
  Body body;
  bool is_fixed = false;
};

/// The manifolds of a scene as an engine's contact manager gets them, without its solver.
class ScenePairs {
 public:
  ScenePairs() = default;
  virtual ~ScenePairs() = default;
  ScenePairs& operator=(ScenePairs&&) = delete;  // neither moved nor copied

  /// Collides all pairs, or those alone of which a body moved, as sleep allows.
  virtual void step(std::span<const BodyMove> moves, bool skip_unmoved) = 0;
};

/// How a world's gravity turns: by a (cos, sin) after each step, but for the first ones.
struct GravityTurn {
  int first_step = 0;
  Vector2<double> by{1, 0};
};

/// What scenes are held against, and recorded from.
struct SceneBaseline {
  std::unique_ptr<ScenePairs> (*pairs)(std::span<const Body> bodies) = nullptr;
  /// The poses of all bodies after each step of the engine's world.
  std::vector<std::vector<Pose<float>>> (*trajectory)(std::span<const WorldBody> bodies, int steps,
                                                      const GravityTurn& gravity_turn) = nullptr;
};

/// The rows on other causes than these, which all must be among those of the rows.
std::vector<LedgerRow> rows_but_for(std::initializer_list<std::string_view> causes,
                                    std::span<const LedgerRow> rows);

/// An engine that colliders are asked of: a folder in oracle/. What is compiled of it is here, and
/// each of it may be absent; how its colliders are asked says its engine.json.
struct Engine {
  std::string_view name;                         ///< its folder's
  std::vector<LedgerRows> ledger{};              ///< its known deviations
  std::vector<SequenceRows> sequence_ledger{};   ///< those over frames
  std::vector<ColliderEntry> colliders{};        ///< that are linked into this program
  std::vector<SequenceColliderEntry> keepers{};  ///< likewise, that keep points
  std::vector<TimedPass> passes{};
  SceneBaseline scenes{};
};

/// The engines that the program is built with, in the order of oracle/engines.txt. The build writes
/// their list.
std::span<const Engine> built_engines();

/// The first of them that has a baseline for scenes.
const Engine& scene_engine();

}  // namespace manifuzz
