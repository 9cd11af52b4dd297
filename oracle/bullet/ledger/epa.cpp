#include "oracle/bullet/ledger/epa.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>

#include "oracle/bullet/ledger/gjk.hpp"

namespace manifuzz::ledger_of {
namespace {

/// EPA_ACCURACY and EPA_PLANE_EPS.
constexpr float kAccuracy = 0.0001F;
constexpr float kPlaneEpsilon = 0.00001F;
constexpr unsigned kFacesMax = 256;
constexpr unsigned kCornersMax = 128;

struct EpaFace {
  Space n{0, 0, 0};
  float d = 0;
  std::array<const EpaCorner*, 3> c{};
  std::array<EpaFace*, 3> f{};
  std::array<unsigned, 3> e{};
  unsigned pass = 0;
  bool is_beside = false;  ///< the origin is not above it: d is not along n
};

/// EPA of btGjkEpa2.cpp.
class Epa {
 public:
  explicit Epa(EpaGjk& gjk) : gjk_(&gjk) {}

  BulletEpaEnd evaluate();

  Space normal{0, 0, 0};
  float depth = 0;
  EpaFace outer;  ///< the face it ends at
  std::array<float, 3> weights{};

 private:
  struct Horizon {
    EpaFace* last = nullptr;
    EpaFace* first = nullptr;
    unsigned count = 0;
  };

  static void bind(EpaFace* a, unsigned edge_a, EpaFace* b, unsigned edge_b) {
    a->e[edge_a] = edge_b;
    a->f[edge_a] = b;
    b->e[edge_b] = edge_a;
    b->f[edge_b] = a;
  }
  EpaFace* add_face(const EpaCorner* a, const EpaCorner* b, const EpaCorner* c, bool is_forced);
  void remove(EpaFace* face) { std::erase(hull_, face); }
  EpaFace* best() const;
  bool expand(unsigned pass, const EpaCorner* w, EpaFace* face, unsigned edge, Horizon& horizon);
  bool make_first_hull();
  BulletEpaEnd grow();
  void weigh();

