#include "transpiler/diagnostics/diagnostics.h"
#include "transpiler/diagnostics/host_messages.h"

namespace plcxx::diag {

std::span<const Row> Catalogue() {
#define PLCXX_DIAG(Key, ...) Key.row,
#define PLCXX_DIAG_OFF(Key, ...) Key.row,
  static constexpr Row kRows[] = {
#include "transpiler/diagnostics/catalogue.def"
#include "transpiler/diagnostics/catalogue_host.def"
  };
#undef PLCXX_DIAG
#undef PLCXX_DIAG_OFF
  return kRows;
}

}  // namespace plcxx::diag
