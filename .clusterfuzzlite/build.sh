#!/usr/bin/env bash
# What OSS-Fuzz and ClusterFuzzLite run: fuzz targets go to $OUT, by $CXX, $CXXFLAGS and
# $LIB_FUZZING_ENGINE. One for each collider of C or C++ that is named here.
set -euo pipefail

cd "$SRC/manifuzz"
colliders=(scripts/colliders/cpp/clip.cpp)

# The judge is not instrumented, and has the C++ library that its packages were built with: so have
# colliders, which are linked with it.
plain=()
for flag in $CXXFLAGS; do
  case $flag in
    -fsanitize* | -fno-sanitize* | -fprofile* | -fcoverage* | -stdlib=* | -O*) ;;
    *) plain+=("$flag") ;;
  esac
done
cmake -S . -B "$WORK/judge" -G Ninja -D CMAKE_CXX_COMPILER="$CXX" -D CMAKE_CXX_FLAGS="${plain[*]}" \
  -D CMAKE_BUILD_TYPE=Release -D CMAKE_UNITY_BUILD=ON -D CMAKE_UNITY_BUILD_BATCH_SIZE=0 \
  -D MANIFUZZ_HARNESS=OFF -D MANIFUZZ_LIBFUZZER=ON -D MANIFUZZ_INSTALL=OFF
cmake --build "$WORK/judge" --target manifuzz_libfuzzer

# shellcheck disable=SC2016  # the dollar is the linker's
export MANIFUZZ_BUILD=$WORK/judge CXXFLAGS=${CXXFLAGS//-stdlib=libc++/} LDLIBS='-Wl,-rpath,$ORIGIN/lib'
for collider in "${colliders[@]}"; do
  name=$(basename "${collider%.*}")
  scripts/libfuzzer --only-build "$OUT/$name" "$collider"
  printf '[libfuzzer]\nuse_value_profile = 1\n' >"$OUT/$name.options"

  # Where targets run there are no packages.
  mkdir -p "$OUT/lib"
  ldd "$OUT/$name" | awk '$3 ~ /\/lib(fmt|gmp|hwy|stdc\+\+)\./ { print $3 }' | xargs cp --dereference --target-directory "$OUT/lib"

  # Cases that are worth running again are worth to begin with.
  "$OUT/$name" --from corpus "$WORK/seeds-$name" -runs=0
  (cd "$WORK/seeds-$name" && cmake -E tar cf "$OUT/${name}_seed_corpus.zip" --format=zip .)
done
