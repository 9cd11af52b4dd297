#include <array>
#include <cmath>

#include "oracle/bullet/ledger/query.hpp"

// btMinkowskiPenetrationDepthSolver.cpp, getPenetrationDirections and calcPenDepth.

namespace manifuzz::ledger_of {
namespace {

constexpr float kDirections[42][3] = {
    {0.000000F, -0.000000F, -1.000000F},  {0.723608F, -0.525725F, -0.447219F},
    {-0.276388F, -0.850649F, -0.447219F}, {-0.894426F, -0.000000F, -0.447216F},
    {-0.276388F, 0.850649F, -0.447220F},  {0.723608F, 0.525725F, -0.447219F},
    {0.276388F, -0.850649F, 0.447220F},   {-0.723608F, -0.525725F, 0.447219F},
    {-0.723608F, 0.525725F, 0.447219F},   {0.276388F, 0.850649F, 0.447219F},
    {0.894426F, 0.000000F, 0.447216F},    {-0.000000F, 0.000000F, 1.000000F},
    {0.425323F, -0.309011F, -0.850654F},  {-0.162456F, -0.499995F, -0.850654F},
    {0.262869F, -0.809012F, -0.525738F},  {0.425323F, 0.309011F, -0.850654F},
    {0.850648F, -0.000000F, -0.525736F},  {-0.525730F, -0.000000F, -0.850652F},
    {-0.688190F, -0.499997F, -0.525736F}, {-0.162456F, 0.499995F, -0.850654F},
    {-0.688190F, 0.499997F, -0.525736F},  {0.262869F, 0.809012F, -0.525738F},
    {0.951058F, 0.309013F, 0.000000F},    {0.951058F, -0.309013F, 0.000000F},
    {0.587786F, -0.809017F, 0.000000F},   {0.000000F, -1.000000F, 0.000000F},
    {-0.587786F, -0.809017F, 0.000000F},  {-0.951058F, -0.309013F, -0.000000F},
    {-0.951058F, 0.309013F, -0.000000F},  {-0.587786F, 0.809017F, -0.000000F},
    {-0.000000F, 1.000000F, -0.000000F},  {0.587786F, 0.809017F, -0.000000F},
    {0.688190F, -0.499997F, 0.525736F},   {-0.262869F, -0.809012F, 0.525738F},
    {-0.850648F, 0.000000F, 0.525736F},   {-0.262869F, 0.809012F, 0.525738F},
    {0.688190F, 0.499997F, 0.525736F},    {0.525730F, 0.000000F, 0.850652F},
    {0.162456F, -0.499995F, 0.850654F},   {-0.425323F, -0.309011F, 0.850654F},
    {-0.425323F, 0.309011F, 0.850654F},   {0.162456F, 0.499995F, 0.850654F}};

/// How far they overlap along a direction from B to A.
float overlap_along(const BulletPair& pair, const Space& full) {
  const Space on_a = pair.place_a.to_world(pair.a.farthest(pair.place_a.to_local(Space(-full))));
  const Space on_b = pair.place_b.to_world(pair.b.farthest(pair.place_b.to_local(full)));
  const Space along = pair.is_flat ? Space(full.x(), full.y(), 0) : full;
  return dot(along, Space(on_b - on_a));
}

}  // namespace

SolverAnswer solve_by_directions(const BulletPair& pair, void* trace) {
  MinkowskiTrace& found = *static_cast<MinkowskiTrace*>(trace);
  found.overlap = 1e18F;
  for (const auto& [x, y, z] : kDirections) {
    const Space full(x, y, z);
    const Space along = pair.is_flat ? Space(x, y, 0) : full;
    if (!(squared(along) > 0.01)) continue;
    const float overlap = overlap_along(pair, full);
    if (!(overlap < found.overlap)) continue;
    found.overlap = overlap;
    found.direction = along;
  }
  if (found.overlap < 0) return {};
  const float moved = found.overlap + (0.5F + (pair.a.margin + pair.b.margin));
  found.moved = moved;
  BulletPair beside = pair;
  beside.place_a.origin += found.direction * moved;
  found.beside = ask_detector(beside, nullptr, nullptr, 1e18F);
  if (found.beside.normal_of == NormalOf::nobody) return {};
  const Space& on_b = found.beside.on_b;
  return {true, found.direction, on_b - found.direction * (moved - found.beside.distance), on_b};
}

}  // namespace manifuzz::ledger_of
