// Copied for each bug planted into the collider, and compiled under the bug's namespace.
#include "canary/planted.hpp"
#include "clipping/collider.cpp"

namespace manifuzz {
namespace {

[[maybe_unused]] const bool planted = canary::add_collider("PLANTED_BUG", make_clip);

}  // namespace
}  // namespace manifuzz
