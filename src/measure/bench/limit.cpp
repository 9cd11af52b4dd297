#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "measure/bench/limit.cpp"
#include <hwy/foreach_target.h>  // includes this file once more for every other target
// after foreach_target
#include <hwy/highway.h>
#include <memory>
#include <span>

#include "clipping/collide.hpp"
#include "kernel/packed.hpp"
#include "measure/bench/bench.hpp"

HWY_BEFORE_NAMESPACE();
namespace manifuzz::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// As many products and sums in every lane of sixteen, on twelve chains, so that none waits.
void calculate(std::size_t operations, float* sixteen) {
  const hn::CappedTag<float, kernel::kBlockPairs> d;
  constexpr int kChains = 12;
  const auto factor = hn::Set(d, 1.0F - 0x1p-20F);
  for (std::size_t column = 0; column < kernel::kBlockPairs; column += hn::Lanes(d)) {
    hn::Vec<decltype(d)> chain[kChains];
    for (int c = 0; c < kChains; ++c) chain[c] = hn::Set(d, static_cast<float>(c + 1));
    for (std::size_t k = 0; k < operations; k += kChains) {
      for (int c = 0; c < kChains; c += 2) {
        chain[c] = hn::Mul(chain[c], factor);
        chain[c + 1] = hn::Add(chain[c + 1], factor);
      }
    }
    for (int c = 1; c < kChains; ++c) chain[0] = hn::Add(chain[0], chain[c]);
    hn::Store(chain[0], d, sixteen + column);
  }
}

/// Reads rows and writes rows; what is read is put together by the cheapest operation.
void move(std::span<const kernel::Row<std::int32_t>> in, std::span<kernel::Row<std::int32_t>> out) {
  const hn::CappedTag<std::int32_t, kernel::kBlockPairs> d;
  hn::Vec<decltype(d)> bits[2] = {hn::Zero(d), hn::Zero(d)};
  const std::size_t lanes = hn::Lanes(d);
  for (std::size_t row = 0; row + 1 < in.size(); row += 2) {
    for (std::size_t column = 0; column < kernel::kBlockPairs; column += lanes) {
      for (const int r : {0, 1}) {
        bits[r] = hn::Or(bits[r], hn::Load(d, in[row + r].column + column));
      }
    }
  }
  const auto all = hn::Or(bits[0], bits[1]);
  for (auto& row : out) {
    for (std::size_t column = 0; column < kernel::kBlockPairs; column += lanes) {
      hn::Store(all, d, row.column + column);
    }
  }
}

}  // namespace manifuzz::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace manifuzz {
namespace {

HWY_EXPORT(calculate);
HWY_EXPORT(move);

using Pass = std::function<void()>;

Pass arithmetic_pass(std::span<const PairCase> pairs, Opposing opposing) {
  std::size_t total = 0;
  for (const PairCase& pair : pairs) {
    const auto manifold =
        clipping::collide(pair.a.polygon, pair.b.polygon, relative_pose(pair.a.pose, pair.b.pose));
    total += static_cast<std::size_t>(
        operations(pair.a.polygon.count, pair.b.polygon.count, manifold.count > 0, opposing));
  }
  const std::size_t per_lane = total / kernel::kBlockPairs;
  return [per_lane, values = std::make_shared<kernel::Row<float>>()] {
    HWY_DYNAMIC_DISPATCH(calculate)(per_lane, values->column);
  };
}

Pass bytes_pass(std::span<const PairCase> pairs) {
  std::size_t corners = 0;
  for (const PairCase& pair : pairs) {
    corners += static_cast<std::size_t>(pair.a.polygon.count + pair.b.polygon.count);
  }
  const std::size_t scalars = pairs.size() * (kernel::kCorners + 4) + corners * kernel::kCornerRows;
  constexpr std::size_t kManifoldRows =
      sizeof(kernel::ManifoldBlock<float>) / sizeof(kernel::Row<float>);
  const std::size_t blocks = (pairs.size() + kernel::kBlockPairs - 1) / kernel::kBlockPairs;
  using Rows = std::vector<kernel::Row<std::int32_t>>;
  const auto in = std::make_shared<Rows>(scalars / kernel::kBlockPairs);
  const auto out = std::make_shared<Rows>(blocks * kManifoldRows);
  return [in, out] { HWY_DYNAMIC_DISPATCH(move)(*in, *out); };
}

}  // namespace

int operations(int count_a, int count_b, bool touches, Opposing opposing) {
  const int place = 8 + 6 + (8 + 6) * count_b;  // the relative pose; B's vertices and normals
  const int faces = count_a + count_b;
  const int separate = opposing == Opposing::support ? 5 * faces : 10 * count_a * count_b + faces;
  const int incident = 4 * faces / 2;
  const int clip = 2 * (12 + 4 + 6) + 2;  // a plane: two offsets, comparisons, a crossing
  const int keep = 2 * 7;
  return place + separate + (touches ? incident + clip + keep : 0);
}

std::vector<BenchSubject> limits(const std::string& target) {
  const auto limit = [&](const char* query, const char* input,
                         std::function<Pass(std::span<const PairCase>)> pass) {
    return BenchSubject{.name = "limit",
                        .query = query,
                        .input = input,
                        .target = target,
                        .prepare = std::move(pass)};
  };
  const auto arithmetic = [](Opposing opposing) {
    return [opposing](std::span<const PairCase> pairs) { return arithmetic_pass(pairs, opposing); };
  };
  return {limit("arithmetic", "lanes", arithmetic(Opposing::every_corner)),
          limit("supports", "lanes", arithmetic(Opposing::support)),
          limit("bytes", "packed", bytes_pass)};
}

}  // namespace manifuzz
#endif
