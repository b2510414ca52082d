// Where words are in a YAML file, and what is wrong with it there.
#pragma once

#include <cstdint>
#include <string>

namespace plcxx::yaml {

/// 1-based; line 0: the file as a whole.
struct Place {
  uint32_t line = 0;
  uint32_t column = 0;
};

struct MarkedText {
  std::string text;
  Place mark;
};

struct Error {
  std::string path;
  Place mark;
  std::string message;
  std::string remedy = {};  // empty: the message says it
};

/// "turret.yaml:3:7: message", the remedy in a line of its own; safe for a terminal.
std::string ToText(const Error& error);

}  // namespace plcxx::yaml
