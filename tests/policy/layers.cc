#include "tests/policy/layers.h"

#include <algorithm>
#include <functional>
#include <map>
#include <optional>

namespace plcxx::policy {
namespace {

std::vector<std::string> SplitAtColons(const std::string& line) {
  std::vector<std::string> parts(1);
  for (const char c : line) {
    if (c == ':') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

/// Does `path` stand below `pattern` (or is it)? '*' matches one name.
bool IsBelow(std::string_view path, std::string_view pattern) {
  while (!pattern.empty()) {
    const std::string_view want = pattern.substr(0, pattern.find('/'));
    const std::string_view have = path.substr(0, path.find('/'));
    if (have.empty() || (want != "*" && want != have)) return false;
    if (want == "*" && have.size() == path.size()) return false;  // a file of the folder itself, not of one below it
    pattern.remove_prefix(std::min(pattern.size(), want.size() + 1));
    path.remove_prefix(std::min(path.size(), have.size() + 1));
  }
  return true;
}

/// The longest row counts; a name beats '*'.
const LayerRow* RowOf(const LayerTable& table, std::string_view path) {
  const LayerRow* best = nullptr;
  for (const LayerRow& row : table.layers) {
    if (!IsBelow(path, row.folder)) continue;
    if (best == nullptr || std::ranges::count(row.folder, '/') > std::ranges::count(best->folder, '/') ||
        (std::ranges::count(row.folder, '/') == std::ranges::count(best->folder, '/') && best->folder.ends_with('*'))) {
      best = &row;
    }
  }
  return best;
}

/// The folder that a '*' row stands for: transpiler/dialects/nc110.
std::string FolderOf(const LayerRow& row, std::string_view path) {
  const auto names = std::ranges::count(row.folder, '/') + 1;
  size_t end = 0;
  for (auto i = names; i > 0 && end != std::string_view::npos; --i) end = path.find('/', end + (i == names ? 0 : 1));
  return std::string(path.substr(0, end));
}

bool IsAllowed(const LayerTable& table, const std::string& from, const std::string& to) {
  const LayerRow* row = RowOf(table, from);
  const LayerRow* target = RowOf(table, to);
  if (row == nullptr || target == nullptr) return false;
  if (row == target) return FolderOf(*row, from) == FolderOf(*target, to);
  return std::ranges::find(row->may_include, target->folder) != row->may_include.end();
}

/// The rooms of the folder that a file is in, and that folder; none for a folder without rooms.
const RoomsRow* RoomsAround(const LayerTable& table, const std::string& file, std::string& folder) {
  const LayerRow* const layer = RowOf(table, file);
  if (layer == nullptr) return nullptr;
  const auto row = std::ranges::find(table.rooms, layer->folder, &RoomsRow::folder);
  if (row == table.rooms.end()) return nullptr;
  folder = FolderOf(*layer, file);
  return &*row;
}

/// The place of the room that a path within the folder is in; the number of rooms for the folder's own files.
std::optional<size_t> RoomOf(const RoomsRow& row, const std::string& inside) {
  const size_t border = inside.find('/');
  if (border == std::string::npos) return row.rooms.size();
  const auto room = std::ranges::find(row.rooms, inside.substr(0, border));
  if (room == row.rooms.end()) return std::nullopt;
  return static_cast<size_t>(room - row.rooms.begin());
}

bool KeepsRooms(const LayerTable& table, const std::string& file, const std::string& header) {
  std::string folder;
  const RoomsRow* const row = RoomsAround(table, file, folder);
  if (row == nullptr || !header.starts_with(folder + "/")) return true;
  const std::string from = file.substr(folder.size() + 1), to = header.substr(folder.size() + 1);
  const std::optional<size_t> from_room = RoomOf(*row, from), to_room = RoomOf(*row, to);
  if (!from_room || !to_room) return false;
  if (*to_room <= *from_room) return true;
  return std::ranges::find(row->exceptions, std::pair(from, to.substr(0, to.find('/')))) != row->exceptions.end();
}

/// Not in a room that its folder's row does not name.
bool IsInARoom(const LayerTable& table, const std::string& file) {
  std::string folder;
  const RoomsRow* const row = RoomsAround(table, file, folder);
  return row == nullptr || RoomOf(*row, file.substr(folder.size() + 1)).has_value();
}

std::optional<std::string> CheckLibrary(const LayerTable& table, const std::string& file, const std::string& header) {
  for (const LibraryRow& library : table.libraries) {
    if (std::ranges::none_of(library.headers, [&](const std::string& prefix) { return header.starts_with(prefix); })) {
      continue;
    }
    if (std::ranges::any_of(library.folders, [&](const std::string& folder) { return IsBelow(file, folder); })) {
      return std::nullopt;
    }
    return "<" + header + "> of " + library.name + " is not for this folder";
  }
  if (header.find('.') == std::string::npos && file.starts_with("transpiler/")) return std::nullopt;
  return "<" + header + "> belongs to no library that this folder may use";
}

/// The header of an #include line with its brackets or quotes; empty for other lines.
std::string IncludeOf(const std::string& line) {
  size_t at = line.find_first_not_of(" \t");
  if (at == std::string::npos || line[at] != '#') return {};
  at = line.find_first_not_of(" \t", at + 1);
  if (at == std::string::npos || line.compare(at, 7, "include") != 0) return {};
  at = line.find_first_of("<\"", at);
  if (at == std::string::npos) return {};
  const size_t end = line.find_first_of(">\"", at + 1);
  return end == std::string::npos ? std::string() : line.substr(at, end + 1 - at);
}

std::optional<std::string> CheckInclude(const LayerTable& table, const std::string& file, const std::string& include) {
  std::string header = include.substr(1, include.size() - 2);
  const bool runtime = header.starts_with("plcxx/") || header.starts_with("plcxx_host/");
  if (include.front() == '<' && !runtime) return CheckLibrary(table, file, header);
  if (runtime) header = "runtime_support/" + header;
  if (IsAllowed(table, file, header) && KeepsRooms(table, file, header)) return std::nullopt;
  return "may not include \"" + header + "\"";
}

/// "sim", "dialects_common" and "prove_verify_facts" are names of CMake targets: a folder, or one in a folder; what is
/// below a row belongs to it.
std::string FolderOfTarget(std::string target) {
  if (target == "runtime") return "runtime_support/plcxx";
  const size_t border = target.find('_');
  if (border != std::string::npos) target[border] = '/';
  if (target.starts_with("prove/verify_")) target[target.find('_')] = '/';
  return "transpiler/" + target;
}

void CheckTargets(const LayerTable& table, const std::string& root, Findings& findings) {
  for (const std::string& file : FilesBelow(root, "transpiler", {"/CMakeLists.txt"})) {
    const std::string folder = file.substr(0, file.rfind('/'));
    size_t number = 0;
    for (const std::string& line : Lines(ReadFile(root + "/" + file))) {
      ++number;
      const size_t depends = line.find("DEPENDS");
      if (!line.starts_with("plcxx_library(") || depends == std::string::npos) continue;
      for (std::string target : Words(line.substr(depends + 7))) {
        if (target == "LIBRARIES") break;
        if (target.ends_with(')')) target.pop_back();
        std::string needed = FolderOfTarget(target);
        if (RowOf(table, needed + "/any.h") == nullptr) needed = "transpiler/dialects/" + target;
        if (!IsAllowed(table, folder + "/any.cc", needed + "/any.h")) {
          findings.push_back(Place(file, number) + "may not depend on " + needed);
        }
      }
    }
  }
}

std::string Short(const std::string& folder) {
  const std::string_view prefix = "transpiler/";
  return folder.starts_with(prefix) ? folder.substr(prefix.size()) : folder;
}

/// By row: 0 for a folder that includes nothing, else one more than the highest of what it may include. Levels above
/// the number of rows mean a circle.
std::vector<size_t> Levels(const LayerTable& table) {
  std::vector<size_t> levels(table.layers.size(), 0);
  for (size_t round = 0; round <= levels.size(); ++round) {
    for (size_t row = 0; row < levels.size(); ++row) {
      const std::vector<std::string>& below = table.layers[row].may_include;
      for (size_t other = 0; other < levels.size(); ++other) {
        if (std::ranges::find(below, table.layers[other].folder) == below.end()) continue;
        levels[row] = std::max(levels[row], levels[other] + 1);
      }
    }
  }
  return levels;
}

std::string LibrariesOf(const LayerTable& table, const LayerRow& row) {
  std::string libraries;
  for (const LibraryRow& library : table.libraries) {
    for (const std::string& folder : library.folders) {
      const bool is_file = folder.ends_with(".cc");
      if (RowOf(table, is_file ? folder : folder + "/any.cc") != &row) continue;
      libraries += (libraries.empty() ? " " : ", ") + library.name;
      if (folder != row.folder) libraries += " (" + Short(folder) + " only)";
    }
  }
  return libraries;
}

/// "; rooms machine < syntax < source".
std::string RoomsIn(const LayerTable& table, const LayerRow& row) {
  std::string text;
  for (const RoomsRow& rooms : table.rooms) {
    if (rooms.folder != row.folder) continue;
    for (const std::string& room : rooms.rooms) text += (text.empty() ? "; rooms " : " < ") + room;
  }
  return text;
}

}  // namespace

LayerTable ReadLayers(std::string_view text, Findings& findings) {
  LayerTable table;
  size_t number = 0;
  for (const std::string& line : Lines(text)) {
    ++number;
    if (line.empty() || line.front() == '#') continue;
    const std::vector<std::string> parts = SplitAtColons(line);
    const std::vector<std::string> head = Words(parts[0]);
    if (parts.size() == 2 && head.size() == 1) {
      table.layers.push_back({head[0], Words(parts[1])});
    } else if (parts.size() == 3 && head.size() == 2 && head[0] == "library") {
      table.libraries.push_back({head[1], Words(parts[1]), Words(parts[2])});
    } else if (parts.size() == 3 && head.size() == 2 && head[0] == "rooms") {
      RoomsRow row{head[1], Words(parts[1]), {}};
      for (const std::string& exception : Words(parts[2])) {
        const size_t border = std::min(exception.find('>'), exception.size() - 1);
        row.exceptions.emplace_back(exception.substr(0, border), exception.substr(border + 1));
      }
      table.rooms.push_back(std::move(row));
    } else {
      findings.push_back(Place("layers.txt", number) + "cannot be read");
    }
  }
  for (const LayerRow& row : table.layers) {
    for (const std::string& folder : row.may_include) {
      if (std::ranges::none_of(table.layers, [&](const LayerRow& other) { return other.folder == folder; })) {
        findings.push_back("layers.txt: " + row.folder + " names " + folder + ", which has no row");
      }
    }
  }
  if (std::ranges::any_of(Levels(table), [&](size_t level) { return level >= table.layers.size(); })) {
    findings.push_back("layers.txt: folders include each other in a circle");
  }
  return table;
}

Findings CheckLayers(const LayerTable& table, const std::string& root) {
  Findings findings;
  for (const char* top : {"transpiler", "runtime_support"}) {
    for (const std::string& file : FilesBelow(root, top, {".cc", ".h", ".def", ".cpp", ".hpp"})) {
      if (RowOf(table, file) == nullptr) findings.push_back(file + ": its folder has no row in layers.txt");
      if (!IsInARoom(table, file)) findings.push_back(file + ": layers.txt has no such room");
      size_t number = 0;
      for (const std::string& line : Lines(ReadFile(root + "/" + file))) {
        ++number;
        const std::string include = IncludeOf(line);
        if (include.empty()) continue;
        if (const auto wrong = CheckInclude(table, file, include)) findings.push_back(Place(file, number) + *wrong);
      }
    }
  }
  CheckTargets(table, root, findings);
  return findings;
}

std::string DrawLayers(const LayerTable& table, const std::string& root) {
  const std::vector<size_t> levels = Levels(table);
  std::map<size_t, std::vector<const LayerRow*>, std::greater<>> rows_of;
  for (size_t i = 0; i < levels.size(); ++i) rows_of[levels[i]].push_back(&table.layers[i]);
  const auto marked = [&root](const std::string& folder) {
    // An empty folder is not in a clone; a file's row is below its folder's.
    const bool there = folder.ends_with('*') || folder.ends_with(".h") || !FilesBelow(root, folder).empty();
    return Short(folder) + (there ? "" : " (later)");
  };

  constexpr size_t kNameWidth = 20;
  std::string drawing;
  for (const auto& [level, rows] : rows_of) {
    for (const LayerRow* row : rows) {
      std::string name = marked(row->folder);
      name.resize(std::max(name.size(), kNameWidth), ' ');
      std::string below;
      for (const std::string& folder : row->may_include) below += " " + Short(folder);
      const std::string libraries = LibrariesOf(table, *row);
      drawing += (row == rows.front() ? " " + std::to_string(level) + " | " : "   | ") + name + " ->" +
                 (below.empty() ? " nothing" : below) + (libraries.empty() ? "" : "; with" + libraries) +
                 RoomsIn(table, *row) + "\n";
    }
    if (level > 0) drawing += "---+" + std::string(kNameWidth + 2, '-') + "\n";
  }
  return drawing;
}

}  // namespace plcxx::policy
