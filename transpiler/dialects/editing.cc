#include "transpiler/dialects/editing.h"

#include <utility>

#include "transpiler/dialects/classicladder/classicladder.h"
#include "transpiler/dialects/classicladder/control/editing.h"
#include "transpiler/dialects/hnc/control/editing.h"
#include "transpiler/dialects/hnc/hnc.h"
#include "transpiler/dialects/host50/control/editing.h"
#include "transpiler/dialects/host50/host50.h"
#include "transpiler/dialects/nc110/control/editing.h"
#include "transpiler/dialects/nc110/nc110.h"
#include "transpiler/dialects/prostep/control/editing.h"
#include "transpiler/dialects/prostep/prostep.h"
#include "transpiler/dialects/technol/control/editing.h"
#include "transpiler/dialects/technol/technol.h"
#include "transpiler/support/check.h"

namespace plcxx::dialects {

const Editing& EditingOf(const Dialect& dialect) {
  const std::pair<const Dialect*, const Editing*> rows[] = {{&classicladder::kClassicladder, &classicladder::kEditing},
                                                            {&hnc::kHnc, &hnc::kEditing},
                                                            {&host50::kHost50, &host50::kEditing},
                                                            {&nc110::kNc110, &nc110::kEditing},
                                                            {&prostep::kProstep, &prostep::kEditing},
                                                            {&technol::kTechnol, &technol::kEditing}};
  for (const auto& [of, editing] : rows) {
    if (of == &dialect) return *editing;
  }
  PLCXX_UNREACHABLE();
}

}  // namespace plcxx::dialects
