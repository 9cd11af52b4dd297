#pragma once

#include <string_view>
#include <utility>

namespace manifuzz::canary {

/// A bug, by its name and its line in its table.
struct Bug {
  const char* name;
  int line;
  std::string_view table;  ///< its name

  /// Whether round shapes alone show it.
  bool is_round() const { return table == "round_edits"; }
};

/// The line of the bug that acts, of those that are compiled behind switches; 0: none.
inline int acting_line = 0;

/// Called by the code that bugs are planted into.
inline bool is_acting(int line) {
  return acting_line == line;
}

/// While it lives, this bug acts and no other.
class Acting {
 public:
  explicit Acting(const Bug& bug) : before_(std::exchange(acting_line, bug.line)) {}
  ~Acting() { acting_line = before_; }
  Acting(const Acting&) = delete;
  Acting& operator=(const Acting&) = delete;

 private:
  int before_;
};

}  // namespace manifuzz::canary
