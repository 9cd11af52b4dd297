#include "report/glossary.hpp"

#include <array>

#include <fmt/format.h>

namespace manifuzz {
namespace {

using Word = std::pair<std::string_view, std::string_view>;

constexpr std::array kWords{
    Word{"collider", "a function or program that gives the contact manifold of two convex shapes"},
    Word{"manifold",
         "a unit normal from A to B and up to two contact points, each with a position "
         "and a depth"},
    Word{"subject", "the collider under test"},
    Word{"oracle", "the collider it is held against; it may be wrong too"},
    Word{"truth", "every manifold that is right for a case, decided in exact arithmetic"},
    Word{"claims",
         "what a collider says its answers are: manifolds that clips make, points, a "
         "separation, or touching alone; it is judged by that"},
    Word{"bound",
         "how far rounding alone may take a right answer of a collider's scalar and frame"},
    Word{"verdict",
         "what came of one case: agree, tie, known, wrong, ill posed, unsupported or lost"},
    Word{"tie",
         "two decisions lie within bound of each other, so that several manifolds are right; "
         "subject and oracle gave different ones of them"},
    Word{"known", "an answer is wrong, and the ledger names the cause, found by recomputing it"},
    Word{"ledger", "the list of known causes of wrong answers, engine by engine"},
    Word{"ill posed",
         "the bound exceeds 5% of the size and the answers lie within it: rounding "
         "hides what is right"},
    Word{"near", "the shapes are apart by at most a tenth of the size"},
    Word{"size", "the smaller shape's diameter, which errors are given in"},
    Word{"magnitude",
         "how wrong an answer is: its greatest error beyond bound, as a share of the "
         "size"},
    Word{"reference",
         "the face along whose normal a clip measures; the other shape's edge is the "
         "incident one"},
    Word{"kind",
         "what is wrong: a missed contact, a normal, a position, a depth, a count, and so on"},
    Word{"bucket",
         "one name for findings that look alike: who is at fault, verdict, kind, tie, "
         "reference, and how far off"},
    Word{"regime", "a way of drawing cases, such as slivers or nearly tied faces"},
    Word{"sequence", "one pair of shapes in frame after frame, for colliders that keep points"},
    Word{"motion", "a way of drawing sequences, such as a box that rocks on a floor"},
    Word{"corpus", "a folder of cases that are known, each a file"},
    Word{"accepted",
         "a finding that its author has said may stay; what is worse or more frequent "
         "fails"},
    Word{"severity",
         "the share of a case's neighbours, one vertex moved by ulps, for which the "
         "collider fails too"}};

}  // namespace

std::span<const Word> glossary() {
  return kWords;
}

std::string glossary_text() {
  std::string text;
  for (const auto& [word, meaning] : kWords) text += fmt::format("{:<10} {}\n", word, meaning);
  return text;
}

}  // namespace manifuzz
