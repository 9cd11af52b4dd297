#include "report/next_steps.hpp"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "base/text.hpp"
#include "corpus/corpus.hpp"

namespace manifuzz {
namespace {

/// How much a case has to tell: most where the subject is at fault, least where nobody is, or where
/// its colliders may be missing.
int weight_of(const CorpusCase& known, const IsAtHand& is_at_hand) {
  if (!known.expect || !is_at_hand(known.expect->subject) || !is_at_hand(known.expect->oracle)) {
    return 0;
  }
  const std::string& bucket = known.expect->bucket;
  if (bucket.starts_with("subject/") || bucket.starts_with("both/")) return 3;
  return bucket.starts_with("oracle/") ? 2 : 1;
}

std::string steps_with(const Corpus& corpus, const std::string& program, const std::string& folder,
                       const IsAtHand& is_at_hand) {
  const auto most = std::ranges::max_element(
      corpus.cases, {}, [&](const CorpusCase& known) { return weight_of(known, is_at_hand); });
  std::string text = fmt::format("{} holds {} cases. Look at one, and hold all against a change:\n",
                                 printable(folder, 200), corpus.cases.size());
  text += fmt::format("  {} show {}\n", program, quoted_for_shell(most->path));
  return text + fmt::format("  {} replay {}\n", program, quoted_for_shell(folder));
}

}  // namespace

std::string next_steps(const std::string& program, const std::string& corpus,
                       const IsAtHand& is_at_hand) {
  const std::filesystem::path folder(corpus);
  const Corpus known = read_corpus({&folder, 1});
  const std::string by = quoted_for_shell(program);
  std::string text =
      "manifuzz says which contact manifolds of a 2D collider are wrong, and why.\n\n";
  if (!known.cases.empty()) text += steps_with(known, by, corpus, is_at_hand) + '\n';
  text += "Find what is wrong, in ten seconds; each finding comes with its file and command:\n";
  text += fmt::format("  {} fuzz --seconds 10\n\n", by);
  text += "Judge your own: put the command that runs it in place of the words in quotes.\n";
  text += fmt::format("  {0} fuzz --subject-command {1} --oracle clip64 --cases 20000\n\n", by,
                      quoted_for_shell(by + " collide --collider box2d"));
  return text + fmt::format("Everything else:\n  {} --help\n", by);
}

}  // namespace manifuzz
