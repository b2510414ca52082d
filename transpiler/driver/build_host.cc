#include "transpiler/driver/build_host.h"

#include <algorithm>
#include <filesystem>
#include <iostream>

#include "transpiler/compile/child_process.h"
#include "transpiler/compile/runtime_files.h"
#include "transpiler/driver/output_files.h"
#include "transpiler/driver/program_output.h"
#include "transpiler/measure/figures.h"
#include "transpiler/measure/host_audit.h"
#include "transpiler/support/read_file.h"

namespace plcxx::driver {
namespace {

constexpr std::string_view kSystemHeaders = "/usr/include/";
constexpr std::string_view kHeaderFolder = "plcxx_host/";
constexpr int kLinkSeconds = 300;

/// What a host's own source is compiled with, and which of its functions is one period.
struct HostSource {
  std::string_view period;  // in the function's text; all that it reaches is audited
  std::string_view header;  // that is not plcxx's, below /usr/include; empty: none
  std::string_view package;
  std::vector<std::string> flags;
  std::vector<std::string_view> own;  // functions that the machine's builder writes
};

HostSource SourceOf(host::Kind kind) {
  switch (kind) {
    case host::Kind::kOwn:
      break;
    case host::Kind::kPosix:
      return {.period = "plcxx::host::OnePeriod<",
              .header = "",
              .package = "",
              .flags = {},
              .own = {"plcxx::host::io_read", "plcxx::host::io_write"}};
    case host::Kind::kLinuxcnc:
      // As LinuxCNC compiles a component; the module is shared code.
      return {.period = "::Run(void*, long)",
              .header = "linuxcnc/hal.h",
              .package = "linuxcnc-uspace-dev",
              .flags = {"-fPIC", "-isystem", std::string(kSystemHeaders) + "linuxcnc", "-DRTAPI", "-DSIM", "-DUSPACE",
                        "-D__MODULE__"},
              .own = {}};
    case host::Kind::kModbus:
      return {.period = "plcxx::host::OnePeriod<",
              .header = "modbus/modbus.h",
              .package = "libmodbus-dev",
              .flags = {},
              .own = {}};
  }
  return {};
}

}  // namespace

std::string MissingForHost(host::Kind kind) {
  const HostSource source = SourceOf(kind);
  const std::string header = std::string(kSystemHeaders) + std::string(source.header);
  std::error_code error;
  if (source.header.empty() || std::filesystem::exists(header, error)) return "";
  return "this host needs " + header + ", which is not there: install Debian's " + std::string(source.package) +
         ", or write the files with plcxx emit";
}

void AddHostFiles(host::Kind kind, const emit::Emittable& emittable, compile::Toolchain& toolchain,
                  std::vector<emit::OutputFile>& files, compilation::Compilation& compilation) {
  for (emit::OutputFile& file : host::PrintHost(emittable, kind, compilation.diagnostics))
    files.push_back(std::move(file));
  for (const compile::RuntimeFile& file : compile::HostFiles()) files.push_back({file.name, std::string(file.text)});
  for (std::string& flag : SourceOf(kind).flags) toolchain.command.push_back(std::move(flag));
}

std::string HostObject(host::Kind kind, const std::string& program) {
  for (const host::HostRow& row : host::Hosts()) {
    if (row.kind == kind) return program + "_" + std::string(row.text) + ".o";
  }
  return "";
}

void AuditHost(host::Kind kind, const std::vector<std::string>& objects, const compile::Target& target,
               const emit::Emittable& emittable, compilation::Compilation& compilation) {
  const HostSource source = SourceOf(kind);
  const std::optional<compile::ProgramCode> code = measure::ReadObjects(objects, target, compilation);
  if (code) measure::AuditPeriod(*code, source.period, source.own, emittable, compilation);
}

void LinkModule(const compile::Toolchain& toolchain, const compile::Library& library, const std::string& directory,
                std::vector<emit::OutputFile>& files, compilation::Compilation& compilation) {
  const std::string module = compilation.name + ".so";
  std::vector<std::string> command = toolchain.command;
  // Two programs in one process keep their own functions.
  command.insert(command.end(), {"-shared", "-Wl,-Bsymbolic", "-o", module});
  command.insert(command.end(), library.objects.begin(), library.objects.end());
  const compile::ProcessResult result = compile::RunProcess(command, kLinkSeconds, directory);
  if (result.exit_code != 0) {
    std::cerr << result.output;
    compilation.diagnostics.Report({}, diag::CompilerRefuses, module, "it cannot be linked");
    return;
  }
  files.push_back({module, support::ReadFile(std::filesystem::path(directory) / module).value_or("")});
}

void WriteHostHeaders(const std::string& directory, std::vector<emit::OutputFile>& files,
                      compilation::Compilation& compilation) {
  OutputRequest headers;
  headers.directory = PathIn(directory, "plcxx_host");
  for (const emit::OutputFile& file : files) {
    if (file.name.starts_with(kHeaderFolder)) headers.files.push_back({PathIn(directory, file.name), file.text});
  }
  std::erase_if(files, [](const emit::OutputFile& file) { return file.name.starts_with(kHeaderFolder); });
  if (headers.files.empty()) return;
  if (const auto failure = WriteAll(headers)) ReportCannotWrite(*failure, compilation);
}

}  // namespace plcxx::driver
