#include "cli/stress_options.hpp"

#include "cli/options.hpp"

namespace manifuzz {
namespace {

void add_run(CLI::App& app, StressOptions& options) {
  app.add_option("--sweep", options.sweeps, "a sweep or a walk, again for more; all if not given")
      ->type_name("S")
      ->allow_extra_args(false);
  app.add_option("--collider", options.colliders,
                 "a collider, again for more; all that are there if not given")
      ->type_name("C|LIBRARY.so")
      ->allow_extra_args(false);
  app.add_option("--collider-command", options.program.command,
                 "one more, as a program: case lines in, manifold lines out")
      ->type_name("COMMAND")
      ->check(not_blank);
  add_external_options(app, options.outside);
  add_whole_number(app, "--cases", options.cases, "a step; 100000 if not given", 1);
  add_whole_number(app, "--frames", options.frames, "a walk; 1000000 if not given", 1);
  add_whole_number(app, "--seed", options.seed, "what the cases depend on; 1 if not given");
  add_whole_number(app, "--jobs", options.jobs, "how many processes; one a core if not given", 1);
  app.add_flag(
      "--quick", options.quick,
      "fewer cases, and no collider in a process of its own unless it is named: less than 20 s");
  app.add_flag("--flush-to-zero", options.flush_to_zero,
               "colliders in this process compute without subnormal numbers, as engines may");
}

void add_outputs(CLI::App& app, StressOptions& options) {
  app.add_option("--json", options.json, "every step as JSON, to a file or - for stdout")
      ->type_name("FILE");
  app.add_option("--csv", options.csv, "every step with commas")->type_name("FILE");
  app.add_option("--pictures", options.pictures,
                 "error against each sweep's knob, DIR/SWEEP.svg and DIR/SWEEP.png")
      ->type_name("DIR")
      ->check(not_blank);
  app.add_option("--save", options.save,
                 "a corpus for the worst: wrong cases shrunk, and clip's worst of every sweep")
      ->type_name("DIR")
      ->check(not_blank);
  app.add_option("--baseline", options.baseline,
                 "breaking points that were stored: none may have moved down")
      ->type_name("FILE")
      ->check(not_blank);
  app.add_option("--store", options.store,
                 "stores the breaking points, for --baseline, over those in it")
      ->type_name("FILE")
      ->check(not_blank);
}

}  // namespace

void add_stress_options(CLI::App& app, StressOptions& options) {
  add_run(app, options);
  add_outputs(app, options);
}

}  // namespace manifuzz
