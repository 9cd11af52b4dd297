#pragma once

#include <filesystem>
#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "base/place.hpp"
#include "base/streams.hpp"
#include "report/terminal.hpp"

namespace manifuzz {

/// Whether tables are left out: when quiet, where one of these files (empty: none, "-": stdout)
/// takes what they say.
bool leaves_out_tables(std::initializer_list<std::string_view> files);

/// JSON as it is written for people and programs: indented, with a line's end. Paths need not be
/// UTF-8; what is not is replaced.
std::string json_text(const nlohmann::ordered_json& json);

/// Outputs that are written one by one: one that fails is named, once, and no other is lost by
/// that.
class Outputs {
 public:
  /// Runs what writes an output, if it is asked for; it may throw a UserError.
  void write(bool is_asked, const std::function<void()>& write_it);
  /// What went wrong beside the writing, if anything did.
  void add_error(const std::string& what);

  bool are_written() const { return errors_.empty(); }
  const std::vector<std::string>& errors() const { return errors_; }

 private:
  std::vector<std::string> errors_;
};

}  // namespace manifuzz
