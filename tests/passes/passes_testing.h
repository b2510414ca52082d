// What the tests of passes share: a memory map, and the instructions of a routine as text.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "transpiler/ir/printer.h"
#include "transpiler/ir/reader.h"
#include "transpiler/ir/verifier.h"

namespace plcxx::passes {

inline constexpr std::string_view kMemory = R"(
space m 4 volatile little
space locals 8 routine little
state T5 on_delay_timer
place a bit m[0].0
place b bit m[0].1
place c bit m[0].2
place w i8 m[1]
place slice i32 locals[0]
place rounds i32 locals[4]
)";

inline ir::Program ReadRoutines(std::string_view routines) {
  return ir::ReadOrDie(std::string(kMemory) + std::string(routines));
}
inline ir::Program ReadFast(std::string_view body) {
  return ReadRoutines("routine fast fast {\n" + std::string(body) + "}\n");
}

/// The routines' lines; fails when the program breaks a rule of structured IR.
inline std::string Routines(const ir::Program& program) {
  for (const std::string& finding : ir::Verify(program, ir::Stage::kStructured)) ADD_FAILURE() << finding;
  const std::string text = ir::Print(program);
  return text.substr(text.find("\nroutine ") + 1);
}
/// As Routines, of a program with the one routine `fast`: its body, without indentation.
inline std::string Body(const ir::Program& program) {
  const std::string text = Routines(program);
  std::string out;
  size_t begin = text.find('\n') + 1;
  while (begin < text.size() && text[begin] != '}') {
    const size_t end = text.find('\n', begin);
    out += text.substr(begin + 2, end - begin - 1);
    begin = end + 1;
  }
  return out;
}

}  // namespace plcxx::passes
