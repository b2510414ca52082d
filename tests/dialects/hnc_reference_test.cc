// What the lowering says of the program for the comparison with Clang's reading of it (ir/reference.h).

#include "transpiler/dialects/hnc/reference.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace plcxx::hnc {
namespace {

using testing::ElementsAre;

// A slot has the number of its handler, counted from 1 in the order of the registrations; 0 is none. Where nothing is
// registered but one handler there is no slot.
TEST(HncReference, AHandlerIsTheNumberThatIsStored) {
  source::SourceManager sources;
  diag::Engine diagnostics;
  dialects::Request request;
  request.sources = &sources;
  request.diagnostics = &diagnostics;
  request.files.push_back(sources.AddText(
      "test.cld",
      "#include \"plc.h\"\nvoid one(int ch) { mod_M_code(ch) = -1; }\nvoid two(int ch) { mod_M_code(ch) = -1; }\n"
      "void init() { plc1_time = 16; plc2_time = 32; if (P[0]) set_mst_func(0, 'M', one);\n"
      "  if (P[1]) set_mst_func(0, 'M', two); if (P[2]) set_mst_func(0, 'M', 0); set_mst_func(1, 'M', two); }\nvoid "
      "plc1() { }\nvoid plc2() { }\n"));
  const ir::Reference reference = MakeReference(request);
  ASSERT_EQ(reference.reason, "");
  std::vector<std::string> stored;
  for (const ir::ReferenceEffect& effect : reference.effects) {
    if (effect.function != "set_mst_func") continue;
    const std::string value = effect.stores_at ? std::to_string(effect.value) : "nothing";
    stored.push_back(effect.arguments[0] + " " + effect.arguments[2] + ": " + value);
  }
  EXPECT_THAT(stored, ElementsAre("0 one: 1", "0 two: 2", "0 0: 0", "1 two: nothing"));
}

}  // namespace
}  // namespace plcxx::hnc
