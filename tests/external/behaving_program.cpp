#include <iostream>
#include <string>
#include <vector>

#include "corpus/corpus.hpp"
#include "exchange/json.hpp"
#include "external/behaviour.hpp"
#include "own_colliders/own_colliders.hpp"

// clip64 as a program that answers lines. Its argument says what else it does.

using namespace manifuzz;

namespace {

std::string answer_to(const std::string& line, std::string_view behaviour) {
  static const Collider clip64 = make_clip64();
  const PairCase pair = parse_case(line, FormatKey::required).pair;
  const float x = pair.a.polygon.vertices[0].x();
  const float y = pair.b.pose.position.y();
  test::misbehave(behaviour, x, y);
  const bool is_unlucky = test::is_unlucky(x, y);
  if (is_unlucky && behaviour == "garbage") return "[object Object]\n";
  if (is_unlucky && behaviour == "not-a-number") return "{\"points\": [], \"depth\": NaN}\n";
  if (is_unlucky && behaviour == "nonsense") return "{\"points\": 3}\n";
  std::string answer;
  append_answer(answer, pair, "behaving", clip64.collide(pair));
  answer += '\n';
  if (is_unlucky && behaviour == "twice") answer += answer;
  if (is_unlucky && behaviour == "never") answer.clear();
  return answer;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string_view behaviour = argc > 1 ? argv[1] : "";
  if (behaviour == "dies-at-start") return 3;
  if (behaviour != "undeclared") {
    std::cout << R"({"declaration": {"name": "behaving", "version": "1.0", "scalar": "float64", )"
              << R"("frame": "local"}})" << std::endl;
  }
  std::string held;
  for (std::string line; std::getline(std::cin, line);) {
    const std::string answer = answer_to(line, behaviour);
    if (behaviour != "out-of-order") {
      std::cout << answer << std::flush;
    } else if (held.empty()) {
      held = answer;  // a case late, and swapped with the next
    } else {
      std::cout << answer << std::exchange(held, "") << std::flush;
    }
  }
  return 0;
}
