// What plcxx verify has shown, as a file: for the records of a machine, and for pipelines.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "transpiler/compilation/compilation.h"
#include "transpiler/compile/toolchain.h"
#include "transpiler/emit/output_file.h"
#include "transpiler/prove/verify/bitcode.h"
#include "transpiler/prove/verify/front_end/front_end.h"
#include "transpiler/prove/verify/verify.h"
#include "transpiler/review/verify/facts.h"

namespace plcxx::review::verify {

struct Certificate {
  const compilation::Compilation* compilation = nullptr;
  const std::vector<emit::OutputFile>* files = nullptr;  // the generated code
  const compile::Toolchain* toolchain = nullptr;
  const compile::Target* target = nullptr;
  const prove::verify::Bitcode* bitcode = nullptr;
  std::vector<std::pair<std::string, std::string>> objects;  // names and contents; empty: it was compiled for the proof
  const std::vector<prove::verify::RoutineProof>* proofs = nullptr;
  const FactsReport* facts = nullptr;
  std::vector<std::string> left_out;                                // routines that nobody asked for
  const prove::verify::front_end::Comparison* front_end = nullptr;  // none: it was not looked at
};

/// JSON; the same for the same sources, compiler and plcxx, wherever and whenever it is made.
std::string CertificateText(const Certificate& certificate);

}  // namespace plcxx::review::verify
