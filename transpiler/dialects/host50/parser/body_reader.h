// The bodies of networks: lists of instructions, and drawings (specification 3.3 to 3.6).
#pragma once

#include <vector>

#include "transpiler/dialects/host50/parser/drawing_reader.h"
#include "transpiler/dialects/host50/parser/instruction_reader.h"
#include "transpiler/dialects/host50/parser/parts.h"
#include "transpiler/dialects/host50/parser/statement_reader.h"

namespace plcxx::host50 {

class BodyReader : private StatementReader {
 public:
  BodyReader(Parsing& parsing, const Parts& parts, SymbolReader& symbols)
      : StatementReader(parsing),
        parts_(parts),
        instructions_(parsing, parts, symbols),
        drawings_(parsing, instructions_) {}
  BodyReader(const BodyReader&) = delete;
  BodyReader& operator=(const BodyReader&) = delete;

  void ReadBodies();

 private:
  void ReadBody(const Body& body);
  void ReadInstruction(const Line& line, NetworkId network, std::vector<source::Range>& comments);

  const Parts& parts_;
  InstructionReader instructions_;
  DrawingReader drawings_;
};

}  // namespace plcxx::host50
