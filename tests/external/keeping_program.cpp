#include <csignal>
#include <iostream>
#include <string>
#include <unistd.h>

#include "base/json.hpp"
#include "exchange/json.hpp"
#include "exchange/kept_json.hpp"
#include "unit/sequence/keepers.hpp"

// A program that keeps points as the planted keepers do, or loses the third frame of each sequence.

using namespace manifuzz;

namespace {

std::string answer_to(const std::string& line, const SequenceCollider& keeper,
                      std::string_view behaviour) {
  static std::function<KeptAnswer(const PairCase&)> ask;
  const JsonTree tree = parse_json(line);
  const JsonView root(tree);
  const std::uint64_t frame = root.at("frame").whole_number();
  if (frame == 0) ask = keeper.begin();
  if (frame == 2 && behaviour == "crashes") std::raise(SIGSEGV);
  if (frame == 2 && behaviour == "hangs") sleep(100);
  if (frame == 2 && behaviour == "garbage") return "[object Object]";
  if (frame == 2 && behaviour == "nonsense") return "{\"points\": 3}";
  const PairCase pair{read_body(root.at("a")), read_body(root.at("b"))};
  std::string answer;
  append_kept_answer(answer, pair, "keeping", {root.at("sequence").whole_number(), frame},
                     ask(pair));
  return answer;
}

test::Mistake mistake_of(std::string_view behaviour) {
  if (behaviour == "stale") return test::Mistake::stale_normal;
  return behaviour == "both_ends" ? test::Mistake::both_ends : test::Mistake::none;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string_view behaviour = argc > 1 ? argv[1] : "";
  const SequenceCollider keeper = test::keeper_with(mistake_of(behaviour));
  if (behaviour != "undeclared") {
    std::cout << R"({"declaration": {"name": "keeping", "version": "1.0", "scalar": "float64", )"
              << (behaviour == "both_ends" ? "" : R"("claims": "point", )")
              << R"("frame": "local", "second_point": "clip", "keeping": {"gap": )"
              << R"({"relative": 0.02}, "drift": {"relative": 0.02}, "turn": 0.02, )"
              << R"("match": {"relative": 0.02}, "match_by": "either", "points_max": 3}}})"
              << std::endl;
  }
  for (std::string line; std::getline(std::cin, line);) {
    std::cout << answer_to(line, keeper, behaviour) << std::endl;
  }
  return 0;
}
