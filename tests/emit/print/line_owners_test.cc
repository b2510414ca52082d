// Whose the lines of a printed file are, and what its locals are called.
#include <gtest/gtest.h>

#include <sstream>

#include "transpiler/emit/legalize/legalize.h"
#include "transpiler/emit/print/print.h"
#include "transpiler/ir/reader.h"

namespace plcxx::emit::print {
namespace {

TEST(LineOwners, EveryStatementHasItsLinesAndNoOthers) {
  const ir::Program program = ir::ReadOrDie(R"(
space m 1 volatile little
place a bit m[0].0
place x bit m[0].1
place y bit m[0].2
statement s1 subject HEAD opens
statement s2 subject INNER
statement s3 subject LAST
routine slow slow {
  body {
    stmt s1
    %0 = load a
    if %0 {
      stmt s2
      %1 = load a
      store x %1
      store a %1
    }
    stmt s3
    %2 = load x
    store y %2
  }
}
)");
  const source::SourceManager sources;
  std::string owned;
  size_t locals = 0;
  for (const OutputFile& file : PrintCpp(legalize::Legalize(program, {.name = "p"}), sources)) {
    locals += file.locals.size();
    std::istringstream text(file.text);
    size_t next = 0;
    ir::StatementId owner;
    std::string line;
    for (uint32_t number = 1; std::getline(text, line); ++number) {
      while (next < file.owners.size() && file.owners[next].line <= number) owner = file.owners[next++].statement;
      if (owner.valid() && !line.empty()) owned += std::to_string(owner.index + 1) + ": " + line + "\n";
    }
  }
  const size_t name = owned.find("const bool t");
  ASSERT_NE(name, std::string::npos) << owned;
  const std::string local = owned.substr(name + 11, owned.find(' ', name + 11) - name - 11);
  EXPECT_EQ(owned, "1:   // HEAD\n1:   if (m[a]) {\n2:     // INNER\n2:     const bool " + local +
                       " = m[a];\n2:     m[x] = " + local + ";\n2:     m[a] = " + local +
                       ";\n1:   }\n3:   // LAST\n3:   m[y] = m[x];\n");
  EXPECT_EQ(locals, 1u);
}

}  // namespace
}  // namespace plcxx::emit::print
