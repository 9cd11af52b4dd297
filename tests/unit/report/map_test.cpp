#include <cairo.h>
#include <cstdlib>
#include <memory>
#include <string_view>

#include <catch2/catch.hpp>

#include "campaign/in_child.hpp"
#include "corpus/corpus.hpp"
#include "report/picture/pictures.hpp"
#include "report/words.hpp"
#include "support/source_tree.hpp"
#include "unit/report/sample.hpp"

using namespace manifuzz;
using namespace manifuzz::test;
using Catch::Contains;

namespace {

/// What `clip` becomes with other answers.
Collider changed(const std::function<Answer(const PairCase&)>& collide) {
  Collider collider = find_collider("clip");
  collider.declaration.name = "changed";
  collider.collide = collide;
  return collider;
}

Answer no_contact(const PairCase&) {
  return Manifold<double>();
}

/// B's corner at (0.5, 0.5) is the one that is moved here.
bool is_moved_right(const PairCase& pair) {
  return pair.b.polygon.vertices[2].x() > 0.5F;
}

struct Map {
  JudgedCase judged;
  Neighbourhood neighbourhood;

  double severity() const {
    return manifuzz::severity(neighbourhood, judged.judgement.bucket).share();
  }
  std::string words() const { return severity_in_words(judged, neighbourhood); }
};

Map map_of(const PairCase& pair, const Collider& subject, const Collider& oracle,
           int cells_max = 1 << 20) {
  Interruption interruption;
  Map map;
  map.judged.given.any = pair;
  map.judged.subject.declaration = subject.declaration;
  map.judged.oracle.declaration = oracle.declaration;
  map.judged.judgement = judge_in_child(pair, subject, oracle, interruption);
  map.neighbourhood = ask_neighbourhood(pair, subject, oracle, grid_around(exact::Truth(pair)),
                                        cells_max, interruption);
  return map;
}

/// A PNG as pixels.
class Image {
 public:
  explicit Image(std::string png) : png_(std::move(png)) {
    surface_.reset(cairo_image_surface_create_from_png_stream(read, this));
    REQUIRE(cairo_surface_status(surface_.get()) == CAIRO_STATUS_SUCCESS);
  }
  int width() const { return cairo_image_surface_get_width(surface_.get()); }
  int height() const { return cairo_image_surface_get_height(surface_.get()); }
  std::uint32_t at(int x, int y) const {
    const unsigned char* const row =
        cairo_image_surface_get_data(surface_.get()) +
        std::ptrdiff_t{y} * cairo_image_surface_get_stride(surface_.get());
    return reinterpret_cast<const std::uint32_t*>(row)[x] & 0xffffffU;
  }

 private:
  static cairo_status_t read(void* image, unsigned char* to, unsigned int length) {
    auto& [png, position, surface] = *static_cast<Image*>(image);
    if (png.size() - position < length) return CAIRO_STATUS_READ_ERROR;
    png.copy(reinterpret_cast<char*>(to), length, position);
    position += length;
    return CAIRO_STATUS_SUCCESS;
  }
  struct Destroy {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  };

  std::string png_;
  std::size_t position_ = 0;
  std::unique_ptr<cairo_surface_t, Destroy> surface_;
};

}  // namespace

TEST_CASE("a collider that is always wrong has a severity of 1") {
  const Map map = map_of(box_on_box(0.25F), changed(no_contact), find_collider("clip"));
  CHECK(map.judged.judgement.bucket.verdict == Verdict::subject_wrong);
  CHECK(map.severity() == 1);
  CHECK(map.words() == "severity 1: changed is wrong on 16641 of 16641 neighbours");
}

TEST_CASE("a collider against itself has a severity of 0") {
  const Collider clip = find_collider("clip");
  for (const char* regime : {"generic", "grid", "tied_faces", "sliver", "touching"}) {
    CAPTURE(regime);
    const PairCase pair = generate(1, *find_regime(regime), 0, {});
    CHECK(map_of(pair, clip, clip).severity() == 0);
  }
}

