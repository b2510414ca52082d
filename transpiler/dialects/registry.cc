#include "transpiler/dialects/dialect.h"
#include "transpiler/dialects/nc110/nc110.h"

namespace plcxx::dialects {
namespace {

const Dialect* const kAll[] = {&nc110::kNc110};

}  // namespace

std::span<const Dialect* const> AllDialects() { return kAll; }

const Dialect* DialectByName(std::string_view name) {
  for (const Dialect* dialect : kAll) {
    if (dialect->name == name) return dialect;
  }
  return nullptr;
}

}  // namespace plcxx::dialects
