#include "external/error_output.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/file.hpp"
#include "base/text.hpp"

namespace manifuzz {

void ErrorOutput::pass_on(std::string_view text) {
  std::size_t left = run_->left;
  std::size_t kept = 0;
  do {
    kept = std::min({text.size(), left_of_case_, left});
  } while (!run_->left.compare_exchange_weak(left, left - kept));
  left_of_case_ -= kept;
  write_error(text.substr(0, kept));
  if (kept == text.size() || run_->has_said.exchange(true)) return;
  const std::string_view line_end = kept > 0 && text[kept - 1] != '\n' ? "\n" : "";
  write_error(fmt::format(
      "{}'{}' writes more to its standard error than {} KiB a case and {} MiB a run; the rest is "
      "dropped\n",
      line_end, printable(name_), kErrorBytesACase >> 10, kErrorBytesARun >> 20));
}

}  // namespace manifuzz
