// Copied with the bugs planted into the collider, and compiled under a namespace of theirs.
#include "canary/planted.hpp"
#include "own_colliders/clip.cpp"

namespace manifuzz {
namespace {

[[maybe_unused]] const bool planted = canary::add_colliders({PLANTED_BUGS}, make_clip);

}  // namespace
}  // namespace manifuzz
