// The include table (layers.txt), the check of a tree against it, and the drawing of it in CONTRIBUTING.md.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/policy/repository.h"

namespace plcxx::policy {

struct LayerRow {
  std::string folder;                    // or one file; '*' stands for one name
  std::vector<std::string> may_include;  // folders
};

struct LibraryRow {
  std::string name;
  std::vector<std::string> headers;  // prefixes
  std::vector<std::string> folders;  // that may include them
};

/// The folders in a folder, each of which may include those before it.
struct RoomsRow {
  std::string folder;                                           // '*' stands for one name
  std::vector<std::string> rooms;                               // from the lowest up
  std::vector<std::pair<std::string, std::string>> exceptions;  // a file and a higher room that it may include
};

struct LayerTable {
  std::vector<LayerRow> layers;
  std::vector<LibraryRow> libraries;
  std::vector<RoomsRow> rooms;
};

/// Lines that cannot be read, and rows that name a folder without a row, are in `findings`.
LayerTable ReadLayers(std::string_view text, Findings& findings);

/// Every #include below transpiler/ and runtime_support/ of `root`, and every DEPENDS of its CMakeLists.txt.
Findings CheckLayers(const LayerTable& table, const std::string& root);

/// The layers from the top down; a folder that `root` does not have yet is marked with '*'.
std::string DrawLayers(const LayerTable& table, const std::string& root);

}  // namespace plcxx::policy
