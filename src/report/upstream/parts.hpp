#pragma once

#include <string>

#include "campaign/plan.hpp"
#include "report/upstream/program.hpp"

namespace manifuzz {

/// Four significant digits at most, for text: figures that matter exactly are in the program.
std::string short_figure(double value);

/// What an answer says of the pair as a whole.
struct Claim {
  bool touches = false;
  std::optional<Vector2<double>> normal{};  ///< in A's frame, from A to B
  double depth = 0;                         ///< of the deepest point
  int points = 0;
};
Claim claim_of(const Answer& answer);

/// The total depth of the cores and radii, as near as double says it: negative across a gap.
double true_depth(const PairCase& pair);

/// Three significant digits.
std::string plain(double value);

/// How deep they overlap along the answer's own normal; the least depth where it has none.
double depth_along(const PairCase& pair, const Claim& claim);

/// Whether they are said to be so much deeper than they are that a wrong normal is the lesser news.
bool is_far_too_deep(const PairCase& pair, const Claim& claim, const Declaration& declaration);

/// Whether points lie where the shapes overlap, but not as deep there as is said.
bool is_depth_elsewhere(const JudgedCase& judged, const Declaration& declaration);

/// How many points a right answer has at most.
int right_count(const JudgedCase& judged, const Declaration& declaration);

/// Whether it is an answer, but none that can be read.
bool is_nonsense(const DeclaredAnswer& asked);

/// "Triangles that overlap by 0.3 have no contact": what happens, with figures, in plain words.
std::string upstream_title(const JudgedCase& judged, const DeclaredAnswer& asked);

/// What a user of the engine sees of that.
std::string seen_by_users(const JudgedCase& judged, const DeclaredAnswer& asked);

/// How to check the truth with a pencil: a face and a vertex, or two nearest places.
std::string checked_by_hand(const PairCase& pair);

/// How finely a contact is written down.
struct Detail {
  int more_digits = 0;        ///< beyond the seven of a float, the nine of a double
  bool has_features = false;  ///< between which features each point is
};

/// What the engine answers, in its own terms: the sign of its normal, its kind of points.
std::string got_in_words(const PairCase& pair, const DeclaredAnswer& asked, const Program& program,
                         Detail detail);

/// What would be right, in the same terms: the one along the engine's own normal, where that is
/// right, else one of the right answers, and how many there are.
std::string expected_in_words(const PairCase& pair, const DeclaredAnswer& asked,
                              const Program& program, Detail detail);

}  // namespace manifuzz
