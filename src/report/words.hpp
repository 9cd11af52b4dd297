#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

#include "campaign/plan.hpp"
#include "judging/judge.hpp"

namespace manifuzz {

/// Four significant digits or a few more, for labels.
std::string brief(double value);

/// "A face 2", the face by its number and its owner's name.
std::string face_name(Side side, int face);

/// "A face 2" or "A vertex 2".
std::string place_name(Side side, Feature feature);

/// "circle, radius 0.5", "segment", "capsule, radius 0.5", "4 vertices, radius 0.5, round corners".
std::string shape_in_words(const ConvexPolygon<float>& shape);

/// "overlap 0.31", or what else lies between the polygons: the depth of rounded ones, a gap.
std::string truth_in_words(const PairCase& pair);

/// What a collider answered: "no contact", "2 points, depths 0.3 and 0.25", "crashed".
std::string answer_in_words(const DeclaredAnswer& asked);

/// The verdict as a sentence: "oracle wrong (known): box2d reports no contact, true overlap 0.31".
std::string verdict_sentence(const JudgedCase& judged);

/// The verdict's sentence and, for an answer that was lost or is nonsense, the reason.
std::string verdict_and_why(const JudgedCase& judged);

/// A verdict, and what it means of these two colliders.
std::string verdict_in_words(Verdict verdict, const std::string& subject,
                             const std::string& oracle);

/// "A clips, 2 points: f1/v0 and v2/f3": features are A's / B's.
std::string statement_in_words(const ContactSummary& statement);

/// What the map is a map of: "vertex 0 of B moved by up to 64 steps of 1 ulp (6e-08) each way ...".
std::string grid_in_words(const Grid& grid);

/// "severity 0.511: box2d is wrong on 8504 of 16641 neighbours", and what was not judged.
std::string severity_in_words(const JudgedCase& judged, const Neighbourhood& neighbourhood);

/// The right manifold that a picture or a text shows: the subject's own choice where that is right,
/// else the first whose incident edge meets the slab, else the first; nullptr where the polygons
/// are apart.
const exact::Clip* candidate_to_show(const Admissible& right, const DeclaredAnswer& subject);

/// Text as Markdown that shows it as it is, in one line.
std::string escape_markdown(std::string_view text);

/// A block of code that `text` cannot end, whatever it holds.
std::string code_block(std::string_view text, std::string_view language);

/// The case for a terminal: verdict, polygons, truth, bounds, candidate and answers. Numbers read
/// back bit for bit.
std::string case_text(const JudgedCase& judged);

/// Appends what `collide` prints of a case as one line of JSON, without its end: the collider's
/// manifold. Throws UserError where there is no answer, or numbers that JSON cannot write.
void append_collision(std::string& line, const Collider& collider, const PairCase& pair);

/// Appends what `judge` prints: what is right, by how much one may be off, verdict and bucket,
/// of a known one the ledger's entry. Lengths are in the world.
void append_judgement(std::string& line, const Admissible& right, const ColliderAnswer& subject,
                      const Judgement& judgement);

/// A case as its line has it.
nlohmann::ordered_json case_json(const PairCase& pair);

/// The case as a report to the authors of the collider at fault, in Markdown of at most 30 lines:
/// what happens, a program that shows it, what it answers, what is right, what a user sees, and how
/// to check that by hand. `options` choose the two colliders again, for one that gives no program
/// of its own. Throws UserError where nobody is at fault.
std::string upstream_report(const JudgedCase& judged, const std::string& options);

}  // namespace manifuzz
