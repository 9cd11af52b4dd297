#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>

#include "collider/collider.hpp"
#include "corpus/corpus.hpp"
#include "engines/colliders.hpp"

namespace manifuzz {

/// The colliders that cases name, each made once; those that are given go by what they declare.
class NamedColliders {
 public:
  /// Makes the collider of that name, or nothing.
  using Find = std::function<std::optional<Collider>(const std::string& name)>;

  NamedColliders(const Find& find, const std::optional<Collider>& subject,
                 const std::optional<Collider>& oracle);

  /// nullptr where there is none of that name.
  const Collider* find(const std::string& name);

  /// The collider to ask about a case: the one given, whichever the case names; else the one that
  /// it names. nullptr where there is no subject of that name; an oracle that is not installed
  /// falls back to the usual one.
  const Collider* subject_of(const CorpusCase& known);
  const Collider* oracle_of(const CorpusCase& known);

  /// The collider for cases that name none: the one given, else clip and the usual oracle.
  const std::string& subject() const { return subject_; }
  const std::string& oracle() const { return oracle_; }

 private:
  Find find_;
  bool has_subject_;
  bool has_oracle_;
  std::string subject_ = "clip";
  std::string oracle_{usual_oracle_name()};
  std::map<std::string, std::optional<Collider>> known_;
};

}  // namespace manifuzz
