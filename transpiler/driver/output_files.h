// Writes the files of one program: all of them or none.
//
// Each file is written beside its place and renamed into it, so that no reader ever sees half a file; a file whose
// bytes did not change is left alone, so that nothing that depends on it is built again. A device or a pipe is written
// to, and a link stays one.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/emit/output_file.h"

namespace plcxx::driver {

struct WriteFailure {
  std::string path;
  std::string reason, remedy;  // lower case, no full stop
};

struct OutputRequest {
  std::string directory;                     // created when missing; empty: the current one
  std::vector<emit::OutputFile> files;       // each with its whole path for a name
  std::vector<std::string> protected_paths;  // files that were read: never overwritten
  /// Of the files those that the command line names: an order to overwrite what is there. Under another name a file
  /// that is not of plcxx's own stays.
  std::vector<std::string> named = {};
};

/// While it lives, WriteAll writes for one of several programs: what another one has written in this run is not
/// overwritten, unless the bytes are the same.
class OutputsOfProgram {
 public:
  explicit OutputsOfProgram(std::string name);
  OutputsOfProgram(const OutputsOfProgram&) = delete;
  OutputsOfProgram& operator=(const OutputsOfProgram&) = delete;
  ~OutputsOfProgram();
};

/// After a failure the directory is as it was before.
std::optional<WriteFailure> WriteAll(const OutputRequest& request);

/// The same with the folders that the files lie in.
std::optional<WriteFailure> WriteWithFolders(const OutputRequest& request);

/// Before the work whose result it shall write: what would fail of it now, tried and undone, in `directory` with the
/// folders above it.
std::optional<WriteFailure> CannotWriteAll(const OutputRequest& request);

/// What can be known before the work whose result it shall get: there is a folder in the way, no folder that may be
/// written to, or what is no file. The folders above it may be missing.
std::optional<WriteFailure> CannotBeWritten(const std::string& path);
/// Of those that are named (the others are empty) the first such; false: told as a usage error. "-" is standard output
/// everywhere, and here it has something else. Two of them are not the same file.
bool CanBeWritten(std::initializer_list<std::string> paths);

/// Tells that as a usage error; its exit code, for commands that end with it.
int CannotWrite(const WriteFailure& failure);

/// Can a file be called so, on every system and without leaving its directory?
bool IsFileName(std::string_view name);

/// `name` below `directory`, as it is opened and as it stands in dependency files.
std::string PathIn(const std::string& directory, const std::string& name);

}  // namespace plcxx::driver
