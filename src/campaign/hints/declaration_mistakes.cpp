#include "campaign/hints/declaration_mistakes.hpp"

namespace manifuzz {
namespace {

bool is_in_double(const AskedCase& asked) {
  return asked.declaration.scalar == ScalarType::float64;
}

}  // namespace

MaybeUndone with_float_normals(const AskedCase& asked) {
  if (!is_in_double(asked) || asked.declaration.normals != NormalsFrom::given) return std::nullopt;
  Undone undone{asked.declaration, asked.answer};
  undone.declaration.normals = NormalsFrom::given_as_floats;
  return undone;
}

MaybeUndone in_world(const AskedCase& asked) {
  if (asked.declaration.frame == RoundingFrame::world) return std::nullopt;
  Undone undone{asked.declaration, asked.answer};
  undone.declaration.frame = RoundingFrame::world;
  return undone;
}

MaybeUndone with_world_vertices(const AskedCase& asked) {
  if (asked.declaration.normals == NormalsFrom::world_vertices) return std::nullopt;
  Undone undone{asked.declaration, asked.answer};
  undone.declaration.normals = NormalsFrom::world_vertices;
  undone.declaration.frame = RoundingFrame::world;  // where they were rounded
  return undone;
}

MaybeUndone with_angles(const AskedCase& asked) {
  if (asked.declaration.takes_angles) return std::nullopt;
  Undone undone{asked.declaration, asked.answer};
  undone.declaration.takes_angles = true;
  return undone;
}

MaybeUndone in_float(const AskedCase& asked) {
  if (!is_in_double(asked)) return std::nullopt;
  Undone undone{asked.declaration, asked.answer};
  undone.declaration.scalar = ScalarType::float32;
  return undone;
}

MaybeUndone in_float_in_world(const AskedCase& asked) {
  MaybeUndone undone = in_float(asked);
  if (undone) undone->declaration.frame = RoundingFrame::world;
  return undone;
}

}  // namespace manifuzz
