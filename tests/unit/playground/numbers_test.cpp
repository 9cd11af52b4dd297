#include "playground/numbers.hpp"

#include <array>

#include <catch2/catch.hpp>

using namespace manifuzz;

namespace {

using Numbers = std::array<double, playground::kCaseNumbers>;

void put_box(Numbers& numbers, int first, double x, double y) {
  const std::array<double, 15> box = {4, 0, 0, x, y, 1, 0, -1, -1, 1, -1, 1, 1, -1, 1};
  std::copy(box.begin(), box.end(), numbers.begin() + first);
}

/// Two boxes, B a little to the right and above A.
Numbers boxes() {
  Numbers numbers{};
  put_box(numbers, 0, 0, 0);
  put_box(numbers, playground::kBodyNumbers, 0.5, 1.75);
  return numbers;
}

}  // namespace

TEST_CASE("numbers become the case that they are of") {
  const PairCase pair = playground::pair_of(boxes());
  CHECK(pair.a.polygon.count == 4);
  CHECK(pair.b.pose.position == Vector2<float>(0.5F, 1.75F));
  CHECK(pair.b.polygon.vertices[2] == Vector2<float>(1, 1));
  CHECK_FALSE(playground::defect_of(boxes()));
}

TEST_CASE("what is wrong with a case is said of its body") {
  Numbers numbers = boxes();
  numbers[playground::kBodyNumbers + 7] = 5;
  const auto defect = playground::defect_of(numbers);
  REQUIRE(defect);
  CHECK(defect->starts_with("B: "));
  numbers = boxes();
  numbers[5] = 1.5;
  CHECK(playground::defect_of(numbers).value_or("").starts_with("A: its rotation"));
  numbers = boxes();
  numbers[0] = 9;
  CHECK(playground::defect_of(numbers));
}

TEST_CASE("what is told of two boxes has the overlap, both answers right, and the curve") {
  const playground::Told told = playground::tell(playground::pair_of(boxes()));
  CHECK(told.numbers[0] == 1);  // by faces
  CHECK(told.numbers[2] == -0.25);
  CHECK(told.numbers[3] == 1);
  CHECK(told.buckets.find("wrong") == std::string::npos);
  // The last angle and its depth, of which there are 180 and one of each face.
  CHECK(told.numbers[told.numbers.size() - 2] > 6);
  CHECK(told.numbers[told.numbers.size() - 1] > 0.25);
}
