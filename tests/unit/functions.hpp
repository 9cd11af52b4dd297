#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace manifuzz::test {

/// A function that stands in a namespace, as a text defines or declares it.
struct NamedFunction {
  std::string scope;  ///< the named namespaces around it: "manifuzz::exact"
  std::string name;
  std::string parameters;  ///< their types: "const Pose &, int"
  bool is_hidden = false;  ///< in an anonymous namespace
  bool has_body = false;   ///< defined here, not only declared
};

/// The functions of a C++ source or header that are members of no class, in their order. What a
/// macro makes is not seen.
std::vector<NamedFunction> functions_in(std::string_view text);

}  // namespace manifuzz::test
