#pragma once

#include "judging/faults/replayed.hpp"
#include "oracle/cute_c2/gjk.hpp"

namespace manifuzz::as_cute {

/// What of the engine is to be mended: the ledger's entries compare answers.
struct Mends {
  bool is_normal_of_shape = false;  ///< a reference face's direction is its polygon's normal's
  bool is_unbiased = false;         ///< the face of the greater separation clips
  bool is_plane_inside = false;     ///< an end on a side plane is inside
  bool is_in_world = false;         ///< a capsule clips in the world, as the polygon stands there
  bool is_inside = false;           ///< a capsule and a polygon are at no distance
  bool is_on_surface = false;       ///< a capsule's points are a radius from its core
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

/// c2Collide.
CuteAnswer by_cute(const PairCase& pair, const Mends& mends);

}  // namespace manifuzz::as_cute
