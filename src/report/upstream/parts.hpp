#pragma once

#include <algorithm>
#include <optional>
#include <string>

#include "campaign/plan.hpp"
#include "judging/curve_answer.hpp"
#include "report/upstream/program.hpp"

namespace manifuzz {

/// Four significant digits at most, for text: figures that matter exactly are in the program.
std::string short_figure(double value);

/// How many points an answer has that was read so.
inline int points_in(const Said& said) {
  return said.manifold == nullptr ? 0 : std::min(said.manifold->count, 2);
}

/// The total depth of the cores and radii, as near as double says it: negative across a gap.
double true_depth(const PairCase& pair);

/// Three significant digits.
std::string plain(double value);

/// The right contact that an answer is held against, in A's frame.
struct RightContact {
  std::optional<Manifold<double>> manifold{};  ///< none where they are apart
  int count = 0;                               ///< how many are right
  bool is_along_own = false;  ///< along the answer's own normal, which has the least depth
};

/// The one along the answer's own normal, where that is right, else the one whose normal is
/// nearest to it.
RightContact right_contact(const PairCase& pair, const DeclaredAnswer& asked);

/// How deep they overlap along the answer's own normal; the least depth where it has none.
double depth_along(const PairCase& pair, const Said& claim);

/// Whether they are said to be so much deeper than they are that a wrong normal is the lesser news.
bool is_far_too_deep(const PairCase& pair, const Said& claim, const Declaration& declaration);

/// How far the contact point that lies farthest out of either shape lies out of it; 0 where each is
/// in both.
double outside_by(const PairCase& pair, const DeclaredAnswer& asked);

/// By how much contact points differ from the nearest ones of a right contact: the largest of them,
/// of the right contact that is nearest.
struct PointErrors {
  double place = 0;  ///< a distance
  double depth = 0;
};
PointErrors point_errors(const PairCase& pair, const DeclaredAnswer& asked);

/// What a report tells of first: the finding's kind, but that a point is left out where those that
/// were given are in the places of the right manifold that it shows.
Kind told_kind(const JudgedCase& judged, const DeclaredAnswer& asked);

/// How far the two points of a contact are from each other; 0 of one.
double span_of(const Manifold<double>& manifold);

/// By how much the normal of an answer is turned from the nearest right one, in radians.
double turn_of(const PairCase& pair, const Vector2<double>& normal, const Declaration& declaration);

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
