#include <algorithm>
#include <iterator>
#include <memory>
#include <new>

#include "clipping/collide.hpp"
#include "kernel/batch.hpp"
#include "kernel/pair.hpp"
#include "kernel/target.hpp"
#include "measure/bench/bench.hpp"
#include "methods/clip_by_gjk.hpp"
#include "methods/closest_points.hpp"
#include "methods/perturbed.hpp"
#include "own_colliders/own_colliders.hpp"

namespace manifuzz {
namespace {

using Pass = std::function<void()>;

/// Pairs as someone who collides one at a time holds them.
template <class Scalar>
std::vector<clipping::PlacedPair<Scalar>> placed_pairs(std::span<const PairCase> pairs) {
  std::vector<clipping::PlacedPair<Scalar>> placed;
  for (const PairCase& pair : pairs) placed.push_back(clipping::placed_pair<Scalar>(pair));
  return placed;
}

/// `ask(placed pair, B's pose in A's frame)` for every pair, its answer written where it is kept:
/// to assign it would copy what has just been written, which costs more than two circles do.
template <class Scalar, class Ask>
Pass one_by_one(std::span<const PairCase> pairs, const Ask& ask) {
  const auto out = std::make_shared<std::vector<Manifold<Scalar>>>(pairs.size());
  return [placed = placed_pairs<Scalar>(pairs), out, ask] {
    for (std::size_t i = 0; i < placed.size(); ++i) {
      ::new (&(*out)[i])
          Manifold<Scalar>(ask(placed[i], relative_pose(placed[i].pose_a, placed[i].pose_b)));
    }
  };
}

template <class Scalar>
Pass clip_pass(std::span<const PairCase> pairs) {
  return one_by_one<Scalar>(pairs, [](const auto& pair, const Pose<Scalar>& b_in_a) {
    return clipping::collide(pair.a, pair.b, b_in_a);
  });
}

/// With the hint that the same pair left before, or none.
template <class Scalar>
Pass gjk_pass(std::span<const PairCase> pairs, bool hinted) {
  const auto hints = std::make_shared<std::vector<methods::Simplex>>(pairs.size());
  const auto out = std::make_shared<std::vector<Manifold<Scalar>>>(pairs.size());
  return [placed = placed_pairs<Scalar>(pairs), hints, hinted, out] {
    for (std::size_t i = 0; i < placed.size(); ++i) {
      const auto& [a, b, pose_a, pose_b, local_per_world] = placed[i];
      if (!hinted) (*hints)[i].count = 0;
      (*out)[i] =
          methods::contact_by_gjk(a, b, relative_pose(pose_a, pose_b), (*hints)[i]).manifold;
    }
  };
}

template <class Scalar, bool hinted>
BenchSubject gjk_subject(std::string name, Collider (*make)()) {
  return {
      .name = std::move(name),
      .prepare = [](std::span<const PairCase> pairs) { return gjk_pass<Scalar>(pairs, hinted); },
      .collider = make};
}

Pass gjk_shrunk_pass(std::span<const PairCase> pairs) {
  std::vector<PairCase> shrunk;
  for (const PairCase& pair : pairs) shrunk.push_back(shrunk_pair(pair));
  return gjk_pass<float>(shrunk, false);
}

Pass gjk_clip_pass(std::span<const PairCase> pairs) {
  return one_by_one<float>(pairs, [](const auto& pair, const Pose<float>& b_in_a) {
    methods::Simplex hint;
    return methods::clip_by_gjk(pair.a, transform(b_in_a, pair.b), hint);
  });
}

Pass perturbed_pass(std::span<const PairCase> pairs) {
  return one_by_one<float>(pairs, [](const auto& pair, const Pose<float>& b_in_a) {
    methods::Simplex hint;
    return methods::contact_by_perturbing(
        pair.a, pair.b, b_in_a, [&hint](const auto& p, const auto& q, const Pose<float>& q_in_p) {
          return methods::contact_by_gjk(p, q, q_in_p, hint).manifold;
        });
  });
}

/// The deepest vertex behind the face of greatest separation, looked for once the face is known. A
/// function of its own, as those of `clip` are: inlined into a loop it is slower by a third.
[[gnu::noinline]] Manifold<float> deepest_vertex(const ConvexPolygon<float>& a,
                                                 const ConvexPolygon<float>& b) {
  const float total_radius = a.radius + b.radius;
  const auto of_a = clipping::greatest_separation(a, b, total_radius);
  if (of_a.separation > total_radius) return {};
  const auto of_b = clipping::greatest_separation(b, a, total_radius);
  if (of_b.separation > total_radius) return {};
  const bool take_b = of_b.separation > of_a.separation;
  const ConvexPolygon<float>& reference = take_b ? b : a;
  const ConvexPolygon<float>& opposing = take_b ? a : b;
  const int face = take_b ? of_b.face : of_a.face;
  return clipping::lone_vertex(reference, take_b ? Side::b : Side::a,
                               clipping::face_separation(reference, face, opposing), opposing);
}

Pass sat_pass(std::span<const PairCase> pairs) {
  return one_by_one<float>(pairs, [](const auto& pair, const Pose<float>& b_in_a) {
    return deepest_vertex(pair.a, transform(b_in_a, pair.b));
  });
}

Collider make_sat() {
  Collider collider;
  collider.declaration = {.name = "sat",
                          .version = {},
                          .description = "the separating axis and the deepest vertex, one point"};
  collider.collide = [](const PairCase& pair) -> Answer {
    const Pose<float> b_in_a = relative_pose(pair.a.pose, pair.b.pose);
    return manifold_cast<double>(deepest_vertex(pair.a.polygon, transform(b_in_a, pair.b.polygon)));
  };
  return collider;
}

/// An engine's bodies: shapes by index, a pose each.
template <class Scalar>
struct Bodies {
  kernel::Shapes<Scalar> shapes;
  std::vector<kernel::Placement<Scalar>> bodies;
  std::vector<kernel::BodyPair> pairs;
};

template <class Scalar>
Bodies<Scalar> bodies_of(std::span<const PairCase> pairs) {
  Bodies<Scalar> held;
  for (const auto& pair : placed_pairs<Scalar>(pairs)) {
    const auto first = static_cast<std::uint32_t>(held.bodies.size());
    held.bodies.push_back({held.shapes.add(pair.a), pair.pose_a});
    held.bodies.push_back({held.shapes.add(pair.b), pair.pose_b});
    held.pairs.push_back({first, first + 1});
  }
  return held;
}

/// From indices; if hinted, the manifolds of the pass before tell who touched.
template <class Scalar>
Pass indices_pass(std::span<const PairCase> pairs, bool hinted) {
  const auto held = std::make_shared<const Bodies<Scalar>>(bodies_of<Scalar>(pairs));
  const auto out = std::make_shared<std::vector<Manifold<Scalar>>>(pairs.size());
  return [held, out, hinted] {
    const auto& [shapes, bodies, each] = *held;
    if (hinted) {
      kernel::collide_pairs_again(shapes, bodies, each, Scalar{0}, *out);
    } else {
      kernel::collide_pairs(shapes, bodies, each, Scalar{0}, *out);
    }
  };
}

/// Packed, sorted by group; if hinted, pairs that touch lie behind those that do not.
template <class Scalar>
Pass packed_pass(std::span<const PairCase> pairs, bool hinted) {
  Bodies<Scalar> held = bodies_of<Scalar>(pairs);
  std::vector<Manifold<Scalar>> known(pairs.size());
  if (hinted) kernel::collide_pairs(held.shapes, held.bodies, held.pairs, Scalar{0}, known);
  std::ranges::stable_sort(held.pairs, {}, [&](const kernel::BodyPair& pair) {
    return std::pair(known[pair.a / 2].count > 0,
                     held.shapes.group(held.bodies[pair.a].shape, held.bodies[pair.b].shape));
  });
  const auto packed =
      std::make_shared<const kernel::PackedPairs<Scalar>>(held.shapes, held.bodies, held.pairs);
  const auto out =
      std::make_shared<std::vector<kernel::ManifoldBlock<Scalar>>>(packed->block_count());
  return [packed, out] { kernel::collide_packed(*packed, Scalar{0}, *out); };
}

/// Two shapes as the kernel for one pair takes them, and where they stand.
struct RowsPair {
  kernel::ShapeRows a;
  kernel::ShapeRows b;
  Pose<float> pose_a;
  Pose<float> pose_b;
};

/// A query of the kernel for one pair, with the hint that the same query left before, or none; its
/// answer is written where it is kept, as by `one_by_one`.
template <class Ask>
Pass query_pass(std::span<const PairCase> pairs, bool hinted, const Ask& ask) {
  using kernel::ShapeRows;
  using Out = std::invoke_result_t<Ask, ShapeRows, ShapeRows, Pose<float>, kernel::FaceHint*>;
  std::vector<RowsPair> rows;
  for (const auto& pair : placed_pairs<float>(pairs)) {
    rows.push_back({kernel::rows_of(pair.a), kernel::rows_of(pair.b), pair.pose_a, pair.pose_b});
  }
  const auto hints = std::make_shared<std::vector<kernel::FaceHint>>(pairs.size());
  const auto out = std::make_shared<std::vector<Out>>(pairs.size());
  return [rows, hints, hinted, out, ask] {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const RowsPair& pair = rows[i];
      const Pose<float> b_in_a = relative_pose(pair.pose_a, pair.pose_b);
      ::new (&(*out)[i]) Out(ask(pair.a, pair.b, b_in_a, hinted ? &(*hints)[i] : nullptr));
    }
  };
}

void add_pair_queries(std::vector<BenchSubject>& all, const std::string& target) {
  for (const bool hinted : {false, true}) {
    const std::string name = hinted ? "pair+hint" : "pair";
    const auto add = [&](const char* query, const auto& ask) {
      const auto pass = [=](std::span<const PairCase> pairs) {
        return query_pass(pairs, hinted, ask);
      };
      all.push_back({.name = name, .query = query, .target = target, .prepare = pass});
    };
    add("manifold", [](const auto& a, const auto& b, const auto& b_in_a, auto* hint) {
      return kernel::collide(a, b, b_in_a, 0, hint);
    });
    all.back().collider = [] { return make_pair(0); };
    add("separation", [](const auto& a, const auto& b, const auto& b_in_a, auto* hint) {
      return kernel::separation(a, b, b_in_a, hint);
    });
    add("touches", [](const auto& a, const auto& b, const auto& b_in_a, auto* hint) {
      return static_cast<char>(kernel::touches(a, b, b_in_a, hint));
    });
  }
}

template <class Scalar>
void add_batch_inputs(std::vector<BenchSubject>& all, const std::string& name,
                      const std::string& target, Collider (*make)(double)) {
  for (const bool hinted : {false, true}) {
    const auto add = [&](const char* input, Pass (*pass)(std::span<const PairCase>, bool)) {
      all.push_back(
          {.name = hinted ? name + "+hint" : name,
           .input = input,
           .target = target,
           .prepare = [=](std::span<const PairCase> pairs) { return pass(pairs, hinted); },
           .collider = [make] { return make(0); }});
    };
    add("packed", packed_pass<Scalar>);
    add("indices", indices_pass<Scalar>);
  }
}

}  // namespace

