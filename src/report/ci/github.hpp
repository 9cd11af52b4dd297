#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "report/ci/test_suite.hpp"

namespace manifuzz {

// What GitHub shows of a run: pure text, of plain data.

/// GitHub shows so many annotations of a step, and takes a step summary of so many bytes.
inline constexpr std::size_t kAnnotationsMax = 10;
inline constexpr std::size_t kSummaryBytesMax = 1 << 20;
/// So many failures are described in a summary, with their pictures; the rest is counted.
inline constexpr std::size_t kDescribedMax = 10;

/// "file:12" as file and line; the line is empty where there is none.
std::pair<std::string_view, std::string_view> file_and_line(std::string_view file);

/// What a failure's file is called in the repository, or "" where it lies outside.
using FileInRepository = std::function<std::string(const std::string& file)>;

/// A workflow command, `::error title=...,file=...,line=...::message` and a line's end. A file that
/// ends in :line is annotated at that line; an empty one is left out.
std::string error_annotation(std::string_view title, std::string_view file,
                             std::string_view message);

/// An annotation for each error and each failure, as many as are shown; the last one counts those
/// left out.
std::string annotations(std::span<const TestSuite> suites, const FileInRepository& in_repository);

/// The suites as Markdown of at most `room` bytes: errors and tables, then failures with file,
/// expected, got, picture and command, as many as are described and fit; the rest is counted.
/// `image_of` gives the address of a picture of a failure's file, or "".
std::string step_summary(std::span<const TestSuite> suites, std::size_t room,
                         const std::function<std::string(const std::string& file)>& image_of);

// The step of a GitHub workflow that this process runs in, as its environment describes it.

/// Whether there is one: GITHUB_ACTIONS=true.
bool is_in_workflow();

/// The file of the step's summary, or empty.
std::string step_summary_file();

/// What is wrong with these, with files as the repository has them.
std::string workflow_annotations(std::span<const TestSuite> suites);

/// Appends the suites to the step's summary, what other programs of this step wrote stays. Throws
/// UserError.
void append_step_summary(const std::string& file, std::span<const TestSuite> suites);

}  // namespace manifuzz
