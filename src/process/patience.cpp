#include "process/patience.hpp"

#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

namespace manifuzz {
namespace {

constexpr double kMostTimes = 10;

}  // namespace

double seconds_waited(pid_t process) {
  const std::filesystem::path tasks = "/proc/" + std::to_string(process) + "/task";
  std::error_code error;
  double seconds = 0;
  for (std::filesystem::directory_iterator task(tasks, error), end; !error && task != end;
       task.increment(error)) {
    std::ifstream schedule(task->path() / "schedstat");  // ns: running, waiting to run
    double running = 0;
    double waiting = 0;
    if (schedule >> running >> waiting) seconds += waiting * 1e-9;
  }
  return seconds;
}

void Patience::begin(pid_t process) {
  process_ = process;
  began_at_ = Clock::now();
  waited_before_.reset();
}

bool Patience::is_over(double seconds_max) {
  if (!waited_before_) waited_before_ = seconds_waited(process_);
  const double seconds = seconds_since(began_at_);
  if (seconds <= seconds_max) return false;
  return seconds > kMostTimes * seconds_max ||
         seconds - (seconds_waited(process_) - *waited_before_) > seconds_max;
}

}  // namespace manifuzz
