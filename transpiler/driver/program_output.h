// What emit and build share of writing the files of a program.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "transpiler/compilation/compilation.h"
#include "transpiler/driver/common_options.h"
#include "transpiler/driver/output_files.h"

namespace plcxx::driver {

/// What -o names, in every command: '-' is standard output, a name with an extension is a file, anything else a folder;
/// so is what is one already, or ends with '/'.
enum class OutputKind : uint8_t { kFolder, kFile, kStandardOutput };
OutputKind KindOfOutput(const std::string& path);

/// Does the command make one file, which -o may name?
enum class OneFile : uint8_t { kNo, kYes };

struct OutputOptions {
  std::string name;             // of the program and its files; empty: from the first logic source
  std::string directory;        // or file, or '-'; empty: the current one
  std::string dependency_file;  // empty: none
  OneFile one_file = OneFile::kNo;
};

/// --name, -o, --depfile.
void AddOutputOptions(CLI::App& command, OutputOptions& options);

/// MakeRequest with the name among the options; none when that cannot name files, either.
std::optional<compilation::CompilationRequest> MakeNamedRequest(const CommonOptions& common,
                                                                const OutputOptions& options);

/// The files that were read, the project's first: no output may overwrite them.
std::vector<std::string> PathsRead(const compilation::Compilation& compilation, const CommonOptions& common);

/// With the code that the dialect's specification fixes for it, where it fixes one.
void ReportCannotWrite(const WriteFailure& failure, compilation::Compilation& compilation);

}  // namespace plcxx::driver
