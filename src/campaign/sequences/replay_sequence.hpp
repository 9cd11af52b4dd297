#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "campaign/replay.hpp"
#include "collider/sequence_collider.hpp"

namespace manifuzz {

/// The colliders that keep points which sequences name, each made once.
class NamedKeepers {
 public:
  /// Makes the collider of that name, or nothing; where one of that name is known and not
  /// installed, it cannot begin.
  using Find = std::function<std::optional<SequenceCollider>(const std::string& name)>;

  /// A collider as it is asked, and as it is counted.
  struct Keeper {
    SequenceCollider asked;
    Collider declared;
  };

  /// `given` is asked about all, whoever they name.
  NamedKeepers(Find find, const std::optional<SequenceCollider>& given);

  /// The collider to ask, or nullptr where there is none of that name.
  const Keeper* subject_of(const CorpusCase& known);

 private:
  Find find_;
  std::optional<Keeper> given_;
  std::map<std::string, std::optional<Keeper>> known_;
};

/// Who is asked about a sequence that names nobody.
inline constexpr const char* kUsualKeeper = "cached";

/// Every sequence again, as far as there is time, by the rules of cases; the run refers to the
/// sequences.
ReplayRun replay_sequences(const std::vector<CorpusCase>& sequences, NamedKeepers& keepers,
                           const Known& known, Interruption& interruption);

}  // namespace manifuzz
