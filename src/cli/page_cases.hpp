#pragma once

#include <map>
#include <optional>
#include <string>

#include "campaign/in_child.hpp"
#include "campaign/result_files.hpp"
#include "report/page/page.hpp"

namespace manifuzz {

/// The colliders that cases name, each made once; those that are given go by what they declare.
class NamedColliders {
 public:
  NamedColliders(const std::optional<Collider>& subject, const std::optional<Collider>& oracle);

  /// nullptr where there is none of that name, or where it cannot be had.
  const Collider* find(const std::string& name);

  /// Whom a case that names nobody is put to: those given, else clip and box2d.
  const std::string& subject() const { return subject_; }
  const std::string& oracle() const { return oracle_; }

 private:
  std::string subject_ = "clip";
  std::string oracle_ = "box2d";
  std::map<std::string, std::optional<Collider>> known_;
};

/// The cases of the page, in the order of their files. Answers are those that a file records; else
/// its colliders are asked. At most `maps_max` buckets get the map of their smallest witness, those
/// with somebody wrong first. Throws Interrupted.
std::vector<PageCase> page_cases(const RunFiles& files, NamedColliders& colliders,
                                 std::size_t maps_max, Interruption& interruption);

}  // namespace manifuzz
