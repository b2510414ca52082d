// What is known of a project's variables, for the pages and editors that show them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "transpiler/dialects/classicladder/classicladder.h"

namespace plcxx::classicladder {
namespace {

using testing::UnorderedElementsAre;

/// "I0 START: the key" of each variable that is documented.
std::vector<std::string> DocumentedOf(const std::string& symbols) {
  source::SourceManager sources;
  diag::Engine diagnostics;
  dialects::Request request;
  request.sources = &sources;
  request.diagnostics = &diagnostics;
  request.files.push_back(
      sources.AddText("a.clp",
                      "_FILES_CLASSICLADDER\n_FILE-sections.csv\n000,0,-1,0,0,0\n_/FILE-sections.csv\n"
                      "_FILE-symbols.csv\n#VER=1.0\n" +
                          symbols +
                          "_/FILE-symbols.csv\n_FILE-rung_0.csv\n1-0-50/0 , 50-0-60/0\n_/FILE-rung_0.csv\n"
                          "_/FILES_CLASSICLADDER\n"));
  const dialects::Lowered lowered = kClassicladder.lower(request);
  EXPECT_FALSE(diagnostics.HasErrors());
  std::vector<std::string> documented;
  for (const ir::Documentation& known : lowered.program.documentation) {
    std::string line = known.address + " " + known.symbols;
    if (!known.meaning.empty()) line += ": " + known.meaning;
    documented.push_back(line);
  }
  return documented;
}

TEST(ClassicladderDocumentation, OfWhatIsUsedAndOfWhatHasASymbol) {
  EXPECT_THAT(DocumentedOf(""), UnorderedElementsAre("I0 ", "Q0 "));
  EXPECT_THAT(DocumentedOf("%I0,START,the key\n%B7,SPARE,for later\n"),
              UnorderedElementsAre("I0 START: the key", "Q0 ", "B7 SPARE: for later"));
}

TEST(ClassicladderDocumentation, ASymbolOfABlockNamesItsVariables) {
  EXPECT_THAT(DocumentedOf("%C1,PARTS,\n"), UnorderedElementsAre("I0 ", "Q0 ", "C1.D PARTS.D", "C1.E PARTS.E",
                                                                 "C1.F PARTS.F", "C1.P PARTS.P", "C1.V PARTS.V"));
}

}  // namespace
}  // namespace plcxx::classicladder
