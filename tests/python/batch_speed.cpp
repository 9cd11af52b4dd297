#include <cstdio>
#include <ctime>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include "kernel/batch.hpp"

// manifuzz_batch_speed FOLDER: what tests/python/batch_speed holds the module's batch against.
// Reads shapes, bodies and pairs as arrays of numpy hold them, writes the manifolds, and then for
// each line of stdin collides all pairs once more and prints how many nanoseconds of the processor
// that took.

using namespace manifuzz;

namespace {

struct Shape {
  Vector2<float> vertices[kMaxVertices];
  float radius;
  std::int32_t count;
  Rounding rounding;
};
static_assert(sizeof(Shape) == 76);

template <class Record>
std::vector<Record> read(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("cannot read " + path);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
  std::vector<Record> records(bytes.size() / sizeof(Record));
  std::copy(bytes.begin(), bytes.end(), reinterpret_cast<char*>(records.data()));
  return records;
}

void write(const std::string& path, const std::vector<Manifold<float>>& manifolds) {
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(manifolds.data()),
             static_cast<std::streamsize>(manifolds.size() * sizeof manifolds[0]));
}

/// The processor's time that this thread has taken: what others take of a busy machine is none of
/// it.
double processor_ns() {
  timespec time;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) * 1e9 + static_cast<double>(time.tv_nsec);
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 2) throw std::runtime_error("one folder is expected");
  const std::string folder = argv[1];
  kernel::Shapes<float> shapes;
  for (const Shape& shape : read<Shape>(folder + "/shapes")) {
    shapes.add(make_polygon<float>({shape.vertices, static_cast<std::size_t>(shape.count)},
                                   shape.radius, shape.rounding));
  }
  const auto bodies = read<kernel::Placement<float>>(folder + "/bodies");
  const auto pairs = read<kernel::BodyPair>(folder + "/pairs");
  std::vector<Manifold<float>> manifolds(pairs.size());
  kernel::collide_pairs(shapes, bodies, pairs, 0, manifolds);
  write(folder + "/manifolds", manifolds);
  while (std::getchar() == '\n') {
    const double begin = processor_ns();
    kernel::collide_pairs(shapes, bodies, pairs, 0, manifolds);
    std::printf("%.0f\n", processor_ns() - begin);
    std::fflush(stdout);
  }
} catch (const std::exception& error) {
  std::fprintf(stderr, "manifuzz_batch_speed: %s\n", error.what());
  return 2;
}
