#pragma once

#include <functional>
#include <string>
#include <utility>

#include <catch2/catch.hpp>

namespace manifuzz::test {

/// Registers a test case whose name is made at run time, such as one for each row of a table. To be
/// called before main: `[[maybe_unused]] const bool registered = [] { ...; return true; }();`.
inline void add_test(const std::string& name, const std::string& tags, std::function<void()> body) {
  class Invoker : public Catch::ITestInvoker {
   public:
    explicit Invoker(std::function<void()> body) : body_(std::move(body)) {}
    void invoke() const override { body_(); }

   private:
    std::function<void()> body_;
  };
  const Catch::AutoReg registration(new Invoker(std::move(body)), CATCH_INTERNAL_LINEINFO, "",
                                    {name, tags});
}

}  // namespace manifuzz::test
