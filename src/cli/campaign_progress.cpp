#include "cli/campaign_progress.hpp"

#include <array>

#include "cli/fuzz_report.hpp"
#include "cli/output.hpp"
#include "measure/provenance.hpp"

namespace manifuzz {

Campaign run_with_progress(const Plan& plan, const KnownBuckets& known, const SaveTo& save_to,
                           const std::string& command) {
  const std::array declarations{plan.subject.declaration, plan.oracle.declaration};
  const ProgressLine line;
  return run_campaign(plan, known, save_to, {command, provenance(plan.seed, declarations)},
                      [&](const Progress& progress) { line.show(progress_line(plan, progress)); });
}

}  // namespace manifuzz
