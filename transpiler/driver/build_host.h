// What `plcxx build --host` builds beside the program: the host's files, and one period of the host that is audited as
// the program is.
#pragma once

#include <string>
#include <vector>

#include "transpiler/compilation/compilation.h"
#include "transpiler/compile/compile_library.h"
#include "transpiler/compile/toolchain.h"
#include "transpiler/emit/emittable.h"
#include "transpiler/emit/output_file.h"
#include "transpiler/host/host.h"

namespace plcxx::driver {

/// In words, what has to be installed for it; empty: all is there.
std::string MissingForHost(host::Kind kind);

/// Adds the host's files with the headers that they include to `files`, and what compiling them needs to the command of
/// `toolchain`. Pins that cannot be are reported.
void AddHostFiles(host::Kind kind, const emit::Emittable& emittable, compile::Toolchain& toolchain,
                  std::vector<emit::OutputFile>& files, compilation::Compilation& compilation);

/// The object of the host's own source, which has code that may wait; the others are the program's and its pins'.
std::string HostObject(host::Kind kind, const std::string& program);

/// Reports what one period of the host must not do. `objects`: bytes of all objects.
void AuditHost(host::Kind kind, const std::vector<std::string>& objects, const compile::Target& target,
               const emit::Emittable& emittable, compilation::Compilation& compilation);

/// "fan.so", a module for LinuxCNC's loadrt, in the directory of the objects. What the linker refuses is reported.
void LinkModule(const compile::Toolchain& toolchain, const compile::Library& library, const std::string& directory,
                std::vector<emit::OutputFile>& files, compilation::Compilation& compilation);

/// Takes the headers out of `files` and writes them into `directory`/plcxx_host: they are the same for each program.
void WriteHostHeaders(const std::string& directory, std::vector<emit::OutputFile>& files,
                      compilation::Compilation& compilation);

}  // namespace plcxx::driver
