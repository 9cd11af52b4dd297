#include "support/interruption.hpp"

namespace manifuzz::test {
namespace {

/// A script that passes its input on to `answering`, a pipe's end of shell.
std::string script(const TemporaryFolder& folder, int nth, const std::string& answering) {
  // mkdir succeeds once, whoever calls it.
  return "sh " +
         folder.write("interrupting.sh",
                      "n=0\nwhile read -r line; do\n  n=$((n + 1))\n  if [ $n -eq " +
                          std::to_string(nth) + " ] && mkdir '" +
                          (folder.path() / "interrupted").string() +
                          "' 2>/dev/null; then kill -INT \"$MANIFUZZ_PROCESS\"; fi\n" + answering);
}

}  // namespace

Outcome run_interruptible(std::vector<std::string> arguments) {
  const std::vector<std::string> shell{"sh", "-c", "export MANIFUZZ_PROCESS=$$; exec \"$0\" \"$@\"",
                                       manifuzz_path()};
  arguments.insert(arguments.begin(), shell.begin(), shell.end());
  return run_program(arguments);
}

std::string interrupting_clip(const TemporaryFolder& folder, int nth) {
  const std::string declaration =
      R"('{"declaration": {"name": "clip", "version": "0", "frame": "local"}}')";
  return script(folder, nth,
                "  printf '%s\\n' \"$line\"\ndone | {\n  echo " + declaration + "\n  exec '" +
                    manifuzz_path() + "' collide --collider clip\n}\n");
}

std::string interrupting_blind(const TemporaryFolder& folder, int nth) {
  return script(folder, nth, "  echo '{\"points\": []}'\ndone\n");
}

}  // namespace manifuzz::test