TEST_CASE("the severity is the share of the neighbours, and a sample comes near it") {
  const Collider clip = find_collider("clip");
  const Collider half_wrong = changed([&](const PairCase& pair) {
    return is_moved_right(pair) ? Answer(Manifold<double>()) : clip.collide(pair);
  });
  PairCase pair = box_on_box(0.25F);
  pair.b.polygon.vertices[2].x() = std::nextafter(0.5F, 1.0F);
  const Map map = map_of(pair, half_wrong, clip);
  CHECK(severity(map.neighbourhood, map.judged.judgement.bucket).failing == 129 * 65);
  CHECK(map_of(pair, half_wrong, clip, 1000).severity() == Approx(map.severity()).margin(0.02));
}

TEST_CASE("a neighbour on which a collider dies is lost, and the others are judged") {
  const Collider clip = find_collider("clip");
  const Collider dies_on_some = changed([&](const PairCase& pair) -> Answer {
    if (pair.b.polygon.vertices[2].x() > 0.5F && pair.b.polygon.vertices[2].y() == 0.5F) {
      std::_Exit(1);
    }
    return clip.collide(pair);
  });
  const Map map = map_of(box_on_box(0.25F), dies_on_some, clip);
  int lost = 0;
  for (const Cell& cell : map.neighbourhood.cells) {
    CHECK(cell.state == Cell::State::judged);
    if (cell.bucket.verdict != Verdict::crashed) continue;
    ++lost;
    CHECK(cell.bucket.fault == Fault::subject);
    CHECK(cell.truth.kind == ContactSummary::Kind::contact);
  }
  CHECK(lost == 64);
}

TEST_CASE("where a collider always dies, some neighbours are asked and the rest is left") {
  const Collider dies = changed([](const PairCase&) -> Answer { std::_Exit(1); });
  const Map map = map_of(box_on_box(0.25F), dies, find_collider("clip"), 1000);
  CHECK(map.severity() == 1);
  CHECK_THAT(map.words(), Contains(" 16610 were not asked"));
  CHECK(map.neighbourhood.cells[129 * 129 / 2].bucket.verdict == Verdict::crashed);
}

TEST_CASE("the map is a PNG with four panels of their own colours") {
  const Map map = map_of(box_on_box(0.25F), changed(no_contact), find_collider("clip"));
  const std::string png = map_png(map.judged, map.neighbourhood);
  CHECK(png.substr(0, 8) == "\x89PNG\r\n\x1a\n");
  CHECK(png == map_png(map.judged, map.neighbourhood));
  const Image image(png);
  const int panel = 3 * map.neighbourhood.grid.side();
  REQUIRE(image.width() >= 4 * panel);
  REQUIRE(image.height() >= panel);
  // Beside the ring, at the same height in each panel.
  const auto colour_in = [&](int i) { return image.at(28 + i * (panel + 24) + 40, 300); };
  CHECK(colour_in(0) == 0xdfe3e8);  // nothing is said
  CHECK(colour_in(1) == colour_in(2));
  CHECK(colour_in(0) != colour_in(1));
  CHECK(colour_in(3) == 0xd55e00);  // the subject is wrong
}

TEST_CASE("every known defect has a map", "[longer]") {
  const std::filesystem::path folder = source_dir() / "corpus" / "defects" / "box2d";
  const Collider subject = find_collider("clip");
  const Collider oracle = find_collider("box2d");
  const Corpus corpus = read_corpus({&folder, 1});
  CHECK(corpus.cases.size() > 5);
  for (const CorpusCase& known : corpus.cases) {
    CAPTURE(known.path);
    Map map = map_of(known.pair(), subject, oracle, 100);
    map.judged.given = known;
    CHECK(Image(map_png(map.judged, map.neighbourhood)).width() > 1000);
    CHECK(map.severity() > 0);
  }
}
