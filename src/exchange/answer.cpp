#include <fmt/format.h>

#include "base/json.hpp"
#include "base/text.hpp"
#include "exchange/json.hpp"

namespace manifuzz {

PartialManifold in_frame_of_a(const ReportedManifold& reported, const Conventions& conventions,
                              const PairCase& pair) {
  PartialManifold result{.names_reference = reported.reference.has_value(),
                         .names_features = reported.count > 0,
                         .has_midpoints = conventions.has_midpoints};
  Manifold<double>& manifold = result.manifold;
  manifold.count = reported.count;
  if (manifold.count == 0) return result;
  manifold.reference = reported.reference.value_or(Side::a);
  manifold.normal = conventions.normal_in_a ? reported.normal : local_normal(pair, reported.normal);
  if (conventions.normal_from_b) manifold.normal = -manifold.normal;
  for (int i = 0; i < manifold.count; ++i) {
    const ReportedPoint& point = reported.points[i];
    manifold.points[i] = {point.local ? *point.local : to_local(pair.a.pose, point.world.value()),
                          point.depth, point.features.value_or(FeaturePair{})};
    result.names_features = result.names_features && point.features.has_value();
  }
  if (!conventions.is_ordered) order_points(manifold);
  return result;
}

Answer AnswerFile::at(std::size_t index, const PairCase& pair) {
  while (read_ < index) next_line();
  const Line line = next_line();
  try {
    if (line.too_long) throw UserError("longer than 1 MiB");
    const JsonTree tree = parse_json(line.text);
    return read_reported_answer(JsonView(tree), pair);
  } catch (const UserError& error) {
    throw UserError(fmt::format("{}:{}: {}", file_.name(), line.number, error.what()));
  }
}

void AnswerFile::expect_end() {
  const auto line = lines_.next();
  if (!line) return;
  throw UserError(fmt::format("{}:{}: an answer more than there are cases; one a case is expected",
                              file_.name(), line->number));
}

Line AnswerFile::next_line() {
  const auto line = lines_.next();
  ++read_;
  if (line) return *line;
  throw UserError(file_.name() + ": ends before the cases do; an answer a case is expected");
}

}  // namespace manifuzz
