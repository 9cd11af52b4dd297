#include "hunting/wrong_answers.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/file.hpp"
#include "corpus/corpus.hpp"

namespace manifuzz {
namespace {

/// Beside itself in the place of an oracle the collider shares the fault.
Bucket against_subject(Bucket bucket) {
  bucket.fault = Fault::subject;
  if (bucket.verdict == Verdict::both_wrong) bucket.verdict = Verdict::subject_wrong;
  return bucket;
}

}  // namespace

std::optional<WrongAnswer> wrong_answer(const Collider& collider, const PairCase& pair) {
  const Answer answer = collider.collide(pair);
  if (std::holds_alternative<Unsupported>(answer)) return std::nullopt;
  const auto truth = std::make_shared<const exact::Truth>(pair);
  const ColliderAnswer given{collider.declaration, answer};
  WrongAnswer wrong{pair, judge_alone(truth, given)};
  if (wrong.judgement.bucket.fault == Fault::none) return std::nullopt;
  wrong.judgement.bucket = against_subject(wrong.judgement.bucket);
  return wrong;
}

std::optional<std::filesystem::path> WrongAnswers::keep(const WrongAnswer& wrong) {
  const Bucket& bucket = wrong.judgement.bucket;
  if (!known_.insert(index_of(bucket)).second) return std::nullopt;
  std::string name = to_string(bucket);
  CorpusCase found;
  found.any = wrong.pair;
  found.found = Found{.regime = std::string(kRegimeOfHunts),
                      .versions = {{declaration_.name, declaration_.version}}};
  found.expect = Expectation{.subject = declaration_.name,
                             .oracle = {},
                             .verdict = std::string(to_string(bucket.verdict)),
                             .bucket = name,
                             .manifolds = {}};
  found.note = fmt::format("{}, alone: {}.", declaration_.name, name_of(bucket.kind, kKindNames));
  std::ranges::replace(name, '/', '-');
  const std::filesystem::path file = folder_ / (name + ".json");
  std::error_code unknown;
  if (std::filesystem::exists(file, unknown)) return std::nullopt;
  write_file(file, format_case(found));
  return file;
}

}  // namespace manifuzz
