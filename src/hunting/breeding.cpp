#include "hunting/breeding.hpp"

#include <algorithm>
#include <array>

#include "generating/drafts.hpp"
#include "hunting/moves.hpp"

namespace manifuzz {
namespace {

void renumber_by_chance(Random& random, PairCase& pair) {
  for (const Side side : {Side::a, Side::b}) {
    for (int i = random.integer(0, pair[side].polygon.count - 1); i > 0; --i) {
      renumber(pair[side].polygon);
    }
  }
}

/// Whether a shape has the bits that it had, normals included: moves may leave these behind.
bool is_untouched(const ConvexPolygon<float>& shape, const ConvexPolygon<float>& before) {
  if (shape != before) return false;
  for (int i = 0; i < shape.count; ++i) {
    if (!same_bits(shape.vertices[i], before.vertices[i])) return false;
    if (!same_bits(shape.normals[i], before.normals[i])) return false;
  }
  return true;
}

}  // namespace

std::optional<PairCase> bred(Random& random, const PairCase& parent, const PairCase& mate,
                             const BreedShares& shares) {
  const auto any_of = [&](std::span<const Move> moves) {
    return moves[static_cast<std::size_t>(random.integer(0, static_cast<int>(moves.size()) - 1))];
  };
  PairCase child = parent;
  int more = 1;
  while (more < 4 && random.chance(0.5)) ++more;
  for (; more > 0; --more) {
    const double kind = random.unit();
    const double rest = (kind - shares.of_numbers) / (1 - shares.of_numbers);
    const Move move = any_of(kind < shares.of_numbers ? moves_of_numbers()
                             : rest < 0.45            ? moves_of_shapes()
                                                      : moves_of_places());
    move.make(random, child, mate);
  }
  const KnownShapes known{is_untouched(child.a.polygon, parent.a.polygon),
                          is_untouched(child.b.polygon, parent.b.polygon)};
  // Counting a shape's faces from another one changes no contact, and fills cells by itself.
  if (random.chance(shares.renumbered)) renumber_by_chance(random, child);
  return revalidated(child, known);
}

bool is_in_use(const PairCase& pair) {
  constexpr double least = 0x1p-24;
  constexpr double most = 0x1p24;
  constexpr double farthest = 0x1p30;
  return std::ranges::all_of(std::array{&pair.a, &pair.b}, [&](const Body* body) {
    const double across = size(body->polygon);
    const double away = body->pose.position.cast<double>().norm();
    return across >= least && across <= most && away <= farthest &&
           static_cast<double>(body->polygon.radius) <= most;
  });
}

}  // namespace manifuzz
