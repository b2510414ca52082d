#include "transpiler/dialects/classicladder/classicladder.h"
#include "transpiler/dialects/dialect.h"
#include "transpiler/dialects/hnc/hnc.h"
#include "transpiler/dialects/host50/host50.h"
#include "transpiler/dialects/nc110/nc110.h"
#include "transpiler/dialects/prostep/prostep.h"
#include "transpiler/dialects/technol/technol.h"

namespace plcxx::dialects {
namespace {

const Dialect* const kAll[] = {&classicladder::kClassicladder,
                               &hnc::kHnc,
                               &host50::kHost50,
                               &nc110::kNc110,
                               &prostep::kProstep,
                               &technol::kTechnol};

}  // namespace

std::span<const Dialect* const> AllDialects() { return kAll; }

const Dialect* DialectByName(std::string_view name) {
  for (const Dialect* dialect : kAll) {
    if (dialect->name == name) return dialect;
  }
  return nullptr;
}

}  // namespace plcxx::dialects
