#pragma once

#include "geometry/manifold.hpp"
#include "kernel/shapes.hpp"

// One pair at a time, a face a lane. Equal to `clipping::collide`, bit for bit, on every
// instruction set. Asking for less costs less: `touches` and `separation` end where they know.

/// The manifolds of `clipping::collide`, bit for bit, faster: one pair or many at once.
namespace manifuzz::kernel {

/// A face of one polygon: the one that separated the pair, or won, last time. It is tried first:
/// where it still separates, nothing else is looked at.
struct FaceHint {
  Side side = Side::a;  ///< whose face
  int face = -1;        ///< its index; -1: none yet

  friend bool operator==(const FaceHint&, const FaceHint&) = default;
};

/// How far apart two polygons are. Touching: S, the greatest over all faces, and its face, A's of
/// equals. Else a face that separates by more than the total radius, which need not be the
/// greatest. Of pairs with a round shape: what their manifold's depth says where they touch, else
/// how far apart their cores are; without a face.
struct PairSeparation {
  bool touches = false;  ///< no face separates by more than the total radius
  float separation = 0;  ///< a length, radii left out; < 0 overlaps
  FaceHint face;         ///< whose separation it is
};

/// `clipping::collide(a, b, b_in_a, tie_bias)`: the manifold in A's frame, B standing at `b_in_a`
/// in it; `tie_bias` is a length >= 0. A hint, where one is given, is used and brought up to date;
/// it changes no result, whatever it says. Pairs with a round shape leave it as it is.
Manifold<float> collide(const ShapeRows& a, const ShapeRows& b, const Pose<float>& b_in_a,
                        float tie_bias = 0, FaceHint* hint = nullptr);

/// Whether no face separates the polygons by more than their total radius. (At the corners of
/// sharp polygons with a radius, the manifold may be empty all the same: their side planes cut it
/// off.) Pairs with a round shape touch where they have a manifold.
bool touches(const ShapeRows& a, const ShapeRows& b, const Pose<float>& b_in_a,
             FaceHint* hint = nullptr);

/// How far apart the polygons are. A hint may change which separating face is reported, nothing
/// else.
PairSeparation separation(const ShapeRows& a, const ShapeRows& b, const Pose<float>& b_in_a,
                          FaceHint* hint = nullptr);

}  // namespace manifuzz::kernel
