#pragma once

#include <vector>

#include "oracle/parry/ledger/simplex.hpp"

namespace manifuzz::parry {

/// How epa2.rs, closest_points, ended. Its other end, where it is stuck, is never reached: it asks
/// for candidate_max_dist < max_dist, which has just been lowered to it.
enum class EpaEnd {
  none,       ///< not asked
  corner,     ///< simplex.dimension() == 0: the corners' cones alone
  lost,       ///< FaceId::new(...)?, or no projection inside: None
  converged,  ///< max_dist - curr_dist < _eps_tol
  backward,   ///< dist < curr_dist of a new face
  exhausted   ///< 100 iterations, or no face left
};

/// Places on both shapes, and the normal of the face that they are on.
template <class Real>
struct EpaPlaces {
  Vector2<Real> on_a{0, 0};
  Vector2<Real> on_b{0, 0};
  Vector2<Real> normal{0, 0};
};

template <class Real>
struct EpaResult : EpaPlaces<Real> {
  EpaEnd end = EpaEnd::none;
  bool is_of_chord = false;      ///< of a chord's two sides, whose place is a corner: [1.0, 0.0]
  bool is_out_of_range = false;  ///< its face's length is no finite number
};

/// FaceId, and BinaryHeap of Rust's library with its order of equals.
template <class Real>
struct FaceInHeap {
  std::size_t face = 0;
  Real minus_distance = 0;

  bool is_at_most(const FaceInHeap& other) const {
    return !(minus_distance > other.minus_distance);
  }
};

template <class Real>
class FaceHeap {
 public:
  bool empty() const { return faces_.empty(); }
  const FaceInHeap<Real>& top() const { return faces_.front(); }
  void push(const FaceInHeap<Real>& face) {
    faces_.push_back(face);
    sift_up(faces_.size() - 1);
  }
  FaceInHeap<Real> pop() {
    FaceInHeap<Real> last = faces_.back();
    faces_.pop_back();
    if (faces_.empty()) return last;
    std::swap(last, faces_.front());
    sift_down_to_bottom();
    return last;
  }

 private:
  void sift_up(std::size_t at) {
    const FaceInHeap<Real> moved = faces_[at];
    while (at > 0 && !moved.is_at_most(faces_[(at - 1) / 2])) {
      faces_[at] = faces_[(at - 1) / 2];
      at = (at - 1) / 2;
    }
    faces_[at] = moved;
  }
  void sift_down_to_bottom() {
    const std::size_t size = faces_.size();
    const FaceInHeap<Real> moved = faces_[0];
    std::size_t at = 0;
    for (std::size_t child = 1; child < size; child = 2 * at + 1) {
      if (child + 1 < size && faces_[child].is_at_most(faces_[child + 1])) ++child;
      faces_[at] = faces_[child];
      at = child;
    }
    faces_[at] = moved;
    sift_up(at);
  }

  std::vector<FaceInHeap<Real>> faces_;
};

template <class Real>
class Epa {
 public:
  Epa(const Operands<Real>& operands, const Simplex<Real>& simplex) : operands_(operands) {
    for (int i = 0; i < simplex.count(); ++i) corners_.push_back(simplex.corner(i));
    Real scale = 0;
    for (const Corner<Real>& corner : corners_) scale = std::max(scale, length_of(corner.point));
    distance_tolerance_ = kGjkTolerance<Real> * std::max(scale, Real(1));
  }

  EpaResult<Real> run() {
    if (corners_.size() == 1) return at_corner();
    if (!(corners_.size() == 3 ? begin_with_triangle() : begin_with_chord())) return lost();
    return expand();
  }

  /// The same, but that it goes on where a new face is nearer than the one it came from.
  EpaResult<Real> run_on() {
    may_go_backward_ = true;
    return run();
  }

  /// The same, but that the distances of a chord's two sides are less than 0 of the side that the
  /// origin is beyond, as a triangle's are; parry has the other sign.
  EpaResult<Real> run_with_signs() {
    has_signs_ = true;
    return run();
  }

 private:
  struct Face {
    std::array<std::size_t, 2> ends;
    Vector2<Real> normal{0, 0};
    Vector2<Real> nearest{0, 0};
    std::array<Real, 2> shares{0, 0};
    bool is_deleted = false;
    bool is_of_chord = false;
    bool is_origin_beside = false;  ///< its projection is between the ends
  };

  static constexpr Real kTolerance = kEpsilon<Real> * Real(100);

  static EpaResult<Real> lost() {
    EpaResult<Real> result;
    result.end = EpaEnd::lost;
    return result;
  }

