#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "base/text.hpp"
#include "cli/collider_choice.hpp"
#include "cli/commands.hpp"
#include "cli/kinds.hpp"
#include "cli/options.hpp"
#include "corpus/corpus.hpp"
#include "report/words.hpp"

namespace manifuzz {
namespace {

struct CollideArguments {
  ColliderChoice collider{"collider", "", ""};
  ExternalOptions external;
  std::optional<double> tie_bias;
  std::string file = "-";
};

int collide_cases(const CollideArguments& options) {
  if (!options.collider.is_given()) {
    throw UserError("--collider is required; `manifuzz list colliders` names them");
  }
  if (const OtherKind* const kind = kind_for(options.collider)) {
    expect_none_of(*kind, {{"--tie-bias", options.tie_bias.has_value()}});
    return kind->collide(options.collider, options.external, options.file);
  }
  const Collider collider = find_collider(options.collider, options.external, options.tie_bias);
  answer_each(options.file, CaseKind::pair,
              [&collider](const AnyCase& any, std::size_t, std::string& line) {
                append_collision(line, collider, std::get<PairCase>(any));
              });
  return 0;
}

void add_collide_arguments(CLI::App& app, CollideArguments& options) {
  add_collider(app, options.collider, "collider to ask; `manifuzz list colliders` lists the names");
  add_sequences(app, options.collider);
  add_external_options(app, options.external);
  add_length(app, "--tie-bias", options.tie_bias,
             "how much greater the separation of B's face must be for B to become the reference");
  add_file_of_cases(app, options.file);
}

}  // namespace

Run define_collide(CLI::App& app) {
  return define<CollideArguments, add_collide_arguments, collide_cases>(app);
}

}  // namespace manifuzz
