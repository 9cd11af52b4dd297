#include "hunting/case_bytes.hpp"

#include <algorithm>
#include <bit>

#include "generating/drafts.hpp"

namespace manifuzz {
namespace {

constexpr std::size_t kVerticesAt = 4;
constexpr std::size_t kRadiusAt = kVerticesAt + std::size_t{kMaxVertices} * 8;
constexpr std::size_t kPositionAt = kRadiusAt + 4;
constexpr std::size_t kRotationAt = kPositionAt + 8;
static_assert(kRotationAt + 8 == kBodyBytes);

using Bytes = std::span<const std::uint8_t>;

void put(float number, std::uint8_t* to) {
  const auto bits = std::bit_cast<std::uint32_t>(number);
  for (int i = 0; i < 4; ++i) to[i] = static_cast<std::uint8_t>(bits >> 8 * i);
}

void put(const Vector2<float>& v, std::uint8_t* to) {
  put(v.x(), to);
  put(v.y(), to + 4);
}

float number_at(Bytes bytes, std::size_t at) {
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < 4; ++i) bits |= std::uint32_t{bytes[at + i]} << 8 * i;
  return std::bit_cast<float>(bits);
}

Vector2<float> vector_at(Bytes bytes, std::size_t at) {
  return {number_at(bytes, at), number_at(bytes, at + 4)};
}

void encode(const Body& body, std::uint8_t* to) {
  std::fill_n(to, kBodyBytes, std::uint8_t{0});
  to[0] = static_cast<std::uint8_t>(body.polygon.count);
  to[1] = body.polygon.is_round() ? 1 : 0;
  for (int i = 0; i < body.polygon.count; ++i) {
    put(body.polygon.vertices[i], to + kVerticesAt + static_cast<std::size_t>(8 * i));
  }
  put(body.polygon.radius, to + kRadiusAt);
  put(body.pose.position, to + kPositionAt);
  put(body.pose.rotation, to + kRotationAt);
}

std::optional<Body> decode(Bytes bytes) {
  if (bytes[0] < 1 || bytes[0] > kMaxVertices || bytes[1] > 1) return std::nullopt;
  Body body;
  body.polygon.count = bytes[0];
  body.polygon.rounding = bytes[1] == 1 ? Rounding::round : Rounding::mitre;
  for (int i = 0; i < body.polygon.count; ++i) {
    body.polygon.vertices[i] = vector_at(bytes, kVerticesAt + static_cast<std::size_t>(8 * i));
  }
  body.polygon.radius = number_at(bytes, kRadiusAt);
  body.pose = {vector_at(bytes, kPositionAt), vector_at(bytes, kRotationAt)};
  return body;
}

}  // namespace

void encode_case(const PairCase& pair, std::span<std::uint8_t, kCaseBytes> to) {
  encode(pair.a, to.data());
  encode(pair.b, to.data() + kBodyBytes);
}

std::optional<PairCase> decode_case(std::span<const std::uint8_t> bytes) {
  if (bytes.size() != kCaseBytes) return std::nullopt;
  const auto a = decode(bytes.first(kBodyBytes));
  const auto b = decode(bytes.subspan(kBodyBytes));
  if (!a || !b) return std::nullopt;
  return revalidated({*a, *b});
}

}  // namespace manifuzz
