#include "process/interruption.hpp"

#include <catch2/catch.hpp>

using namespace manifuzz;
using State = Interruption::State;

namespace {

std::chrono::steady_clock::time_point now() {
  return std::chrono::steady_clock::now();
}

}  // namespace

TEST_CASE("each signal leads to the next state") {
  Interruption interruption;
  CHECK(interruption.state() == State::running);
  raise(SIGINT);
  CHECK(interruption.state() == State::hurried);
  raise(SIGTERM);
  CHECK(interruption.state() == State::stopped);
  raise(SIGINT);
  CHECK(interruption.is_stopped());
}

TEST_CASE("work that begins hurried is stopped by one signal") {
  Interruption interruption(kUntilSignal);
  CHECK_FALSE(interruption.is_stopped());
  raise(SIGINT);
  CHECK(interruption.is_stopped());
}

TEST_CASE("one around another counts its signals, and the one within those from its beginning on") {
  Interruption all;
  raise(SIGINT);
  {
    Interruption within;
    CHECK(within.state() == State::running);
    raise(SIGINT);
    CHECK(within.state() == State::hurried);
  }
  CHECK(all.state() == State::stopped);
}

TEST_CASE("a deadline leads to its state, whatever the signals") {
  Interruption late({.hurried_at = now() + std::chrono::hours(1)});
  CHECK(late.state() == State::running);
  Interruption hurried({.hurried_at = now()});
  CHECK(hurried.state() == State::hurried);
  raise(SIGINT);
  CHECK(hurried.state() == State::hurried);
  raise(SIGINT);
  CHECK(hurried.state() == State::stopped);
  Interruption stopped({.hurried_at = now(), .stopped_at = now()});
  CHECK(stopped.is_stopped());
}

TEST_CASE("a wait ends with a signal or a deadline") {
  Interruption interruption({.hurried_at = now() + std::chrono::milliseconds(1)});
  interruption.wait(1e6);
  CHECK(interruption.state() == State::hurried);
  raise(SIGINT);
  interruption.wait(1e6);
  raise(SIGTERM);
  CHECK(interruption.is_stopped());
}

TEST_CASE("what the next signal is to stop keeps its deadline") {
  Interruption interruption({.stopped_at = now()});
  Interruption next(interruption.until_signal());
  CHECK(next.is_stopped());
}

TEST_CASE("a lost terminal is a signal as the others") {
  Interruption interruption;
  raise(SIGHUP);
  CHECK(interruption.state() == State::hurried);
  CHECK_FALSE(interruption.is_called_off());
  raise(SIGHUP);
  CHECK(interruption.is_called_off());
}

TEST_CASE("work that follows another's second signal is called off") {
  CHECK(Interruption({.begins = State::stopped}).is_called_off());
  Interruption hurried({.begins = State::hurried});
  CHECK_FALSE(hurried.is_called_off());
  raise(SIGTERM);
  CHECK(hurried.is_called_off());
}
