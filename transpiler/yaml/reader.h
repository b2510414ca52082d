// Typed access to a YAML tree that collects errors with their places: the base of readers of files.
#pragma once

#include <yaml-cpp/yaml.h>

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "transpiler/yaml/place.h"

namespace plcxx::yaml {

/// One `key: value` of a YAML map.
struct Entry {
  MarkedText key;
  YAML::Node value;
};

class Reader {
 public:
  /// An alias repeats what its anchor marks, so that a short file may hold very many words.
  static constexpr size_t kAnyNumber = ~size_t{0};

  explicit Reader(std::string path, size_t most_words = kAnyNumber) : path_(std::move(path)), words_left_(most_words) {}

  const std::string& path() const { return path_; }
  std::vector<Error>& errors() { return errors_; }
  void Fail(Place mark, std::string message, std::string remedy = {});

  static Place Mark(const YAML::Node& node);

  /// The entries of a map, each key once; reports anything else. `what` names the node in messages.
  std::vector<Entry> Map(const YAML::Node& node, std::string_view what);
  /// The elements of a list, or the node itself when it is none.
  static std::vector<YAML::Node> ListOrSingle(const YAML::Node& node);
  std::optional<MarkedText> Word(const YAML::Node& node, std::string_view what);
  std::optional<uint32_t> Number(const YAML::Node& node, std::string_view what);
  std::vector<MarkedText> MarkedWords(const YAML::Node& node, std::string_view what);
  std::vector<std::string> Words(const YAML::Node& node, std::string_view what);
  /// "'dialct' is no key of a scenario; there are: ..."; with the nearest key, where one is near.
  void RefuseKey(const MarkedText& key, std::string_view where, std::span<const std::string_view> known);
  void RefuseKey(const MarkedText& key, std::string_view where, std::initializer_list<std::string_view> known) {
    RefuseKey(key, where, std::span(known.begin(), known.size()));
  }

 private:
  std::string path_;
  size_t words_left_;
  std::vector<Error> errors_;
};

}  // namespace plcxx::yaml
