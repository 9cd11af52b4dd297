#include "hunting/libfuzzer_options.hpp"

#include <fmt/format.h>

#include "base/text.hpp"

namespace manifuzz {
namespace {

/// Where `name` or `name=VALUE` stands at i: the value, i being its last word then.
std::optional<std::string> value_at(const std::vector<std::string>& arguments, std::size_t& i,
                                    const std::string& name) {
  const std::string& word = arguments[i];
  std::string value;
  if (word.starts_with(name + "=")) {
    value = word.substr(name.size() + 1);
  } else if (word != name) {
    return std::nullopt;
  } else if (i + 1 < arguments.size() && !arguments[i + 1].starts_with("-")) {
    value = arguments[++i];
  }
  if (value.empty()) throw UserError(fmt::format("{}: a file or folder is expected", name));
  return value;
}

}  // namespace

LibFuzzerOptions libfuzzer_options(const std::vector<std::string>& arguments) {
  LibFuzzerOptions options;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& word = arguments[i];
    if (i == 0 || !word.starts_with("--")) {
      options.rest.push_back(word);
      if (i > 0 && !word.starts_with("-")) options.inputs.emplace_back(word);
    } else if (const auto from = value_at(arguments, i, "--from")) {
      options.from.emplace_back(*from);
    } else if (const auto to_json = value_at(arguments, i, "--to-json")) {
      options.to_json = *to_json;
    } else if (const auto findings = value_at(arguments, i, "--findings")) {
      options.findings = *findings;
    } else if (word == "--stop") {
      options.stops = true;
    } else {
      throw UserError(fmt::format(
          "there is no option {}; --from, --to-json, --findings, --stop and libFuzzer's are",
          printable(word)));
    }
  }
  if (!options.from.empty() && options.inputs.empty()) {
    throw UserError("--from: libFuzzer's corpus is expected, too, the folder that takes the cases");
  }
  if (options.to_json && options.inputs.empty()) {
    throw UserError("--to-json: files or folders of libFuzzer's corpus are expected, too");
  }
  return options;
}

}  // namespace manifuzz
