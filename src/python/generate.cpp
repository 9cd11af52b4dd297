#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>
#include <optional>

#include "generating/regime.hpp"
#include "python/shapes.hpp"

namespace manifuzz::python {
namespace {

PosesRecord<float> poses_of(const PairCase& pair) {
  const auto record = [](const Pose<float>& pose) -> PoseRecord<float> {
    return {pose.position.x(), pose.position.y(), pose.rotation.x(), pose.rotation.y()};
  };
  return {record(pair.a.pose), record(pair.b.pose)};
}

/// Cases `first` and on of a regime, which there is, as many as the arrays are long.
void generate_cases(const std::string& name, std::uint64_t seed, std::uint64_t first,
                    std::optional<float> radius, const Out<ShapeRecord<float>>& a,
                    const Out<ShapeRecord<float>>& b, const Out<PosesRecord<float>>& poses) {
  const Regime& regime = *find_regime(name);
  const GenerationContext context{.corpus = {}, .radius = radius};
  const auto shapes_a = records<ShapeRecord<float>>(a);
  const auto shapes_b = records<ShapeRecord<float>>(b);
  const auto placed = records<PosesRecord<float>>(poses);
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const PairCase pair = generate(seed, regime, first + i, context);
    shapes_a[i] = record_of(pair.a.polygon);
    shapes_b[i] = record_of(pair.b.polygon);
    placed[i] = poses_of(pair);
  }
}

/// Each with its description.
std::vector<std::pair<std::string, std::string>> named_regimes() {
  std::vector<std::pair<std::string, std::string>> all;
  for (const Regime& regime : regimes()) all.emplace_back(regime.name, regime.description);
  return all;
}

}  // namespace

void define_cases(nanobind::module_& module) {
  module.def("generate", generate_cases, nanobind::arg(), nanobind::arg(), nanobind::arg(),
             nanobind::arg().none(), nanobind::arg(), nanobind::arg(), nanobind::arg(), Unlocked());
  module.def("regimes", named_regimes);
}

}  // namespace manifuzz::python
