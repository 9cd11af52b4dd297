#pragma once

#include <array>
#include <optional>
#include <vector>

#include "collider/collider.hpp"
#include "exact/truth.hpp"
#include "judging/bucket.hpp"
#include "judging/compare.hpp"
#include "judging/errors/answer_error.hpp"
#include "judging/ledger.hpp"
#include "judging/manifold_error.hpp"

namespace manifuzz {

/// The verdict on a subject's and an oracle's answer to one case.
struct Judgement {
  Bucket bucket{};
  double magnitude = 0;                      ///< how wrong, or how unlike, as a share of the size
  double bound = 0;                          ///< of that error, as a share of the size too
  int points_missing = 0;                    ///< of the wrong answer; below zero: it has too many
  const LedgerEntry* explanation = nullptr;  ///< set where the verdict is known
  bool is_judged = false;                    ///< not only compared
  bool is_agreed_contact = false;  ///< both plainly agree on a contact: a sample of these is judged
  AnswerError of_subject{};        ///< how wrong it is; none where it is right
  AnswerError of_oracle{};
  bool is_by_tolerance = false;  ///< an answer is right, but only by the tolerance it declares
  std::optional<std::size_t> frame{};  ///< of several: the one that decides
};

/// The error of whoever is at fault, the subject's before the oracle's.
const AnswerError& error_of(const Judgement& judgement);

/// How wrong it is in what the finding's kind names, a share of the size; other errors of the
/// answer may be greater.
double error_of_kind(const Judgement& judgement);

/// The finding's magnitude and errors.
WorstError worst_error(const Judgement& judgement);

/// Whether it is the same finding: its bucket, its ledger entry, points missing or too many, and
/// its magnitude's order, unless both are right within their bounds.
bool is_alike(const Judgement& judgement, const Judgement& root);

/// Where a case stands by the truth alone.
struct Standing {
  bool touching = false;  ///< S <= total radius, exactly
  bool near = false;      ///< not touching, and S within 10% of the size from the total radius
};

inline constexpr double kNearShare = 0.1;

Standing standing(const exact::Truth& truth);

/// The full verdict.
Judgement judge(const std::shared_ptr<const exact::Truth>& truth, const ColliderAnswer& subject,
                const ColliderAnswer& oracle);
Judgement judge(const PairCase& pair, const ColliderAnswer& subject, const ColliderAnswer& oracle);

/// The full verdict on one collider's answer, which stands in the oracle's place as well: where it
/// is wrong, both are.
Judgement judge_alone(const std::shared_ptr<const exact::Truth>& truth,
                      const ColliderAnswer& given);

/// Names the ledger's cause of a verdict against the subject, which is `known` then, as one against
/// the oracle is.
void explain_subject(const std::shared_ptr<const exact::Truth>& truth,
                     const ColliderAnswer& subject, Judgement& judgement);

/// The full verdict on what these two answer now.
Judgement judge(const PairCase& pair, const Collider& subject, const Collider& oracle);

struct VertexOf {
  Side side = Side::a;
  int index = 0;

  friend bool operator==(const VertexOf&, const VertexOf&) = default;
};

/// The vertex that decides the separation: the incident edge's end that lies deepest behind the
/// face of the greatest separation.
VertexOf deciding_vertex(const exact::Truth& truth);

/// A square grid of neighbours: one vertex moved by up to `reach` steps in x and in y, in its
/// polygon's own frame. Rows run along x; the case itself is the cell in the middle.
struct Grid {
  VertexOf vertex;
  double ulp = 0;  ///< a length: between the floats at the polygon's reach, or a round one's radius
  int step = 1;    ///< in ulps
  int reach = 64;  ///< in steps, each way

  int side() const { return 2 * reach + 1; }
  int cell_count() const { return side() * side(); }
  int x_of(int cell) const { return cell % side() - reach; }  ///< in steps
  int y_of(int cell) const { return cell / side() - reach; }
};

/// The grid around the deciding vertex. A vertex near its origin could be moved by far less than
/// an ulp of its polygon's reach; nothing that rounds would notice.
Grid grid_around(const exact::Truth& truth, int step = 1);

/// The pair with its vertex moved to that cell, or none where its polygon is no polygon any more.
std::optional<PairCase> neighbour(const PairCase& pair, const Grid& grid, int cell);

/// A contact without its figures, so that neighbours can have the same one.
struct ContactSummary {
  enum class Kind : unsigned char { nothing, apart, no_clip, contact };
  Kind kind = Kind::nothing;
  int count = 0;
  Side reference = Side::a;
  std::array<FeaturePair, 2> features{};  ///< of the points

  friend bool operator==(const ContactSummary&, const ContactSummary&) = default;
};

/// `nothing` where the collider has no manifold to give, or no such number of points.
ContactSummary summary_of(const Answer& answer);

/// The clip of the first best incident edge by the first face of the greatest separation, decided
/// exactly: one right manifold of perhaps several. `no_clip` where they touch and it keeps no
/// point; of round shapes only whether they touch.
ContactSummary summary_of(const exact::Truth& truth);

struct Cell {
  enum class State : unsigned char { not_asked, invalid, judged };
  State state = State::not_asked;
  Bucket bucket;
  ContactSummary subject;
  ContactSummary oracle;
  ContactSummary truth;
};

/// A case's neighbours as two colliders see them; `cells` in the order of the grid.
struct Neighbourhood {
  Grid grid;
  std::vector<Cell> cells;
};

/// How much of a neighbourhood fails as the case in its middle does.
struct Severity {
  int failing = 0;
  int valid = 0;  ///< cells that were judged

  double share() const { return valid > 0 ? static_cast<double>(failing) / valid : 0; }
};

/// Whether this is the finding's failure again: the same collider is wrong, or both are where both
/// were; where nobody is at fault, the same verdict, and beside an agreement any fault.
bool fails_alike(const Bucket& bucket, const Bucket& finding);

Severity severity(const Neighbourhood& neighbourhood, const Bucket& finding);

}  // namespace manifuzz
