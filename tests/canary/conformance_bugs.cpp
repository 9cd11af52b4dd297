#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <iostream>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/file.hpp"
#include "base/json.hpp"
#include "canary/planted.hpp"
#include "conformance/conformance_case.hpp"
#include "exchange/json.hpp"
#include "generating/regime.hpp"
#include "judging/judge.hpp"

// What ports with planted bugs answer to the conformance suite: `answers CASES FOLDER` writes a
// file for each, `picks SEED CASES BUG...` finds drawn cases on which the exact judge blames them.

namespace manifuzz::canary {
namespace {

using Answers = std::vector<Answer>;

/// A port with a planted bug, asked about all cases at once, as a kernel for many pairs is.
struct Port {
  Bug bug;
  Declaration declaration;
  std::function<Answers(std::span<const PairCase>)> ask;

  std::string name() const {
    return fmt::format("{}.{}.{}.{}", bug.table, bug.name, declaration.name,
                       declaration.scalar == ScalarType::float32 ? "float32" : "float64");
  }
};

std::vector<Port>& ports() {
  static std::vector<Port> all;
  return all;
}

void add_port(const Bug& bug, const Declaration& declaration,
              const std::function<Answers(std::span<const PairCase>)>& ask) {
  ports().push_back({bug, declaration, [bug, ask](std::span<const PairCase> pairs) {
                       const Acting acting(bug);
                       return ask(pairs);
                     }});
}

void add_port_of(const Bug& bug, const Collider& collider) {
  const Declaration& declaration = collider.declaration;
  add_port(bug,
           {.name = declaration.name,
            .scalar = declaration.scalar,
            .second_point = declaration.second_point},
           [collide = collider.collide](std::span<const PairCase> pairs) {
             Answers answers;
             std::ranges::transform(pairs, std::back_inserter(answers), collide);
             return answers;
           });
}

bool is_wrong(const PairCase& pair, const Declaration& declaration, const Answer& answer) {
  const auto truth = std::make_shared<const exact::Truth>(pair);
  return judge_alone(truth, {declaration, answer}).bucket.fault != Fault::none;
}

/// The article's own entry, which is given a normal and goes by farthest vertices: asked where that
/// is right without the bug.
void add_port_of_normals(const Bug& bug, const Collider& collider) {
  const Declaration declaration{.name = collider.declaration.name + "_of_normals",
                                .scalar = collider.declaration.scalar};
  add_port(bug, declaration, [bug, collider, declaration](std::span<const PairCase> pairs) {
    Answers answers;
    for (const PairCase& pair : pairs) {
      const Acting none(Bug{"", 0, ""});
      const Answer usual = collider.collide(pair);
      answers.push_back(usual);
      const auto* const manifold = std::get_if<Manifold<double>>(&usual);
      if (is_round(pair) || manifold == nullptr || manifold->count == 0) continue;
      if (is_wrong(pair, declaration, collider.from_normal(pair, manifold->normal))) continue;
      const Acting acting(bug);
      answers.back() = collider.from_normal(pair, manifold->normal);
    }
    return answers;
  });
}

template <class Scalar>
void add_batch(const Bug& bug, const std::string& variant,
               typename PlantedBatch<Scalar>::Collide collide) {
  const auto scalar = std::is_same_v<Scalar, float> ? ScalarType::float32 : ScalarType::float64;
  add_port(bug, {.name = variant, .scalar = scalar}, [collide](std::span<const PairCase> pairs) {
    std::vector<Placed<Scalar>> placed;
    for (const PairCase& pair : pairs) placed.push_back(clipping::placed_pair<Scalar>(pair));
    std::vector<Manifold<Scalar>> manifolds(pairs.size());
    collide(placed, Scalar(0), manifolds.data());
    Answers answers;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      for (auto& point : manifolds[i].points) point.position *= placed[i].local_per_world;
      answers.emplace_back(manifold_cast<double>(manifolds[i]));
    }
    return answers;
  });
}

}  // namespace

bool add_colliders(const std::vector<Bug>& bugs, const MakeCollider& make) {
  for (const Bug& bug : bugs) {
    for (const Collider& collider : {make(0), make(0).in_double()}) {
      add_port_of(bug, collider);
      if (!bug.is_round()) add_port_of_normals(bug, collider);
    }
  }
  return true;
}

