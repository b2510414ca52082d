// `plcxx print tokens` and `plcxx print syntax`: one line per token or item, stable, places as line:column.
#include "transpiler/dialects/common/printing.h"
#include "transpiler/dialects/prostep/lexer.h"
#include "transpiler/dialects/prostep/parser.h"

namespace plcxx::prostep {
namespace {

class SyntaxPrinter {
 public:
  SyntaxPrinter(const source::SourceManager& sources, const Program& program) : sources_(sources), program_(program) {}

  std::string Run() {
    for (const SourceFile& file : program_.files) {
      out_ += "file " + sources_.Get(file.file).path + "\n";
      PrintDeclarations(file.file);
      for (const Module& module : program_.modules) {
        if (module.file == file.file) Print(module);
      }
    }
    return std::move(out_);
  }

 private:
  bool IsIn(source::FileId file, source::Range range) const { return sources_.FileAt(range.begin) == file; }

  void Begin(source::Range range) { out_ += "  " + dialects::PlaceText(sources_, range.begin) + " "; }

  void PrintDeclarations(source::FileId file) {
    for (const DataDeclaration& data : program_.data) {
      if (!IsIn(file, data.range)) continue;
      Begin(data.range);
      out_ += "data " + std::to_string(data.address) + " bytes " + std::to_string(data.bytes) + " = " +
              std::to_string(data.value) + "\n";
    }
    for (const MFunction& function : program_.m_functions) {
      if (!IsIn(file, function.range)) continue;
      Begin(function.range);
      out_ += "m-function " + std::to_string(function.number);
      if (function.after_move) out_ += " after-move";
      if (function.static_bit != 0) out_ += " static " + std::to_string(function.static_bit);
      if (function.dynamic_bit != 0) out_ += " dynamic " + std::to_string(function.dynamic_bit);
      out_ += "\n";
    }
    PrintTexts(file, program_.messages, "message");
    PrintTexts(file, program_.menu_texts, "menu");
  }

  void PrintTexts(source::FileId file, const std::vector<Text>& texts, std::string_view kind) {
    for (const Text& text : texts) {
      if (!IsIn(file, text.range)) continue;
      Begin(text.range);
      out_ += std::string(kind) + " " + std::to_string(text.number) + " \"" + text.text + "\"\n";
    }
  }

  void Print(const Module& module) {
    Begin(module.open);
    out_ += "module PM " + std::to_string(module.number) + (module.faulty ? " (faulty)\n" : "\n");
    uint32_t label = module.labels.first;
    const uint32_t last_label = module.labels.first + module.labels.count;
    for (uint32_t i = module.instructions.first; i <= module.end_of().index; ++i) {
      for (; label < last_label && program_.labels[LabelId(label)].at.index == i; ++label) {
        Begin(program_.labels[LabelId(label)].range);
        out_ += "label " + program_.labels[LabelId(label)].name + "\n";
      }
      if (i < module.end_of().index) Print(program_.instructions[InstructionId(i)]);
    }
    Begin(module.close);
    out_ += module.close == source::Range{} ? "end is missing\n" : "end\n";
  }

  void Print(const Instruction& instruction) {
    Begin(instruction.range);
    out_ += instruction.op == Op::kUnknown ? "error" : ToText(program_, instruction);
    if (instruction.function) out_ += " " + std::string(Info(*instruction.function).name);
    for (uint32_t i = 0; i < instruction.arguments.count; ++i) {
      out_ += " [" + ToText(program_.Argument(instruction, i)) + "]";
    }
    out_ += instruction.faulty && instruction.op != Op::kUnknown ? " (faulty)\n" : "\n";
  }

  const source::SourceManager& sources_;
  const Program& program_;
  std::string out_;
};

}  // namespace

std::string PrintTokens(const source::SourceManager& sources, source::FileId file) {
  diag::Engine unused;
  const LexedFile lexed = Lex(sources, file, unused);
  return dialects::TokenLines(sources, lexed.tokens);
}

std::string PrintSyntax(const source::SourceManager& sources, const Program& program) {
  return SyntaxPrinter(sources, program).Run();
}

}  // namespace plcxx::prostep
