// What is printed, as a text: for a file, or for a value that several programs share.
#pragma once

#include <iostream>
#include <sstream>
#include <streambuf>
#include <string>

namespace plcxx::driver {

/// Keeps what is printed to standard output while it lives.
class GatheredOutput {
 public:
  explicit GatheredOutput(bool gathers) : before_(gathers ? std::cout.rdbuf(text_.rdbuf()) : nullptr) {}
  GatheredOutput(const GatheredOutput&) = delete;
  GatheredOutput& operator=(const GatheredOutput&) = delete;
  ~GatheredOutput() {
    if (before_ != nullptr) std::cout.rdbuf(before_);
  }
  std::string text() const { return text_.str(); }

 private:
  std::ostringstream text_;
  std::streambuf* before_;
};

}  // namespace plcxx::driver
