#include "support/interruption.hpp"

namespace manifuzz::test {
namespace {

/// A script that passes its input on to `answering`, a command of the shell.
std::string script(const TemporaryFolder& folder, int nth, const std::string& answering) {
  const std::string interrupted = "'" + (folder.path() / "interrupted").string() + "'";
  const std::string count = "count() {\n  n=0\n  while [ $n -lt " + std::to_string(nth) +
                            " ] && read -r line; do\n    n=$((n + 1))\n    if [ $n -eq " +
                            std::to_string(nth) + " ] && mkdir " + interrupted +
                            " 2>/dev/null; then kill -INT \"$MANIFUZZ_PROCESS\"; fi\n"
                            "    printf '%s\\n' \"$line\"\n  done\n}\n";
  // mkdir succeeds once, whoever calls it.
  return "sh " + folder.write("interrupting.sh", count + "{ [ -d " + interrupted +
                                                     " ] || count; exec cat; } | " + answering);
}

}  // namespace

Outcome run_interruptible(const std::vector<std::string>& arguments) {
  const std::vector<std::string> shell{"sh", "-c", "export MANIFUZZ_PROCESS=$$; exec \"$0\" \"$@\"",
                                       manifuzz_path()};
  return run_program(with(shell, arguments));
}

std::string interrupting_clip(const TemporaryFolder& folder, int nth) {
  const std::string declaration =
      R"({"declaration": {"name": "clip", "version": "0", "frame": "local"}})";
  return script(
      folder, nth,
      "{ echo '" + declaration + "'; exec '" + manifuzz_path() + "' collide --collider clip; }\n");
}

std::string interrupting_blind(const TemporaryFolder& folder, int nth) {
  return script(folder, nth, "while read -r line; do echo '{\"points\": []}'; done\n");
}

}  // namespace manifuzz::test