  Face face(std::size_t first, std::size_t second) const {
    Face made{.ends = {first, second}};
    const Vector2<Real>& a = corners_[first].point;
    const Vector2<Real> ab = corners_[second].point - a;
    const Real before = ab.dot(-a);
    const Real square = ab.dot(ab);
    constexpr Real tolerance = kGjkTolerance<Real>;
    if (square != 0 && !(before < -tolerance || before > square + tolerance)) {
      const Real share = before / square;
      made.nearest = a + ab * share;
      made.shares = {Real(1) - share, share};
      made.is_origin_beside = true;
    }
    set_normal(made);
    return made;
  }
  void set_normal(Face& made) const {
    const auto normal = face_normal(corners_[made.ends[0]].point, corners_[made.ends[1]].point);
    made.normal = normal.value_or(Vector2<Real>(0, 0));
    made.is_deleted = !normal;
  }

  /// Whether it is not too far on the wrong side.
  bool push(std::size_t face, Real minus_distance) {
    if (minus_distance > distance_tolerance_) return false;
    heap_.push({face, minus_distance});
    return true;
  }

  bool begin_with_triangle() {
    const Vector2<Real> first = corners_[1].point - corners_[0].point;
    const Vector2<Real> second = corners_[2].point - corners_[0].point;
    if (cross(first, second) < 0) std::swap(corners_[1], corners_[2]);
    for (std::size_t i = 0; i < 3; ++i) faces_.push_back(face(i, (i + 1) % 3));
    for (std::size_t i = 0; i < 3; ++i) {
      if (!faces_[i].is_origin_beside) continue;
      if (!push(i, -faces_[i].normal.dot(corners_[i].point))) return false;
    }
    return !heap_.empty();
  }

  bool begin_with_chord() {
    for (const std::size_t i : {0U, 1U}) {
      faces_.push_back({.ends = {i, 1 - i}, .shares = {1, 0}, .is_of_chord = true});
      set_normal(faces_.back());
    }
    const Real sign = has_signs_ ? Real(-1) : Real(1);
    return push(0, sign * faces_[0].normal.dot(corners_[0].point)) &&
           push(1, sign * faces_[1].normal.dot(corners_[1].point));
  }

  EpaResult<Real> at_corner() const {
    Vector2<Real> normal(0, 1);
    const auto turn = [&](const auto& support, const Vector2<Real>& corner, Real sign) {
      for (int i = 0; i < 100; ++i) {
        const auto along = try_normalize(Vector2<Real>(support(normal) - corner));
        if (!along || Vector2<Real>(sign * normal).dot(*along) < kTolerance) return;
        normal = Vector2<Real>(-along->y(), along->x());
      }
    };
    const Corner<Real>& corner = corners_[0];
    turn([&](const Vector2<Real>& n) { return operands_.of_a(n); }, corner.on_a, Real(1));
    turn([&](const Vector2<Real>& n) { return operands_.of_b(Vector2<Real>(-n)); }, corner.on_b,
         Real(-1));
    return {{corner.on_a, corner.on_b, normal}, EpaEnd::corner};
  }

  EpaPlaces<Real> places_on(const Face& face) const {
    const Corner<Real>& from = corners_[face.ends[0]];
    const Corner<Real>& to = corners_[face.ends[1]];
    return {from.on_a * face.shares[0] + to.on_a * face.shares[1],
            from.on_b * face.shares[0] + to.on_b * face.shares[1], face.normal};
  }
  EpaResult<Real> found(const Face& face, EpaEnd end) const {
    const Vector2<Real> along = corners_[face.ends[1]].point - corners_[face.ends[0]].point;
    return {places_on(face), end, face.is_of_chord, !std::isfinite(length_of(along))};
  }

  EpaResult<Real> expand() {
    int iterations = 0;
    Real farthest = std::numeric_limits<Real>::max();
    std::size_t best = heap_.top().face;
    while (!heap_.empty()) {
      const FaceInHeap<Real> id = heap_.pop();
      const Face current = faces_[id.face];
      if (current.is_deleted) continue;
      corners_.push_back(corner_along(operands_, current.normal));
      const std::size_t added = corners_.size() - 1;
      const Real reach = corners_.back().point.dot(current.normal);
      if (reach < farthest) {
        best = id.face;
        farthest = reach;
      }
      const Real distance = -id.minus_distance;
      if (farthest - distance < kTolerance) {
        return found(faces_[best], EpaEnd::converged);
      }
      for (const Face& made : {face(current.ends[0], added), face(added, current.ends[1])}) {
        if (made.is_origin_beside) {
          const Real to_face = made.normal.dot(made.nearest);
          if (to_face < distance && !may_go_backward_) return found(made, EpaEnd::backward);
          if (!made.is_deleted && !push(faces_.size(), -to_face)) return lost();
        }
        faces_.push_back(made);
      }
      if (++iterations > 100) break;
    }
    return found(faces_[best], EpaEnd::exhausted);
  }

  const Operands<Real>& operands_;
  std::vector<Corner<Real>> corners_;
  std::vector<Face> faces_;
  FaceHeap<Real> heap_;
  Real distance_tolerance_ = 0;
  bool may_go_backward_ = false;
  bool has_signs_ = false;
};

}  // namespace manifuzz::parry