  EpaGjk* gjk_;
  std::deque<EpaFace> store_;
  std::deque<EpaCorner> corners_;
  std::vector<EpaFace*> hull_;  ///< its root last
};

/// getedgedist: how far the origin is from the edge, where it is beyond it.
std::optional<float> distance_beyond(const EpaFace& face, const Space& a, const Space& b) {
  const Space ba = b - a;
  if (!(dot(a, cross(ba, face.n)) < 0)) return {};
  if (dot(a, ba) > 0) return std::sqrt(squared(a));
  if (dot(b, ba) < 0) return std::sqrt(squared(b));
  const float a_dot_b = dot(a, b);
  const float square = (squared(a) * squared(b) - a_dot_b * a_dot_b) / squared(ba);
  // btMax of what is no number is 0.
  return square > 0 ? std::sqrt(square) : 0;
}

EpaFace* Epa::add_face(const EpaCorner* a, const EpaCorner* b, const EpaCorner* c, bool is_forced) {
  if (hull_.size() >= kFacesMax) return nullptr;
  EpaFace face;
  face.c = {a, b, c};
  face.n = cross(Space(b->w - a->w), Space(c->w - a->w));
  const float length = std::sqrt(squared(face.n));
  if (!(length > kAccuracy)) return nullptr;
  auto beyond = distance_beyond(face, a->w, b->w);
  if (!beyond) beyond = distance_beyond(face, b->w, c->w);
  if (!beyond) beyond = distance_beyond(face, c->w, a->w);
  face.is_beside = beyond.has_value();
  face.d = beyond ? *beyond : dot(a->w, face.n) / length;
  face.n = over(face.n, length);
  if (!is_forced && !(face.d >= -kPlaneEpsilon)) return nullptr;
  hull_.push_back(&store_.emplace_back(face));
  return hull_.back();
}

EpaFace* Epa::best() const {
  EpaFace* least = hull_.back();
  for (auto face = hull_.rbegin(); face != hull_.rend(); ++face) {
    if ((*face)->d * (*face)->d < least->d * least->d) least = *face;
  }
  return least;
}

bool Epa::expand(unsigned pass, const EpaCorner* w, EpaFace* face, unsigned edge,
                 Horizon& horizon) {
  if (face->pass == pass) return false;
  const unsigned after = (edge + 1) % 3;
  if (dot(face->n, w->w) - face->d < -kPlaneEpsilon) {
    EpaFace* const made = add_face(face->c[after], face->c[edge], w, false);
    if (made == nullptr) return false;
    bind(made, 0, face, edge);
    if (horizon.last != nullptr) {
      bind(horizon.last, 1, made, 2);
    } else {
      horizon.first = made;
    }
    horizon.last = made;
    ++horizon.count;
    return true;
  }
  const unsigned before = (edge + 2) % 3;
  face->pass = pass;
  if (!expand(pass, w, face->f[after], face->e[after], horizon) ||
      !expand(pass, w, face->f[before], face->e[before], horizon)) {
    return false;
  }
  remove(face);
  return true;
}

bool Epa::make_first_hull() {
  auto& c = gjk_->simplex.c;
  if (EpaGjk::determinant(c[0].w - c[3].w, c[1].w - c[3].w, c[2].w - c[3].w) < 0) {
    std::swap(c[0], c[1]);
  }
  const std::array faces{add_face(&c[0], &c[1], &c[2], true), add_face(&c[1], &c[0], &c[3], true),
                         add_face(&c[2], &c[1], &c[3], true), add_face(&c[0], &c[2], &c[3], true)};
  if (std::ranges::find(faces, nullptr) != faces.end()) return false;
  bind(faces[0], 0, faces[1], 0);
  bind(faces[0], 1, faces[2], 0);
  bind(faces[0], 2, faces[3], 0);
  bind(faces[1], 1, faces[3], 2);
  bind(faces[1], 2, faces[2], 1);
  bind(faces[2], 2, faces[3], 1);
  return true;
}

BulletEpaEnd Epa::grow() {
  constexpr unsigned iterations_max = 255;
  EpaFace* nearest = best();
  outer = *nearest;
  for (unsigned pass = 1; pass <= iterations_max; ++pass) {
    if (corners_.size() >= kCornersMax) return BulletEpaEnd::out_of_vertices;
    nearest->pass = pass;
    const EpaCorner* const w = &corners_.emplace_back(gjk_->corner_along(nearest->n));
    if (!(dot(nearest->n, w->w) - nearest->d > kAccuracy)) return BulletEpaEnd::accuracy_reached;
    Horizon horizon;
    for (unsigned j = 0; j < 3; ++j) {
      if (!expand(pass, w, nearest->f[j], nearest->e[j], horizon))
        return BulletEpaEnd::invalid_hull;
    }
    if (horizon.count < 3) return BulletEpaEnd::invalid_hull;
    bind(horizon.last, 1, horizon.first, 2);
    remove(nearest);
    nearest = best();
    outer = *nearest;
  }
  return BulletEpaEnd::none;
}

void Epa::weigh() {
  const Space projection = outer.n * outer.d;
  for (unsigned i = 0; i < 3; ++i) {
    const Space& b = outer.c[(i + 1) % 3]->w;
    const Space& c = outer.c[(i + 2) % 3]->w;
    weights[i] = std::sqrt(squared(cross(Space(b - projection), Space(c - projection))));
  }
  const float sum = weights[0] + weights[1] + weights[2];
  for (float& weight : weights) weight /= sum;
}

BulletEpaEnd Epa::evaluate() {
  if (gjk_->simplex.rank <= 1 || !gjk_->enclose_origin() || !make_first_hull()) {
    return BulletEpaEnd::fall_back;
  }
  const BulletEpaEnd end = grow();
  normal = outer.n;
  depth = outer.d;
  weigh();
  return end;
}

/// btGjkEpaSolver2::Penetration.
bool penetrate(const BulletPair& pair, const Space& guess, EpaTrace& trace, SolverAnswer& answer) {
  const EpaDifference difference(pair, true);
  EpaGjk gjk(difference);
  if (gjk.evaluate(Space(-guess)) != EpaGjk::Status::inside) return false;
  trace.is_near = gjk.is_near;
  Epa epa(gjk);
  trace.end = epa.evaluate();
  Space on_a(0, 0, 0);
  if (trace.end == BulletEpaEnd::fall_back) {
    epa.normal = squared(guess) > 0 ? over(guess, std::sqrt(squared(guess))) : Space(1, 0, 0);
    on_a = difference.support_a(gjk.simplex.c[0].d);
  } else {
    for (unsigned i = 0; i < 3; ++i) {
      on_a += difference.support_a(epa.outer.c[i]->d) * epa.weights[i];
    }
  }
  trace.normal = epa.normal;
  trace.depth = epa.depth;
  trace.is_beside_face = epa.outer.is_beside;
  answer = {true, Space(-epa.normal), pair.place_a.to_world(on_a),
            pair.place_a.to_world(Space(on_a - epa.normal * epa.depth))};
  return true;
}

/// btGjkEpaSolver2::Distance.
bool find_distance(const BulletPair& pair, const Space& guess, SolverAnswer& answer) {
  const EpaDifference difference(pair, false);
  EpaGjk gjk(difference);
  if (gjk.evaluate(guess) != EpaGjk::Status::valid) return false;
  Space on_a(0, 0, 0);
  Space on_b(0, 0, 0);
  for (int i = 0; i < gjk.simplex.rank; ++i) {
    const Space& d = gjk.simplex.c[i].d;
    on_a += difference.support_a(d) * gjk.simplex.p[i];
    on_b += difference.support_b(Space(-d)) * gjk.simplex.p[i];
  }
  const Space between = on_a - on_b;
  const float length = std::sqrt(squared(between));
  answer = {false, over(between, length > kAccuracy ? length : 1.0F), pair.place_a.to_world(on_a),
            pair.place_a.to_world(on_b)};
  return true;
}

/// safeNormalize.
Space unit_or_x(const Space& v) {
  constexpr float epsilon = std::numeric_limits<float>::epsilon();
  const float square = squared(v);
  return square >= epsilon * epsilon ? over(v, std::sqrt(square)) : Space(1, 0, 0);
}

}  // namespace

SolverAnswer solve_by_epa(const BulletPair& pair, void* trace) {
  EpaTrace& found = *static_cast<EpaTrace*>(trace);
  const Space between = pair.place_b.origin - pair.place_a.origin;
  const std::array<Space, 9> guesses{unit_or_x(between), unit_or_x(Space(-between)),
                                     Space(0, 0, 1),     Space(0, 1, 0),
                                     Space(1, 0, 0),     Space(1, 1, 0),
                                     Space(1, 1, 1),     Space(0, 1, 1),
                                     Space(1, 0, 1)};
  SolverAnswer answer;
  for (const Space& guess : guesses) {
    if (penetrate(pair, guess, found, answer) || find_distance(pair, guess, answer)) return answer;
  }
  return {};
}

}  // namespace manifuzz::ledger_of
