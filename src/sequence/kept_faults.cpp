#include "sequence/kept_faults.hpp"

#include <algorithm>

#include "judging/ledger.hpp"
#include "sequence/kept_point.hpp"

namespace manifuzz {

const KeptPoint& point_of(const FrameView& view, const FrameJudgement& judgement) {
  const auto& points = judgement.kind == Kind::extent ? view.points_before() : view.points();
  return points[*judgement.point];
}

bool normal_of_the_world(const FrameView& view, const FrameJudgement& judgement) {
  if (!judgement.point) return false;
  const KeptPoint& point = point_of(view, judgement);
  const KeptPoint& birth = view.birth_of(point);
  const double bound = view.bound().normal;
  if ((point.normal - birth.normal).norm() > bound) return false;
  if (judgement.kind == Kind::normal) return !view.is_born(point);
  if (judgement.kind != Kind::extent) return false;
  const AnchorsNow now = anchors_now(view.pair(), point, point.normal);
  return -now.depth > view.keeping().gap.of(view.pair()) - view.bound().gap ||
         now.drift > view.keeping().drift.of(view.pair()) - view.bound().gap;
}

bool slot_by_areas(const FrameView& view, const FrameJudgement& judgement) {
  if (judgement.kind != Kind::extent) return false;
  const auto& before = view.points_before();
  const bool was_full = static_cast<int>(before.size()) == view.keeping().points_max;
  return was_full && std::ranges::any_of(view.points(), [&](const KeptPoint& point) {
           return view.is_born(point) && std::ranges::none_of(before, [&](const KeptPoint& old) {
                    return old.id == point.id;
                  });
         });
}

namespace {

/// No point is as deep as they overlap since the one that is new is not.
bool detected_too_shallow(std::string_view engine, const FrameView& view) {
  for (std::size_t i = 0; i < view.points().size(); ++i) {
    if (!view.is_born(view.points()[i])) continue;
    FrameJudgement of_birth = judge_birth(view, view.points()[i]);
    of_birth.point = i;
    if (of_birth.kind != Kind::none && detected_by(engine, view, of_birth)) return true;
  }
  return false;
}

}  // namespace

bool detected_by(std::string_view engine, const FrameView& view, const FrameJudgement& judgement) {
  const bool is_anything_new = std::ranges::any_of(
      view.points(), [&](const KeptPoint& point) { return view.is_born(point); });
  const bool is_too_shallow = judgement.kind == Kind::depth;
  if (is_too_shallow && is_anything_new) return detected_too_shallow(engine, view);
  Manifold<double> got;
  if (judgement.point) {
    if (judgement.kind == Kind::extent) return false;
    const KeptPoint& point = point_of(view, judgement);
    if (!view.is_born(point)) return false;
    got = detected_on_b(view.pair(), point);
  }
  const Declaration& declaration = view.subject.declaration;
  const auto truth = std::make_shared<const exact::Truth>(view.pair());
  const Admissible right = admissible(truth, declaration);
  // What is kept hides that the contact was missed.
  const Kind kind = is_too_shallow ? Kind::missed_contact : judgement.kind;
  return find_explanation(engine, {right, got, kind}) != nullptr;
}

}  // namespace manifuzz
