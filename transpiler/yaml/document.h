// A text as one YAML document, or why it is none.
//
// In: text of unknown origin. Out: the tree. Not its job: what keys mean (reader.h, and who derives from it).
#pragma once

#include <yaml-cpp/yaml.h>

#include <string>
#include <string_view>
#include <variant>

#include "transpiler/yaml/place.h"

namespace plcxx::yaml {

struct Fault {
  Place mark;
  std::string message;
};

/// A document without anything in it is a null node.
std::variant<YAML::Node, Fault> Load(const std::string& text);

/// The bytes of a file that `what` is read from ("scenario"), at most `most` of them; or why not.
std::variant<std::string, Fault> ReadText(const std::string& path, size_t most, std::string_view what);

}  // namespace plcxx::yaml
