// #line directives, as a compiler reads them: each line of code is its statement's, or the generated file's own.
#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "transpiler/emit/legalize/legalize.h"
#include "transpiler/emit/print/print.h"
#include "transpiler/ir/reader.h"

namespace plcxx::emit::print {
namespace {

/// "lamp.plc:3 m[x] = m[a];" of each line of code, in the file and line that a compiler takes it for.
std::vector<std::string> TakenFor(const OutputFile& file) {
  std::vector<std::string> lines;
  std::istringstream text(file.text);
  std::string name = file.name, line;
  for (uint32_t number = 1; std::getline(text, line); ++number) {
    if (line.starts_with("#line ")) {
      std::istringstream directive(line.substr(6));
      directive >> number >> name;
      name = name.substr(1, name.size() - 2);
      --number;  // of the line that follows
      continue;
    }
    const size_t first = line.find_first_not_of(' ');
    if (first == std::string::npos || line.substr(first).starts_with("//")) continue;
    lines.push_back(name + ":" + std::to_string(number) + " " + line.substr(first));
  }
  return lines;
}

TEST(LineDirectives, LoopsKeepTheirHeads) {
  ir::Program program = ir::ReadOrDie(R"(
space m 1 volatile little
place a bit m[0].0
place b bit m[0].1
statement s1 subject FIRST
statement s2 subject SECOND
routine slow slow {
  body {
    stmt s1
    loop @1 guard 3 {
      condition {
        %0 = load a
      }
      body {
        %1 = load b
        store a %1
      }
    }
    stmt s2
    loop @2 guard 5 {
      condition {
        %2 = load b
      }
      body {
        %3 = load a
        store b %3
      }
    }
  }
}
)");
  source::SourceManager sources;
  const source::FileId file = sources.AddText("lamp.plc", "FIRST\nSECOND\n");
  const source::Offset base = sources.Get(file).base;
  program.statements[ir::StatementId(0)].range = {base, base + 5};
  program.statements[ir::StatementId(1)].range = {base + 6, base + 12};
  const OutputFile code = PrintCpp(legalize::Legalize(program, {.name = "p", .line_directives = true}), sources).back();
  std::vector<std::string> lines;
  std::istringstream text(code.text);
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  ASSERT_EQ(code.loops.size(), 2u);
  for (const PrintedLoop& loop : code.loops) {
    ASSERT_LE(loop.line, lines.size());
    const std::string& head = lines[loop.line - 1];
    EXPECT_NE(head.find("for ("), std::string::npos) << head;
  }
  EXPECT_LT(code.loops[0].line, code.loops[1].line);
}

TEST(LineDirectives, LeadToTheStatementAndBack) {
  ir::Program program = ir::ReadOrDie(R"(
space m 1 volatile little
place a bit m[0].0
place x bit m[0].1
place y bit m[0].2
statement s1 subject HEAD opens
statement s2 subject INNER
statement s3 subject LAST
statement s4 subject CONTROL
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
    stmt s4
    %3 = load y
    store x %3
  }
}
)");
  source::SourceManager sources;
  const source::FileId file = sources.AddText("lamp.plc", "HEAD\nINNER\n\nLAST\n");
  const source::Offset base = sources.Get(file).base;
  // The fourth statement is the control's own: it has no place in a source.
  for (const auto& [statement, offset] : {std::pair(0u, 0u), std::pair(1u, 5u), std::pair(2u, 12u)}) {
    program.statements[ir::StatementId(statement)].range = {base + offset, base + offset + 4};
  }
  const auto plain = PrintCpp(legalize::Legalize(program, {.name = "p"}), sources);
  const auto files = PrintCpp(legalize::Legalize(program, {.name = "p", .line_directives = true}), sources);
  ASSERT_EQ(files.size(), 2u);
  EXPECT_EQ(files[0].text, plain[0].text) << "the header has no statements";
  EXPECT_EQ(plain[1].text.find("#line"), std::string::npos);

  // The file without its directives is the file as it is without them.
  std::string without;
  std::istringstream text(files[1].text);
  std::vector<std::string> own;
  std::string line;
  while (std::getline(text, line)) {
    own.push_back(line);
    if (!line.starts_with("#line ")) without += line + "\n";
  }
  EXPECT_EQ(without, plain[1].text);

  size_t of_source = 0;
  for (const std::string& taken : TakenFor(files[1])) {
    const size_t colon = taken.find(':'), blank = taken.find(' ');
    const std::string name = taken.substr(0, colon), code = taken.substr(blank + 1);
    const size_t number = std::stoul(taken.substr(colon + 1));
    if (name == "p.cpp") {
      EXPECT_NE(own[number - 1].find(code), std::string::npos) << taken;
      continue;
    }
    ++of_source;
    const bool head = code == "if (m[a]) {" || code == "}";
    const size_t expected = head ? 1 : code.starts_with("m[y]") ? 4 : 2;
    EXPECT_EQ(name, "lamp.plc") << taken;
    EXPECT_EQ(number, expected) << taken;
  }
  EXPECT_EQ(of_source, 6u);  // if, const bool, two assignments, }; the last one

  // Owners are found again by their lines.
  for (const LineOwner& owner : files[1].owners) {
    ASSERT_GE(owner.line, 1u);
    ASSERT_LE(owner.line, own.size());
    EXPECT_FALSE(own[owner.line - 1].starts_with("#line")) << owner.line;
  }
}

}  // namespace
}  // namespace plcxx::emit::print
