#include "campaign/shrink_saved.hpp"

#include <filesystem>

#include <fmt/format.h>

#include "base/file.hpp"
#include "base/text.hpp"
#include "campaign/in_child.hpp"
#include "campaign/known.hpp"
#include "campaign/save.hpp"

namespace manifuzz {

CorpusCase shrunk_case(const CorpusCase& given, const Trial& trial, Interruption& interruption) {
  const Judgement root = trial.judge(given.any, interruption);
  const bool was_begun = given.found && given.found->is_unshrunk;
  const std::string why_not = trial.why_unshrinkable(root, was_begun);
  if (!why_not.empty()) throw UserError(fmt::format("{}: {}", given.path, why_not));
  const Smallest smallest = trial.shrink(given.any, interruption, {});
  CorpusCase result = trial.unasked(smallest.any, root);
  unless_interrupted([&] {
    const Judgement judgement = trial.judge(smallest.any, interruption);
    result = trial.recorded(smallest.any, judgement, interruption);
  });
  result.found = given.found;
  if (result.found) result.found->is_unshrunk = !smallest.complete;
  // What is another mistake by now is not what was accepted.
  const bool is_again = given.expect && is_bucket(result.expect->bucket, given.expect->bucket);
  if (is_again) result.accepted = given.accepted;
  return result;
}

namespace {

double magnitude_of(const CorpusCase& known) {
  return known.expect ? known.expect->magnitude.value_or(0) : 0;
}

/// Puts the worst seen beside the file, unless a worse one lies there already.
void keep_worst(const std::filesystem::path& file, CorpusCase worst) {
  std::error_code unknown;
  const std::filesystem::path beside = worst_beside(file);
  const bool has_worse =
      std::filesystem::exists(beside, unknown) &&
      magnitude_of(read_case_file(beside.string(), CaseKind::either)) >= magnitude_of(worst);
  if (has_worse) return;
  if (worst.found) worst.found->is_unshrunk = false;
  worst.accepted.reset();  // that stands in the file of the smallest
  write_worst_case(file, worst);
}

/// Writes it in the place of the case that it was shrunk from, which is the worst seen then.
std::string replace(const CorpusCase& given, const CorpusCase& smallest) {
  const std::filesystem::path old = given.path;
  const std::filesystem::path file = write_corpus_case(old.parent_path(), smallest);
  if (file == old) {
    write_file(file, format_case(smallest));
    return file.string();
  }
  std::error_code unknown;
  const bool has_worst = std::filesystem::exists(worst_beside(old), unknown);
  keep_worst(file,
             has_worst ? read_case_file(worst_beside(old).string(), CaseKind::either) : given);
  // Another case may have been shrunk to the same one before.
  const bool is_to_be_accepted =
      smallest.accepted && !read_case_file(file.string(), CaseKind::either).accepted;
  if (is_to_be_accepted) write_acceptance(file.string(), smallest.accepted);
  std::filesystem::remove(old, unknown);
  std::filesystem::remove(worst_beside(old), unknown);
  return file.string();
}

/// Whether it is a finding's own file for which there was no time.
bool is_left_unshrunk(const CorpusCase& known) {
  return known.found && known.found->is_unshrunk && known.property.empty() &&
         known.path.ends_with(".json") && !is_worst(known.path);
}

}  // namespace

ShrunkInPlace shrink_in_place(std::span<const CorpusCase> cases, const TrialOf& trial_of,
                              Interruption& interruption,
                              const std::function<void(const std::string& file)>& on_shrunk) {
  ShrunkInPlace shrunk;
  for (const CorpusCase& known : cases) {
    if (!is_left_unshrunk(known)) continue;
    if (interruption.state() != Interruption::State::running) break;
    try {
      const auto trial = trial_of(known);
      if (trial == nullptr || !trial->is_there()) {
        throw UserError(fmt::format("{}: its subject '{}' is not at hand; name it with --subject",
                                    printable(known.path, 200), printable(known.expect->subject)));
      }
      shrunk.files.push_back(replace(known, shrunk_case(known, *trial, interruption)));
      on_shrunk(shrunk.files.back());
    } catch (const UserError& error) {
      shrunk.errors.emplace_back(error.what());  // the others can be shrunk all the same
    }
  }
  return shrunk;
}

}  // namespace manifuzz
