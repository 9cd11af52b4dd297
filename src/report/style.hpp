#pragma once

#include <string>
#include <string_view>

namespace manifuzz {

/// Whether that stream (STDOUT_FILENO, STDERR_FILENO) is a terminal that can colour and erase; one
/// without a name or named `dumb` cannot.
bool is_able_terminal(int stream);

/// From now on words are coloured on each stream that is an able terminal, unless the environment
/// names NO_COLOR. Before, nowhere: text that is built for a file or a test is plain.
void allow_colours();

/// A word for stdout, its spaces included: what is well, what decides a status, what is new.
std::string good(std::string_view word);
std::string bad(std::string_view word);
std::string fresh(std::string_view word);

/// The same for what is wrong, on stderr.
std::string bad_on_stderr(std::string_view word);

}  // namespace manifuzz
