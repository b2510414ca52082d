// What golden tests are made of: running the tool in a folder, comparing bytes, rewriting what is out of date.
//
// In: files below tests/golden and samples. Out: for each difference one text that shows the first differing line.
// PLCXX_UPDATE_GOLDEN=1 turns differences into rewritten files.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace plcxx::golden {

namespace fs = std::filesystem;

enum class Mode : uint8_t { kCompare, kUpdate };
/// By the environment variable PLCXX_UPDATE_GOLDEN.
Mode ChosenMode();

struct ToolResult {
  int exit_code = -1;
  std::string output;  // standard output
  std::string errors;
};
/// Runs plcxx with `directory` as the current one.
ToolResult RunTool(const fs::path& directory, const std::vector<std::string>& arguments);

std::string ReadFile(const fs::path& path);

/// None when `actual` is what the file holds, or has been written to it; else the first differing line of both.
std::optional<std::string> CheckFile(const fs::path& file, std::string_view actual, Mode mode);

/// The files below a directory whose name ends so, sorted. Empty when there is no such directory.
std::vector<fs::path> FilesBelow(const fs::path& directory, std::string_view ending);

/// A printed phase that is kept beside its program: `orb.plc.ir`, `orb.plc.cc`.
struct PhaseGolden {
  fs::path file;
  std::string phase;   // "ir", "cpp": what `plcxx print` calls it; "debug": what `plcxx emit --debug` writes
  fs::path scenario;   // names the program's sources and options; empty: the program is one file
  std::string source;  // "orb.plc"
};
/// All below a directory. The suffix names the phase; `.cc` is phase cpp, `.debug` the C++ of the debug flavour.
std::vector<PhaseGolden> PhaseGoldens(const fs::path& directory);
/// Where a folder's languages (the folders in it) have fewer than `least` programs whose syntax, IR and C++ are kept:
/// goldens that nobody has compare nothing. A language that is being built is asked for them once it has so many cases.
std::vector<std::string> MissingPhases(const fs::path& directory, size_t least);
/// None when the printed phase is as kept.
std::optional<std::string> CheckPhase(const PhaseGolden& golden, Mode mode);

/// Compares what `plcxx emit` writes for a sample machine with its folder `generated`, every file in both directions.
/// The program is that of the machine's first scenario, and is named by its first source.
std::vector<std::string> CheckSample(const fs::path& machine, Mode mode);

}  // namespace plcxx::golden
