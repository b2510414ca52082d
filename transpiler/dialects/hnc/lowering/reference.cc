#include "transpiler/dialects/hnc/lowering/reference.h"

#include <utility>

#include "transpiler/dialects/hnc/lowering/lowering.h"
#include "transpiler/dialects/hnc/machine/options.h"
#include "transpiler/dialects/hnc/parser/parser.h"

namespace plcxx::hnc {

ir::Reference MakeReference(dialects::Request& request) {
  CompiledUnit compiled = ParseAndCompile(request);
  if (compiled.bitcode.empty()) return {.reason = "Clang makes no code of it"};
  // What is wrong with the program has been reported when it was translated.
  diag::Engine unheard;
  ir::Reference reference = DescribeLowered(compiled.unit, ReadSettings(request.options), *request.sources, unheard);
  reference.bitcode = std::move(compiled.bitcode);
  reference.compiler = std::move(compiled.compiler);
  return reference;
}

}  // namespace plcxx::hnc
