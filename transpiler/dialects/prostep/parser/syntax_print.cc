// `plcxx print tokens` and `plcxx print syntax`: one line per token or item, stable, places as line:column.
#include "transpiler/dialects/common/printing.h"
#include "transpiler/dialects/prostep/parser/parser.h"
#include "transpiler/dialects/prostep/source/lexer.h"

namespace plcxx::prostep {
namespace {

class SyntaxPrinter : dialects::SyntaxLines {
 public:
  SyntaxPrinter(const source::SourceManager& sources, const Program& program)
      : SyntaxLines(sources), program_(program) {}

  std::string Run() {
    for (const SourceFile& file : program_.files) {
      writer_.Line("file ", sources_.Get(file.file).path);
      const support::Indented deeper(writer_);
      PrintDeclarations(file.file);
      for (const Module& module : program_.modules) {
        if (module.file == file.file) Print(module);
      }
    }
    return writer_.Take();
  }

 private:
  bool IsIn(source::FileId file, source::Range range) const { return sources_.FileAt(range.begin) == file; }

  void PrintDeclarations(source::FileId file) {
    for (const DataDeclaration& data : program_.data) {
      if (!IsIn(file, data.range)) continue;
      Node(data.range, "data ", std::to_string(data.address), " bytes ", std::to_string(data.bytes), " = ",
           std::to_string(data.value));
    }
    for (const MFunction& function : program_.m_functions) {
      if (!IsIn(file, function.range)) continue;
      std::string text = "m-function " + std::to_string(function.number);
      if (function.after_move) text += " after-move";
      if (function.static_bit != 0) text += " static " + std::to_string(function.static_bit);
      if (function.dynamic_bit != 0) text += " dynamic " + std::to_string(function.dynamic_bit);
      Node(function.range, text);
    }
    PrintTexts(file, program_.messages, "message");
    PrintTexts(file, program_.menu_texts, "menu");
  }

  void PrintTexts(source::FileId file, const std::vector<Text>& texts, std::string_view kind) {
    for (const Text& text : texts) {
      if (IsIn(file, text.range)) Node(text.range, kind, " ", std::to_string(text.number), " \"", text.text, "\"");
    }
  }

  void Print(const Module& module) {
    Node(module.open, "module PM ", std::to_string(module.number), module.faulty ? " (faulty)" : "");
    uint32_t label = module.labels.first;
    const uint32_t last_label = module.labels.first + module.labels.count;
    for (uint32_t i = module.instructions.first; i <= module.end_of().index; ++i) {
      for (; label < last_label && program_.labels[LabelId(label)].at.index == i; ++label) {
        Node(program_.labels[LabelId(label)].range, "label ", program_.labels[LabelId(label)].name);
      }
      if (i < module.end_of().index) Print(program_.instructions[InstructionId(i)]);
    }
    Node(module.close, module.close == source::Range{} ? "end is missing" : "end");
  }

  void Print(const Instruction& instruction) {
    std::string text = instruction.op == Op::kUnknown ? "error" : ToText(program_, instruction);
    if (instruction.function) text += " " + std::string(Info(*instruction.function).name);
    for (uint32_t i = 0; i < instruction.arguments.count; ++i) {
      text += " [" + ToText(program_.Argument(instruction, i)) + "]";
    }
    Node(instruction.range, text, instruction.faulty && instruction.op != Op::kUnknown ? " (faulty)" : "");
  }

  const Program& program_;
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
