# What the scripts of this folder share: sourced, with the build folder as first argument.

build=$(realpath "$1")
source=$(realpath "$(dirname "${BASH_SOURCE[0]}")/../..")
folder=$(mktemp --directory)
trap 'rm -rf "$folder"' EXIT

# Objects are the same wherever the temporary folder lies; those with precompiled headers are kept too.
export CCACHE_BASEDIR=$folder CCACHE_NOHASHDIR=1 CCACHE_SLOPPINESS=pch_defines,time_macros
ccache=()
if command -v ccache >/dev/null; then ccache=(-D CMAKE_CXX_COMPILER_LAUNCHER=ccache); fi

fail() {
  echo "tests/install: $*" >&2
  exit 1
}

# of_build NAME: a variable of the build's cache.
of_build() {
  sed -n "s/^$1:[A-Z]*=//p" "$build/CMakeCache.txt"
}

# quietly COMMAND...: with what it prints only where it fails.
quietly() {
  "$source/scripts/quietly" "$@"
}

# configure SOURCE BUILD OPTION...
configure() {
  quietly cmake -S "$1" -B "$2" -G Ninja "${ccache[@]}" "${@:3}"
}
