#pragma once

#include <cstdint>
#include <span>

#include "afresh/shape_table.hpp"
#include "kernel/packed.hpp"

namespace manifuzz::scene {

/// `out[i]` becomes the box of body `bodies[i]`, padded so that bodies whose boxes do not overlap
/// have no contact by the kernel's rounded arithmetic (certificates.md, "Boxes").
void padded_boxes(const ShapeTable& shapes, std::span<const kernel::Placement<float>> placements,
                  std::span<const std::uint32_t> bodies, std::span<Box> out);

}  // namespace manifuzz::scene
