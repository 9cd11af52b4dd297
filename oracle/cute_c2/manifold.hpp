#pragma once

#include "judging/faults/replayed.hpp"
#include "oracle/cute_c2/gjk.hpp"

namespace manifuzz::as_cute {

/// What cute_c2 is at fault with.
enum class FaultOfCute : unsigned {
  placed_vertices = 1,  ///< a face's normal is that of its placed ends, in float
  bias = 2,             ///< B's face clips though A's is farther
  open_planes = 4,      ///< an end on a side plane is outside
  two_frames = 8,       ///< a capsule's ends in the polygon's frame clip an edge in the world
  on_core = 16,         ///< a capsule's points are on its core
  one_point = 32,       ///< one point at most where cores are apart
  nearest_places = 64,  ///< the normal is the direction between the nearest places of c2GJK
  inside = 128          ///< cores at no distance: A's left side, and the sum of the radii
};

/// How c2Collide came to its answer.
enum class Way {
  apart,    ///< no contact
  nearest,  ///< one point between the nearest places of c2GJK
  inside,   ///< one point, the distance being 0
  face      ///< a face's clip, or a circle on it
};

struct CuteAnswer {
  replayed::Contact contact;
  Way way = Way::apart;
  float distance = 0;                ///< of c2GJK
  Vector2<double> on_core{0, 0};     ///< of one point, before the radius moves it
  double out = 0;                    ///< how far along the normal that does
  bool is_within_epsilon = false;    ///< of one point between corners nearer than epsilon
  Vector2<double> own_normal{0, 0};  ///< of polygons: the clipping face's, of its own vertices
};

/// c2Collide, with some faults mended.
CuteAnswer by_cute(const PairCase& pair, unsigned mended);

}  // namespace manifuzz::as_cute
