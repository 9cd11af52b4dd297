// Copied for each bug planted into the collider, and compiled under the bug's namespace.
#include "canary/planted.hpp"
#include "own_colliders/clip.cpp"

namespace manifuzz {
namespace {

[[maybe_unused]] const bool planted = canary::add_collider("PLANTED_BUG", make_clip);

}  // namespace
}  // namespace manifuzz
