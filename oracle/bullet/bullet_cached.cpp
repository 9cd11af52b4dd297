#include "oracle/bullet/bullet_cached.hpp"

#include <BulletCollision/CollisionDispatch/btConvexConvexAlgorithm.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <deque>
#include <memory>

#include "external/external_collider.hpp"
#include "oracle/bullet/algorithm.hpp"

namespace manifuzz {
namespace {

using namespace manifuzz_bullet;

/// Puts into the plane what a query of prisms finds: a prism's point may be at any height, and two
/// that differ in nothing else are one. A normal that leaves the plane is no answer to a question
/// of it.
class InPlane : public btManifoldResult {
 public:
  using btManifoldResult::btManifoldResult;

  void addContactPoint(const btVector3& normal, const btVector3& point,
                       btScalar distance) override {
    const float length = in_plane(normal);
    if (length == 0) {
      left_plane_ = true;
      return;
    }
    btManifoldResult::addContactPoint(btVector3(normal.x() / length, normal.y() / length, 0),
                                      btVector3(point.x(), point.y(), 0), distance * length);
  }

  bool left_plane() const { return left_plane_; }

 private:
  bool left_plane_ = false;
};

/// Two bodies as Bullet's world would have them, and their manifold. Its threshold is that of the
/// shapes in the plane: the height of prisms is none of theirs, and the box of a hull is larger by
/// the margin of 0.04 that it is made with.
class Bodies {
 public:
  explicit Bodies(const PairCase& pair) : Bodies(c_body(pair.a), c_body(pair.b)) {
    manifold_->setContactBreakingThreshold(
        gContactBreakingThreshold *
        std::min(angular_disc(pair.a.polygon), angular_disc(pair.b.polygon)));
  }
  ~Bodies() { dispatcher_.releaseManifold(manifold_); }
  Bodies(const Bodies&) = delete;
  Bodies& operator=(const Bodies&) = delete;

  /// What a frame does: btCollisionDispatcher::defaultNearCallback. False where the normal leaves
  /// the plane.
  bool step(const btTransform& place_a, const btTransform& place_b, int frame) {
    object_a_.setWorldTransform(place_a);
    object_b_.setWorldTransform(place_b);
    const btCollisionObjectWrapper of_a(nullptr, &hull_a_, &object_a_, place_a, -1, -1);
    const btCollisionObjectWrapper of_b(nullptr, &hull_b_, &object_b_, place_b, -1, -1);
    const btCollisionAlgorithmConstructionInfo info(&dispatcher_, -1);
    btConvexConvexAlgorithm algorithm(manifold_, info, &of_a, &of_b, &solver_, 0, 0);
    InPlane result(&of_a, &of_b);
    result.setShapeIdentifiersA(-1, frame);  // a new point keeps it as m_index0
    algorithm.processCollision(&of_a, &of_b, btDispatcherInfo(), &result);
    result.refreshContactPoints();  // as the algorithm does with a manifold that it made
    return !result.left_plane();
  }

  btPersistentManifold& manifold() { return *manifold_; }

 private:
  Bodies(const manifuzz_body& a, const manifuzz_body& b)
      : dispatcher_(&configuration_),
        hull_a_(hull_of(a, half_heights(a, b).a)),
        hull_b_(hull_of(b, half_heights(a, b).b)) {
    object_a_.setCollisionShape(&hull_a_);
    object_b_.setCollisionShape(&hull_b_);
    manifold_ = dispatcher_.getNewManifold(&object_a_, &object_b_);
  }

  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btConvexHullShape hull_a_;
  btConvexHullShape hull_b_;
  btCollisionObject object_a_;
  btCollisionObject object_b_;
  btGjkEpaPenetrationDepthSolver solver_;
  btPersistentManifold* manifold_ = nullptr;
};

Vector2<double> of_plane(const btVector3& v) {
  return Vector2<float>(v.x(), v.y()).cast<double>();
}

/// What is kept of one sequence. A point's user data is its id, which Bullet hands on when a new
/// point takes its place.
class Memory {
 public:
  KeptAnswer next(const PairCase& pair) {
    if (total_radius(pair) > 0 && !is_round(pair)) {
      return Unsupported{"takes no polygons with mitred skins"};
    }
    if (!bodies_) bodies_ = std::make_unique<Bodies>(pair);
    const int frame = frame_++;
    if (!bodies_->step(place_of(c_body(pair.a)), place_of(c_body(pair.b)), frame)) {
      return Unsupported{"the normal leaves the plane"};
    }
    KeptManifold kept;
    btPersistentManifold& manifold = bodies_->manifold();
    for (int i = 0; i < manifold.getNumContacts(); ++i) {
      kept.points.push_back(kept_point(manifold.getContactPoint(i)));
    }
    return kept;
  }

 private:
  KeptPoint kept_point(btManifoldPoint& point) {
    if (point.m_userPersistentData == nullptr) {
      ids_.push_back(static_cast<int>(ids_.size()));
      point.m_userPersistentData = &ids_.back();
    }
    return {.id = *static_cast<const int*>(point.m_userPersistentData),
            .born = point.m_index0,
            .anchor_a = of_plane(point.m_localPointA),
            .anchor_b = of_plane(point.m_localPointB),
            .normal = -of_plane(point.m_normalWorldOnB),
            .travels_with = TravelsWith::world,
            .depth = -static_cast<double>(point.getDistance())};
  }

  std::unique_ptr<Bodies> bodies_;
  std::deque<int> ids_;
  int frame_ = 0;
};

Declaration declaration() {
  return {.name = "bullet-cached",
          .version = MANIFUZZ_BULLET_VERSION,
          .description = "Bullet's btPersistentManifold over btConvexConvexAlgorithm, of prisms",
          .scalar = ScalarType::float32,
          .frame = RoundingFrame::world,
          .takes_radius = false,
          .min_vertices = 1,
          .takes_round = true,
          .second_point = SecondPoint::never(),
          .claims = Claims::point,
          .clips = false,
          .points = PointsAt::surface_b,
          .tolerance = {.absolute = 1e-4},
          .tolerance_source = "btGjkEpa2.cpp: EPA_ACCURACY 0.0001"};
}

Keeping keeping() {
  const ShapeLength threshold{.absolute = 0,
                              .relative = static_cast<double>(gContactBreakingThreshold),
                              .measure = ShapeMeasure::angular_disc};
  return {.gap = threshold,
          .drift = threshold,
          .since = StaleSince::birth,
          .match = threshold,
          .match_by = MatchBy::a,
          .points_max = MANIFOLD_CACHE_SIZE};
}

}  // namespace

SequenceCollider make_bullet_cached() {
  SequenceCollider collider;
  collider.declaration = declaration();
  collider.keeping = keeping();
  collider.begin = [] {
    // Shared, since points at ids that are handed on must stay.
    return
        [memory = std::make_shared<Memory>()](const PairCase& pair) { return memory->next(pair); };
  };
  return collider;
}

}  // namespace manifuzz