std::vector<BenchSubject> own_subjects() {
  std::vector<BenchSubject> all{
      {.name = "clip", .prepare = clip_pass<float>, .collider = [] { return make_clip(0); }},
      {.name = "clip64", .prepare = clip_pass<double>, .collider = [] { return make_clip64(0); }},
      {.name = "sat", .prepare = sat_pass, .collider = make_sat},
      gjk_subject<float, false>("gjk", make_gjk),
      gjk_subject<float, true>("gjk+hint", make_gjk),
      gjk_subject<double, false>("gjk64", make_gjk64),
      {.name = "gjk-clip", .prepare = gjk_clip_pass, .collider = make_gjk_clip},
      {.name = "gjk-shrunk", .prepare = gjk_shrunk_pass, .collider = make_gjk_shrunk},
      {.name = "perturbed", .prepare = perturbed_pass, .collider = make_perturbed}};
  for (const std::string& target : kernel::targets()) {
    if (target == "SCALAR") continue;  // the clean code in lanes of one
    add_pair_queries(all, target);
    add_batch_inputs<float>(all, "batch", target, make_batch);
    add_batch_inputs<double>(all, "batch64", target, make_batch64);
    std::ranges::move(limits(target), std::back_inserter(all));
  }
  return all;
}

}  // namespace manifuzz