bool add_round_colliders(const std::vector<Bug>& bugs, const MakeCollider& make,
                         MakeWithSecondPoint make_with_second_point) {
  for (const Bug& bug : bugs) {
    Collider of_one_point = make_with_second_point(SecondPoint::never());
    of_one_point.declaration.name = "clip_never";
    add_port_of(bug, of_one_point);
  }
  return add_colliders(bugs, make);
}

bool add_methods(const std::vector<Bug>& bugs, const std::vector<MakeMethod>& makes) {
  for (const Bug& bug : bugs) {
    for (const MakeMethod make : makes) {
      const Collider collider = make();
      if (!is_judged_by_curve(collider.declaration)) add_port_of(bug, collider);
    }
  }
  return true;
}

bool add_pairs(const std::vector<Bug>& bugs, AskPair ask) {
  for (const Bug& bug : bugs) {
    for (const bool hinted : {false, true}) {
      add_port(bug, {.name = hinted ? "pair_hinted" : "pair"},
               [ask, hinted](std::span<const PairCase> pairs) {
                 Answers answers;
                 for (const PairAnswers& said : ask(pairs, 0, hinted)) {
                   answers.emplace_back(manifold_cast<double>(said.manifold));
                 }
                 return answers;
               });
    }
  }
  return true;
}

bool add_batches(const std::vector<Bug>& bugs, const PlantedBatch<float>& batch,
                 const PlantedBatch<double>& batch64) {
  for (const Bug& bug : bugs) {
    add_batch<float>(bug, "batch", batch.from_indices);
    add_batch<float>(bug, "batch_packed", batch.packed);
    add_batch<double>(bug, "batch64", batch64.from_indices);
    add_batch<double>(bug, "batch64_packed", batch64.packed);
  }
  return true;
}

bool add_judges(const std::vector<Bug>& /*bugs*/, JudgeOf /*judge_of*/) {
  return true;
}

namespace {

std::vector<PairCase> read_pairs(const std::string& path) {
  InputFile file(path);
  LineReader lines(file);
  std::vector<PairCase> pairs;
  while (const auto line = lines.next()) {
    const JsonTree tree = parse_json(line->text);
    const JsonView view(tree);
    pairs.push_back({read_body(view.at("a")), read_body(view.at("b"))});
  }
  return pairs;
}

void write_answers(const std::vector<PairCase>& pairs, const std::filesystem::path& folder) {
  for (const Port& port : ports()) {
    const Answers answers = port.ask(pairs);
    std::string text;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      append_answer(text, pairs[i], port.declaration.name, answers[i]);
      text += '\n';
    }
    write_file(folder / (port.name() + ".jsonl"), text);
  }
}

/// A few cases a bug, of the first port that shows it.
void print_picks(std::uint64_t seed, std::uint64_t cases, const std::set<std::string>& bugs) {
  constexpr int kPicks = 2;
  constexpr std::uint64_t kTogether = 50;
  std::map<std::string, int> found;
  for (std::uint64_t first = 0; first < cases; first += kTogether) {
    for (const Regime& regime : regimes()) {
      if (regime.name == "corpus") continue;
      std::vector<PairCase> pairs;
      for (std::uint64_t i = 0; i < kTogether; ++i) {
        pairs.push_back(generate(seed, regime, first + i));
      }
      for (const Port& port : ports()) {
        const std::string bug = fmt::format("{}.{}", port.bug.table, port.bug.name);
        if (!bugs.contains(bug) || found[bug] >= kPicks) continue;
        const Answers answers = port.ask(pairs);
        for (std::uint64_t i = 0; i < kTogether && found[bug] < kPicks; ++i) {
          if (!is_wrong(pairs[i], port.declaration, answers[i]) || !conformance_line("", pairs[i]))
            continue;
          ++found[bug];
          std::cout << regime.name << '/' << seed << '/' << first + i << "  # " << port.name()
                    << std::endl;
        }
      }
    }
  }
  for (const std::string& bug : bugs) {
    if (found[bug] == 0) std::cout << "# none of " << bug << std::endl;
  }
}

}  // namespace
}  // namespace manifuzz::canary

int main(int argc, char** argv) {
  using namespace manifuzz::canary;
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words.size() == 3 && words[0] == "answers") {
    write_answers(read_pairs(words[1]), words[2]);
    return 0;
  }
  if (words.size() > 3 && words[0] == "picks") {
    print_picks(std::stoull(words[1]), std::stoull(words[2]), {words.begin() + 3, words.end()});
    return 0;
  }
  std::cerr << "answers CASES FOLDER, or picks SEED CASES TABLE.BUG... is expected\n";
  return 2;
}
