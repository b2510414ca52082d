// Programs for tests of the report: IR as text, a source whose lines are the statements, some generated C++.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "transpiler/ir/reader.h"
#include "transpiler/report/program_input.h"

namespace plcxx::report {

constexpr std::string_view kMemory = R"(
space in 2 volatile little
space m 16 retentive little
place a bit in[0].0
place b bit in[0].1
place c bit in[0].2
place d bit in[0].3
place x bit m[0].0
place y bit m[0].1
place z bit m[0].2
place w i8 m[1]
place v i8 m[2]
place both i16 m[1]
)";

/// Line n of `lines` is statement n of the IR; a line that begins with ';' is a comment of the next one.
class ProgramFixture {
 public:
  ProgramFixture(std::string_view ir_text, const std::vector<std::string>& lines) : program_(ir::ReadOrDie(ir_text)) {
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    const source::FileId file = sources_.AddText("somewhere/deep/main.plc", text);
    source::Offset at = sources_.Get(file).base;
    std::vector<source::Range> comments;
    uint32_t next = 0;
    for (const std::string& line : lines) {
      const source::Range range{at, at + static_cast<source::Offset>(line.size())};
      at = range.end + 1;
      if (line.starts_with(";")) {
        comments.push_back(range);
      } else if (!line.empty() && next < program_.statements.size()) {
        ir::Statement& statement = program_.statements[ir::StatementId(next++)];
        statement.range = range;
        statement.comments = std::exchange(comments, {});
      }
    }
    input_.program = &program_;
    input_.sources = &sources_;
    input_.files = {file};
    input_.control = "control";
  }
  ProgramFixture(const ProgramFixture&) = delete;
  ProgramFixture& operator=(const ProgramFixture&) = delete;

  ir::Program& program() { return program_; }
  ProgramInput& input() { return input_; }

 private:
  ir::Program program_;
  source::SourceManager sources_;
  ProgramInput input_;
};

}  // namespace plcxx::report
