// Outputs that can always still be moved.
#include "transpiler/prove/properties/check.h"
#include "transpiler/prove/properties/condition.h"
#include "transpiler/prove/properties/cone.h"

namespace plcxx::prove {

PropertyResult PropertyChecker::CheckNeverStuck(const Property&) {
  PropertyResult result;
  result.reason = "not yet";
  return result;
}

}  // namespace plcxx::prove
