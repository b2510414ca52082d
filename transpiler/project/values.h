// plcxx.yaml as it is written, its keys known and its words checked one by one: what a Program is made from.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "transpiler/project/keys.h"
#include "transpiler/yaml/reader.h"

namespace plcxx::project {

struct NamedValue;

/// Words of a list, or entries of a map; `programs` is a list of maps, entries without names.
struct Value {
  yaml::Place mark;
  std::vector<yaml::MarkedText> words;
  std::vector<NamedValue> entries;
};

struct NamedValue {
  yaml::MarkedText name;
  const KeyRow* row = nullptr;  // none: the name is the user's (of an option, a target ...)
  Value value;
};

/// The keys of the whole file; what is wrong is in the reader's errors.
std::vector<NamedValue> ReadKeys(const YAML::Node& root, yaml::Reader& reader);

/// What `own` says comes before `common`; maps are merged name by name.
std::vector<NamedValue> Merged(std::vector<NamedValue> common, const std::vector<NamedValue>& own);

}  // namespace plcxx::project
