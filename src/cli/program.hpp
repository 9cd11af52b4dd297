#pragma once

namespace manifuzz {

/// The command that the arguments name, as main's; its exit status. Signals end it, and what it has
/// started, within two seconds.
int run_program(int argc, char** argv);

}  // namespace manifuzz
