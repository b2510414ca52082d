// What an object file says, as plain facts: functions with their blocks and calls, sections, symbols.
//
// The module (audit/, the only code that includes LLVM) fills it in; the rules of the audit and the measurement read
// it. Nothing here is judged.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace plcxx::compile {

/// A line of generated code or of a runtime header.
struct CodeLine {
  uint32_t file = 0;  // index into ObjectFacts::files
  uint32_t line = 0;  // from 1; 0: unknown
  bool operator==(const CodeLine&) const = default;
};

struct CodeCall {
  uint32_t symbol = 0;  // index into ObjectFacts::symbols
  bool tail = false;    // jumps there, and does not come back
};

/// Where control goes at the end of a block.
struct CodeEdge {
  uint32_t block = 0;     // of the same function
  uint32_t cycles_k = 0;  // thousandths of a cycle that a taken branch costs on top
};

/// Instructions that are executed one after the other.
struct CodeBlock {
  uint32_t instructions = 0;
  uint64_t cycles_k = 0;  // thousandths of a cycle
  std::vector<CodeEdge> successors;
  std::vector<CodeCall> calls;
  bool leaves = false;          // the function ends here, or control does not come back
  std::vector<CodeLine> lines;  // of its instructions, each once
  CodeLine last;                // of its last instruction
};

struct CodeFunction {
  uint32_t symbol = 0;       // index into ObjectFacts::symbols
  uint32_t bytes = 0;        // with its constants between the instructions
  uint32_t frame_bytes = 0;  // of the stack, saved registers and return address included
  bool frame_known = false;
  bool decoded = false;  // every instruction is known
  uint32_t indirect_calls = 0;
  uint32_t indirect_jumps = 0;
  std::vector<uint32_t> constants;  // sections of constants that it refers to, ascending: indices into `sections`
  std::vector<CodeBlock> blocks;    // the first one is entered
};

constexpr uint32_t kNoFunction = 0xFFFFFFFF;

struct CodeSymbol {
  std::string name;  // as the linker sees it
  std::string text;  // as the source has it: "mill::fast(mill::State&, mill::Host&)"
  bool defined = false;
  bool local = false;               // of this object only
  uint32_t function = kNoFunction;  // in ObjectFacts::functions
};

/// A function, or a table, that needs a symbol of another object.
struct SymbolUse {
  std::string user;     // a function as the source has it, or a section's name
  uint32_t symbol = 0;  // index into ObjectFacts::symbols; not defined
};

enum class SectionKind : uint8_t { kCode, kConstants, kData, kZeroes, kConstructors, kUnwinding, kOther };

struct CodeSection {
  std::string name;
  SectionKind kind = SectionKind::kOther;
  uint64_t bytes = 0;
};

struct ObjectFacts {
  std::vector<std::string> files;
  std::vector<CodeSymbol> symbols;
  std::vector<CodeFunction> functions;
  std::vector<SymbolUse> uses;
  std::vector<CodeSection> sections;
  std::string timing;   // where the cycles come from, in words
  std::string failure;  // not empty: it could not be read, and why
};

}  // namespace plcxx::compile
