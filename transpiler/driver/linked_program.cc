#include "transpiler/driver/linked_program.h"

#include <string_view>

#include "transpiler/driver/identity_of.h"
#include "transpiler/emit/legalize/legalize.h"
#include "transpiler/emit/print/print.h"
#include "transpiler/identity/identity.h"

namespace plcxx::driver {
namespace {

/// The first thing in which they differ: who knows the cause does not need the rest.
std::string DifferenceOf(const identity::Identity& there, const identity::Identity& here) {
  const auto differ = [](const char* what, const std::string& a, const std::string& b) {
    return std::string(what) + ": " + a + " there, " + b + " here";
  };
  if (there.version != here.version)
    return differ("another plcxx", identity::VersionText(there), identity::VersionText(here));
  if (there.sources != here.sources) return differ("other sources", there.sources, here.sources);
  if (there.options != here.options) return differ("other options", there.options, here.options);
  if (there.program != here.program) return differ("another name", there.program, here.program);
  return differ("other C++ of the same sources (options of emit)", there.generated, here.generated);
}

}  // namespace

debug_link::LinkedProgram MatchProgram(const compilation::Compilation& compilation,
                                       const std::vector<uint8_t>& identity) {
  const std::vector<identity::Identity> found =
      identity::FindIdentities(std::string_view(reinterpret_cast<const char*>(identity.data()), identity.size()));
  if (found.empty()) return {.difference = "it says no program", .layout = {}, .length = {}};
  debug_link::LinkedProgram linked;
  for (const emit::Flavour flavour : {emit::Flavour::kRelease, emit::Flavour::kDebug}) {
    for (const bool simulated : {false, true}) {
      const emit::Emittable emittable = emit::legalize::Legalize(
          compilation.program, {.name = compilation.name, .flavour = flavour, .simulated = simulated});
      const identity::Identity here = IdentityOf(compilation, emit::print::PrintCpp(emittable, *compilation.sources));
      const auto bytes = identity::BytesOf(here);
      if (std::vector<uint8_t>(bytes.begin(), bytes.end()) == identity) {
        return {.difference = {},
                .layout = emittable.layout,
                .length = flavour == emit::Flavour::kDebug ? debug_link::Target::Length::kLonger
                                                           : debug_link::Target::Length::kExact};
      }
      if (linked.difference.empty()) linked.difference = DifferenceOf(found.front(), here);
    }
  }
  return linked;
}

}  // namespace plcxx::driver
