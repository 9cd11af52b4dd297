#pragma once

#include <cstdint>
#include <span>

namespace manifuzz {

/// A part of a row's cases, of which some were judged, each as likely as any other, and how many
/// kinds were met once and twice among those.
struct Stratum {
  std::uint64_t cases = 0;
  std::uint64_t judged = 0;
  std::uint64_t once = 0;   ///< kinds met in one case of the whole row, which is of this part
  std::uint64_t twice = 0;  ///< kinds met in two cases of the whole row, both of this part
};

/// A chance, and an interval that misses it at most as often as was asked for.
struct Chance {
  double next = 0;
  double low = 0;
  double high = 1;
};

/// The chance that a row's next case shows a kind that none of its judged cases has shown.
///
/// In one part with n judged cases, let kind i come with the chance p_i, X_i times: nearly Poisson
/// with the mean m_i = n p_i. The chance in question is U, the sum of p_i over all i with X_i = 0.
/// Kinds with X_i = 1 number N1, and N1 / n has U's mean, for each P(X = 1) is m P(X = 0) (Good and
/// Turing: I. J. Good, Biometrika 40, 1953). N1 - n U has the mean 0 and is a sum over kinds of
/// [X = 1] - m [X = 0], whose variance is P(X = 1) + m^2 P(X = 0) = P(X = 1) + 2 P(X = 2): kinds
/// with X_i = 2 number N2, and the sum of all is about N1 + 2 N2 (W. W. Esty, Annals of Statistics
/// 11, 1983). Few kinds are too few for the normal law: 2 is added to that variance, and the ends
/// stand at least as far out as those of the mean of a Poisson count N1 (F. Garwood, Biometrika 28,
/// 1936), which are 0 and 3.7 / n where N1 = 0 and one interval in twenty may miss.
///
/// In a row of several parts kind i is unseen where no part has shown it. The derivation holds for
/// each part as it stands, with the chance of no meeting in the others as a factor on both sides.
/// What each part gives is weighted by the part's share of the cases and summed. An interval of a
/// sum misses only where one of its parts' does, so each has an equal share of `error`, the
/// chance that the result misses. A part without judged cases has the interval from 0 to 1, and a
/// row without cases, of which nothing is known, too.
Chance chance_of_unseen(std::span<const Stratum> strata, double error);

}  // namespace manifuzz
