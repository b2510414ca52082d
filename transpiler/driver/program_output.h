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

/// Can a command write what it makes to standard output, as '-o -'?
enum class StandardOutput : uint8_t { kNo, kYes };

struct OutputOptions {
  std::string name;             // of the program and its files; empty: from the first logic source
  std::string directory;        // empty: the current one
  std::string dependency_file;  // empty: none
  StandardOutput to_standard_output = StandardOutput::kNo;
};

/// --name, -o, --depfile.
void AddOutputOptions(CLI::App& command, OutputOptions& options);

/// MakeRequest with the name among the options; none when that cannot name files, either.
std::optional<compilation::CompilationRequest> MakeNamedRequest(const CommonOptions& common,
                                                                const OutputOptions& options);

/// The files that were read: no output may overwrite them.
std::vector<std::string> PathsRead(const compilation::Compilation& compilation);

/// With the code that the dialect's specification fixes for it, where it fixes one.
void ReportCannotWrite(const WriteFailure& failure, compilation::Compilation& compilation);

}  // namespace plcxx::driver
