#include "transpiler/dialects/host50/parser/drawing_reader.h"

namespace plcxx::host50 {

uint32_t DrawingReader::ReadDrawing(const Body& body, uint32_t first, std::vector<source::Range>& comments) {
  Drawing drawing;
  std::vector<std::vector<source::Range>> above;  // comments, by row
  uint32_t line = first;
  for (; line < body.last && files_[body.file].lines[line].kind == LineKind::kRow; ++line) {
    AddRow(*now_.source, files_[body.file].lines[line].range, drawing, diagnostics_);
    DrawnRow& row = drawing.rows.back();
    if (row.cells.empty() && row.comment.end > row.comment.begin) comments.push_back(row.comment);
    above.emplace_back();
    if (!row.cells.empty()) std::swap(above.back(), comments);
  }
  std::vector<Instruction> instructions(drawing.elements.size());
  std::vector<ElementMeaning> meanings(drawing.elements.size());
  for (size_t i = 0; i < instructions.size(); ++i) {
    instructions[i].network = body.network;
    ReadElement(drawing.elements[i], instructions[i]);
    if (!instructions[i].unknown) meanings[i].op = instructions[i].op;
    meanings[i].faulty = instructions[i].faulty;
  }
  const std::optional<Wiring> wiring = Connect(drawing, meanings, diagnostics_);
  program_.faulty = program_.faulty || drawing.faulty;
  for (size_t i = 0; i < instructions.size(); ++i) instructions[i].faulty = meanings[i].faulty;
  AddRowComments(drawing, above, instructions);
  AddElements(wiring, instructions);
  return line;
}

/// To the first action of each row, or to its first element.
void DrawingReader::AddRowComments(const Drawing& drawing, const std::vector<std::vector<source::Range>>& above,
                                   std::vector<Instruction>& instructions) {
  std::vector<size_t> bearers(drawing.rows.size(), instructions.size());
  std::vector<bool> is_action(drawing.rows.size());
  for (size_t i = 0; i < instructions.size(); ++i) {
    const uint32_t row = drawing.elements[i].row;
    const bool action = drawing.elements[i].bracket != '[';
    if (bearers[row] == instructions.size() || (action && !is_action[row])) bearers[row] = i;
    if (action) is_action[row] = true;
  }
  std::vector<source::Range> waiting;  // of rows that are nothing but wires
  for (size_t row = 0; row < bearers.size(); ++row) {
    waiting.insert(waiting.end(), above[row].begin(), above[row].end());
    const source::Range comment = drawing.rows[row].comment;
    if (bearers[row] != instructions.size()) {
      instructions[bearers[row]].comments = AddComments(waiting, comment);
    } else if (!drawing.rows[row].cells.empty() && comment.end > comment.begin) {
      waiting.push_back(comment);
    }
  }
}

/// In the order of evaluation; without one, in rows.
void DrawingReader::AddElements(const std::optional<Wiring>& wiring, const std::vector<Instruction>& instructions) {
  program_.statement_count += static_cast<uint32_t>(instructions.size());
  if (!wiring) {
    for (const Instruction& instruction : instructions) program_.instructions.Add(instruction);
    return;
  }
  std::vector<InstructionId> ids(instructions.size());
  for (const uint32_t element : wiring->order) {
    Instruction instruction = instructions[element];
    const ElementInput& input = wiring->inputs[element];
    if (input.from_rail) {
      instruction.input.kind = InputKind::kRail;
    } else {
      instruction.input = {
          .kind = InputKind::kResults,
          .results = {static_cast<uint32_t>(program_.results.size()), static_cast<uint32_t>(input.sources.size())}};
      for (const uint32_t source : input.sources) program_.results.push_back(ids[source]);
    }
    ids[element] = program_.instructions.Add(instruction);
  }
}

void DrawingReader::ReadElement(const DrawnElement& element, Instruction& instruction) {
  const ElementKind kind = element.bracket == '{' ? ElementKind::kBlock : ElementKind::kContactOrCoil;
  const std::vector<Token> tokens = LexElement(*now_.source, element.contents, kind);
  instruction.range = element.range;
  Begin(tokens, element.contents);
  kind == ElementKind::kBlock ? ReadDrawnBlock(instruction) : ReadContactOrCoil(element, instruction);
  instruction.faulty = now_.failed;
  Begin(std::span<const Token>(), element.range);  // the tokens end here
  now_.failed = instruction.faulty;
}

/// A letter is a prefix only when a blank and a further word follow it.
void DrawingReader::ReadContactOrCoil(const DrawnElement& element, Instruction& instruction) {
  const Token first = Peek(), next = Peek(1);
  char prefix = ' ';
  if (first.kind == TokenKind::kSlash) {
    prefix = '/';
  } else if (first.kind == TokenKind::kWord && TextOf(first).size() == 1 && next.range.begin > first.range.end &&
             DrawnOp(element.bracket, TextOf(first).front())) {
    prefix = TextOf(first).front();
  }
  if (prefix != ' ') Take();
  instruction.op = *DrawnOp(element.bracket, prefix);
  instruction.mnemonic = {element.range.begin, prefix == ' ' ? element.range.begin + 1 : first.range.end};
  instructions_.ReadOperands(instruction, Setting::kDrawing);
}

void DrawingReader::ReadDrawnBlock(Instruction& instruction) {
  const Token token = Peek();
  instruction.mnemonic = token.range;
  const auto mnemonic = token.kind == TokenKind::kWord ? MnemonicByName(TextOf(token)) : std::nullopt;
  if (!mnemonic || Info(mnemonic->op).form != Form::kBlock) {
    instruction.unknown = true;
    if (!FaultOfBadToken()) Fault(token.range, diag::Host50UnknownBlock, TextOf(token));
    return;
  }
  Take();
  instruction.op = mnemonic->op;
  instruction.unit = mnemonic->unit.value_or(TimerUnit::kHundredMs);
  instructions_.ReadOperands(instruction, Setting::kDrawing);
}

}  // namespace plcxx::host50
