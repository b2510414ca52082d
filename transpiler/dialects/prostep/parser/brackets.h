// Brackets and AND strings as the text of a module has them (specification 6.1.3, 6.1.4): nothing here needs paths.
//
// In: the instructions, labels and the end of a module in their order. Reports E14 and E15. Not its job: values.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "transpiler/diagnostics/diagnostics.h"
#include "transpiler/dialects/prostep/machine/machine.h"
#include "transpiler/source/source.h"

namespace plcxx::prostep {

class BracketChecker {
 public:
  explicit BracketChecker(diag::Engine& diagnostics) : diagnostics_(diagnostics) {}

  void BeginModule();
  /// `text` names the instruction in messages.
  void Instruction(Op op, source::Range range, std::string_view text);
  void Label(std::string_view name, source::Range range);
  void EndModule(source::Range range, std::string_view text);

 private:
  struct Level {
    source::Range open;
    bool has_content = false;  // a logic operation or a comparison
    bool in_string = false;    // an operand-less O waits for its fold
    bool is_misspelt = false;  // opened by what is no instruction, which was reported
  };

  /// The innermost bracket that a right instruction opened; none: nothing but misspelt ones are open.
  const Level* InnermostOpen() const;
  void Open(source::Range range, std::string_view text);
  void Close(source::Range range);
  /// What ends a sequence and what jumps stands outside brackets.
  void Outside(source::Range range, std::string_view text);

  diag::Engine& diagnostics_;
  std::vector<Level> levels_ = {{}};  // the first is the module's own
  size_t forgiven_ = 0;               // closing brackets of brackets that were reported as not closed
};

}  // namespace plcxx::prostep
