#include "campaign/hints/hint_json.hpp"

namespace manifuzz {

nlohmann::ordered_json json_of(const Hint& hint) {
  return {{"mistake", hint.mistake},
          {"of_wrong", hint.of_wrong},
          {"right_when_undone", hint.right_when_undone},
          {"text", hint.text}};
}

Hint read_hint(const JsonView& row) {
  return {std::string(row.at("mistake").string()), row.at("of_wrong").whole_number(),
          row.at("right_when_undone").whole_number(), std::string(row.at("text").string())};
}

}  // namespace manifuzz
