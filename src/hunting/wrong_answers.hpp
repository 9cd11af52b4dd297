#pragma once

#include <filesystem>
#include <optional>
#include <set>

#include "collider/collider.hpp"
#include "judging/judge.hpp"

namespace manifuzz {

/// A wrong answer: its case, and what is wrong with it, the collider alone being at fault.
struct WrongAnswer {
  PairCase pair;
  Judgement judgement;
};

/// What is wrong with a collider's answer, judged alone as a campaign judges; none where it is
/// right, or where the collider declines the case.
std::optional<WrongAnswer> wrong_answer(const Collider& collider, const PairCase& pair);

/// Wrong answers of one collider, of which each bucket's first becomes a corpus case in a folder.
class WrongAnswers {
 public:
  WrongAnswers(Declaration declaration, std::filesystem::path folder)
      : declaration_(std::move(declaration)), folder_(std::move(folder)) {}

  /// Writes the case where its bucket is new and the folder has no file of its name. Gives that
  /// file where it was written. Throws UserError where it cannot be.
  std::optional<std::filesystem::path> keep(const WrongAnswer& wrong);

 private:
  Declaration declaration_;
  std::filesystem::path folder_;
  std::set<std::size_t> known_;  ///< buckets
};

}  // namespace manifuzz
