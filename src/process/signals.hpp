#pragma once

#include <csignal>

namespace manifuzz {

/// The signals by which somebody asks this program to end: SIGINT, SIGTERM, and SIGHUP unless it
/// was started to live on without its terminal.
const sigset_t& ending_signals();

/// Counts those that were held back until now.
void take_ending_signals();
/// Counts one of them that was taken elsewhere.
void count_ending_signal(int signal);
/// How many were counted since this process began.
int ending_signals_taken();

/// From here on, work that such a signal interrupts must be over so many seconds after the first.
void leave_after_signal(double seconds);
/// Whether that time, or this share of it, is over.
bool is_out_of_time(double share = 1);

/// While it lives, these signals end this process as they would if nobody held them back: for code
/// that nothing else can stop.
class EndingSignalsLetThrough {
 public:
  EndingSignalsLetThrough();
  ~EndingSignalsLetThrough();
  EndingSignalsLetThrough& operator=(EndingSignalsLetThrough&&) = delete;  // nor copied

 private:
  sigset_t mask_before_{};
};

/// The exit status of a run that would end with that one, as what interrupted it has it: 130 after
/// SIGINT, 143 after the others; 1, that something was found, stays.
int status_after_signals(int status);
/// The status that a signal alone gives.
int status_of_signal(int signal);

}  // namespace manifuzz
