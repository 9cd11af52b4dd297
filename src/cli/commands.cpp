#include "cli/commands.hpp"

namespace manifuzz {

// Each in a file of its own.
Run define_accept(CLI::App& app);
Run define_collide(CLI::App& app);
Run define_fuzz(CLI::App& app);
Run define_generate(CLI::App& app);
Run define_init(CLI::App& app);
Run define_judge(CLI::App& app);
Run define_list(CLI::App& app);
Run define_replay(CLI::App& app);
Run define_report(CLI::App& app);
Run define_show(CLI::App& app);
Run define_shrink(CLI::App& app);
Run define_smoke(CLI::App& app);

// In the program manifuzz-measure; null in those that are linked without its files.
[[gnu::weak]] Run define_bench(CLI::App& app);
[[gnu::weak]] Run define_conformance(CLI::App& app);
[[gnu::weak]] Run define_digest(CLI::App& app);
[[gnu::weak]] Run define_hunt(CLI::App& app);
[[gnu::weak]] Run define_merge(CLI::App& app);
[[gnu::weak]] Run define_property(CLI::App& app);
[[gnu::weak]] Run define_scene(CLI::App& app);
[[gnu::weak]] Run define_stress(CLI::App& app);

std::span<const Command> commands() {
  static const Command all[] = {
      {"fuzz",
       "Compare two colliders on random cases; judge, shrink and save disagreements. A subject "
       "that keeps points gets sequences of the motions named by --regime, and is judged alone.",
       "manifuzz fuzz --regime sliver --seed 1 --cases 100000\n"
       "manifuzz fuzz --until-new --regime sliver --seed 1 --cases 20000\n"
       "manifuzz fuzz --until-risk 0.001 --regime sliver --judge-every 8 --seed 1\n"
       "manifuzz fuzz --subject cached --regime turning_platform --seed 1 --cases 1000",
       define_fuzz},
      {"hunt",
       "Breed cases from cases, to find the worst that a collider does, and behaviour that drawn "
       "cases do not show; judge, shrink and save it as fuzz does.",
       "manifuzz hunt --subject clip --seed 1 --cases 50000\n"
       "manifuzz hunt --subject batch --measure bound_share --from corpus/seeds --seed 1 --cases "
       "20000",
       define_hunt},
      {"replay", "Run every case and sequence of the corpus again; the subject must be right.",
       "manifuzz replay corpus --subject clip --oracle box2d", define_replay},
      {"property", "Test a collider for what must be true of any collider; this needs no oracle.",
       "manifuzz property swapping-mirrors --subject clip --cases 100000 --seed 1",
       define_property},
      {"smoke",
       "Replay the corpus, test properties and run a campaign, in at most 20 s; meant for CI.",
       "manifuzz smoke --subject clip --oracle box2d --seed 1 --no-save --junit smoke.xml",
       define_smoke},
      {"init",
       "Begin with a collider of your own: write subjects.json, a workflow for CI, a first corpus "
       "that CI passes and, where no collider is named, one to edit.",
       "manifuzz init mine --cases 2000", define_init},
      {"collide",
       "Read cases; print the collider's manifolds, one JSON line a case (or frame, for "
       "sequences).",
       "manifuzz collide --collider clip corpus/seeds/regime-boxes.json\n"
       "manifuzz generate --regime boxes --cases 100 | manifuzz collide --collider box2d\n"
       "manifuzz generate --regime sliding --cases 1 | manifuzz collide --collider cached",
       define_collide},
      {"judge", "Read cases; print the right manifolds and who is wrong, one JSON line a case.",
       "manifuzz generate --seed 1 --regime sliver --cases 10 | manifuzz judge\n"
       "manifuzz generate --seed 1 --regime boxes --cases 10 > cases.jsonl\n"
       "manifuzz collide --collider box2d cases.jsonl > answers.jsonl\n"
       "manifuzz judge --subject box2d --manifolds answers.jsonl cases.jsonl",
       define_judge},
      {"accept", "Accept known findings: runs fail only if they get worse or more frequent.",
       "manifuzz accept corpus/regressions/subject-*.json --because 'since 2.3' --up-to 0.5\n"
       "manifuzz accept corpus/regressions/subject-*.json --kind --because 'since 2.3' --up-to "
       "0.5\n"
       "manifuzz accept --list",
       define_accept},
      {"generate",
       "Print random cases of the named regimes, or sequences of the named motions, one a line.",
       "manifuzz generate --seed 1 --regime sliver --cases 1000 > slivers.jsonl\n"
       "manifuzz generate --seed 1 --regime turning_platform --cases 10",
       define_generate},
      {"shrink",
       "Shrink a case to the smallest with the same verdict and bucket and a similar error.",
       "manifuzz generate --seed 2 --regime tie_bias --cases 1 | manifuzz shrink - --output "
       "smallest.json",
       define_shrink},
      {"show", "Show a case as text and as a picture: shapes, contact points, verdict.",
       "manifuzz generate --seed 1 --regime boxes --cases 1 | manifuzz show - --svg case.svg "
       "--map case.png\n"
       "manifuzz show none/tie/count/incident/a",
       define_show},
      {"bench", "Measure run time and error of every collider in one run.",
       "manifuzz bench --quick --picture bench.svg\n"
       "manifuzz bench --quick --methods --picture methods.svg",
       define_bench},
      {"stress", "Test numerical stability: vary one parameter until each collider breaks.",
       "manifuzz stress --quick --sweep distance", define_stress},
      {"scene", "Run whole scenes step by step, and compare with Box2D's contact manager.",
       "manifuzz scene --scene resting_pile --bodies 1000 --steps 20", define_scene},
      {"digest", "Hash every bit of a collider's answers, one hash per regime, to compare builds.",
       "manifuzz digest --collider batch --cases 1000", define_digest},
      {"conformance",
       "Write the conformance suite: cases with every right manifold, for checkers of ports.",
       "manifuzz conformance --output build/cases.jsonl", define_conformance},
      {"report", "Write one HTML page about findings and measurements.",
       "manifuzz fuzz --seed 1 --cases 100000 --json run.json\n"
       "manifuzz report corpus run.json --output report.html",
       define_report},
      {"merge", "Merge several runs into one; keep the smallest and the worst case of each bucket.",
       "manifuzz fuzz --seed 1 --cases 200000 --share 0/2 --found run0 --json run0.json\n"
       "manifuzz fuzz --seed 1 --cases 200000 --share 1/2 --found run1 --json run1.json\n"
       "manifuzz merge run0 run1 run0.json run1.json --output all --json all.json",
       define_merge},
      {"list",
       "List colliders, regimes, motions, known causes, sweeps, scenes or the worst cases, one a "
       "line.",
       "manifuzz list\nmanifuzz list colliders\nmanifuzz list regimes\nmanifuzz list "
       "motions\nmanifuzz list ledger\n"
       "manifuzz list sweeps\nmanifuzz list scenes\nmanifuzz list worst",
       define_list}};
  return all;
}

}  // namespace manifuzz
