#include "report/picture/case_map.hpp"

#include "campaign/in_child.hpp"
#include "campaign/neighbourhood_run.hpp"
#include "report/picture/map_picture.hpp"
#include "report/picture/map_words.hpp"

namespace manifuzz {

CaseMap case_map(const JudgedCase& judged, const Collider& subject, const Collider& oracle,
                 int step_ulps, Interruption& interruption) {
  const PairCase& pair = judged.given.pair;
  const Grid grid = grid_around(exact::Truth(pair), step_ulps);
  const Neighbourhood map =
      ask_neighbourhood(pair, subject, oracle, grid, grid.cell_count(), interruption);
  if (interruption.is_stopped()) throw Interrupted();
  return {map_png(judged, map), {grid_in_words(grid), severity_in_words(judged, map)}};
}

}  // namespace manifuzz
