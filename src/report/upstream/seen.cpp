#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "judging/bounds.hpp"
#include "oracle/exact/curve.hpp"
#include "report/round_truth.hpp"
#include "report/upstream/parts.hpp"
#include "report/words.hpp"

namespace manifuzz {

std::string plain(double value) {
  return fmt::format("{:.3g}", value + 0.0);
}

double depth_along(const PairCase& pair, const Claim& claim) {
  if (!claim.normal || claim.normal->isZero(0)) return true_depth(pair);
  const exact::Truth truth(pair);
  return exact::Along(truth, *claim.normal).depth();
}

bool is_far_too_deep(const PairCase& pair, const Claim& claim, const Declaration& declaration) {
  const double depth = true_depth(pair);
  return claim.depth > 2 * std::abs(depth) &&
         claim.depth - depth > 100 * bounds(pair, declaration).separation;
}

bool is_depth_elsewhere(const JudgedCase& judged, const Declaration& declaration) {
  const PairCase& pair = judged.given.pair;
  return judged.judgement.magnitude * size(pair) <= bounds(pair, declaration).position;
}

int right_count(const JudgedCase& judged, const Declaration& declaration) {
  int most = 0;
  for (const Manifold<double>& right :
       manifolds_to_show(admissible(judged.given.pair, declaration), declaration)) {
    most = std::max(most, right.count);
  }
  return most;
}

bool is_nonsense(const DeclaredAnswer& asked) {
  const auto* const lost = std::get_if<Lost>(&asked.answer);
  return lost == nullptr || lost->how == Lost::How::malformed;
}

namespace {

/// Of a size, or of a unit normal: so little is not seen, but checks fail by it.
constexpr double kUnseen = 1e-3;

constexpr std::string_view kUnseenInWords =
    "nothing on a screen, but what takes these figures for exact, such as an assertion or a "
    "comparison between platforms, fails";

std::string pushed_too_far(double by, double enough) {
  if (plain(by) == plain(enough)) {
    return fmt::format("the bodies are pushed {} farther than they need", plain(by - enough));
  }
  return fmt::format("the bodies are pushed by {} where {} suffices", plain(by), plain(enough));
}

/// `depth`: what moves them apart.
std::string seen_of_depth(const Claim& claim, double depth) {
  if (claim.depth <= depth) {
    return fmt::format("the bodies stay {} inside each other", plain(depth - claim.depth));
  }
  return pushed_too_far(claim.depth, std::max(depth, 0.0));
}

}  // namespace

std::string seen_by_users(const JudgedCase& judged, const DeclaredAnswer& asked) {
  const PairCase& pair = judged.given.pair;
  const Claim claim = claim_of(asked.answer);
  const Kind kind = judged.judgement.bucket.kind;
  const bool is_of_figures = kind == Kind::normal || kind == Kind::depth ||
                             kind == Kind::inconsistent || kind == Kind::not_minimal ||
                             kind == Kind::position || kind == Kind::witness;
  const bool is_elsewhere = kind == Kind::witness && is_depth_elsewhere(judged, asked.declaration);
  const bool is_unseen = judged.judgement.magnitude < kUnseen;
  if (is_of_figures && !is_elsewhere && is_unseen) return std::string(kUnseenInWords);
  switch (kind) {
    case Kind::missed_contact:
      return "nothing holds the bodies apart here, so they move further into each other";
    case Kind::phantom_contact:
      return "bodies that do not touch are stopped or pushed across the gap";
    case Kind::normal:
      if (is_far_too_deep(pair, claim, asked.declaration)) {
        return seen_of_depth(claim, true_depth(pair));
      }
      return "impulses act along a wrong direction or with a wrong strength, so bodies sink into "
             "each other or jump aside";
    case Kind::position:
    case Kind::witness:
      return "the impulse has a wrong lever arm, so the bodies get a spin that they should not "
             "have";
    case Kind::count:
    case Kind::extent:
      return claim.points > right_count(judged, asked.declaration)
                 ? "a part of the impulse acts where the shapes hardly touch"
                 : "a face rests on too few points and rocks";
    case Kind::features:
      return "impulses of the last step are not found again, so warm starting is lost";
    case Kind::reversed:
      return "the bodies are pushed further into each other";
    case Kind::depth:
    case Kind::inconsistent:
      return seen_of_depth(claim, depth_along(pair, claim));
    case Kind::not_minimal:
      return pushed_too_far(depth_along(pair, claim), true_depth(pair));
    case Kind::altered_shape:
      return "bodies collide as another shape than was given";
    default:
      return is_nonsense(asked)
                 ? "figures that are no numbers, or no contact, spread through the simulation"
                 : "the simulation stops";
  }
}

}  // namespace manifuzz
