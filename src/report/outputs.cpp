#include "report/outputs.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "base/user_error.hpp"

namespace manifuzz {

bool leaves_out_tables(std::initializer_list<std::string_view> files) {
  const auto takes_data = [](std::string_view file) { return !file.empty() && file != "-"; };
  return is_quiet() && std::ranges::any_of(files, takes_data);
}

std::string json_text(const nlohmann::ordered_json& json) {
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

void Outputs::write(bool is_asked, const std::function<void()>& write_it) {
  if (!is_asked) return;
  try {
    write_it();
  } catch (const UserError& error) {
    add_error(error.what());
  }
}

void Outputs::add_error(const std::string& what) {
  if (what.empty() || std::ranges::find(errors_, what) != errors_.end()) return;
  write_complaint(what);
  errors_.push_back(what);
}

}  // namespace manifuzz
