#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "exchange/json.hpp"

namespace manifuzz {

/// A case as its line has it.
inline nlohmann::ordered_json case_json(const PairCase& pair) {
  std::string line;
  append_case_line(line, pair);
  return nlohmann::ordered_json::parse(line);
}

}  // namespace manifuzz
