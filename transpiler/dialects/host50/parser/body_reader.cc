#include "transpiler/dialects/host50/parser/body_reader.h"

#include "transpiler/dialects/host50/parser/rung_machine.h"

namespace plcxx::host50 {

void BodyReader::ReadBodies() {
  for (const Body& body : parts_.bodies) {
    EnterFile(body.file);
    now_.section = program_.networks[body.network].section;
    ReadBody(body);
  }
}

void BodyReader::ReadBody(const Body& body) {
  Network& network = program_.networks[body.network];
  network.instructions.first = program_.instructions.size();
  std::vector<source::Range> comments;  // above the next instruction
  bool mixed = false;                   // E607: once for each network
  const auto fault_of_mixing = [&](Line& line, std::string_view word) {
    if (std::exchange(mixed, true)) return;
    Begin(line);
    Fault(line.range, diag::Host50LadderMixed, word);
    line.faulty = true;
  };
  bool listed = false;
  for (uint32_t i = body.first; i < body.last;) {
    Line& line = files_[body.file].lines[i++];
    if (line.kind == LineKind::kComment) comments.push_back(line.comment);
    if (line.kind == LineKind::kBlank || line.kind == LineKind::kComment || line.consumed) continue;
    const std::string_view word = WordOf(line);
    if (PartByEnd(word) == PartKind::kLadder) continue;
    if (PartByName(word) == PartKind::kLadder) {
      Begin(line);
      if (network.is_drawing) {
        Fault(line.range, diag::Host50LadderTwice);
      } else if (listed) {
        fault_of_mixing(line, "instructions");
      } else {
        Take();
        ExpectEnd();
      }
      network.is_drawing = true;
      if (line.comment.end > line.comment.begin) comments.push_back(line.comment);
      i = drawings_.ReadDrawing(body, i, comments);
      continue;
    }
    const auto mnemonic = MnemonicByName(word);
    const bool is_remark = mnemonic && Info(mnemonic->op).effect == RungEffect::kNothing;
    if (!is_remark && network.is_drawing && mnemonic) fault_of_mixing(line, "an instruction");
    listed = listed || !is_remark;
    ReadInstruction(line, body.network, comments);
  }
  network.instructions.count = program_.instructions.size() - network.instructions.first;
  if (!network.is_drawing) EvaluateRungs(program_, body.network, sources_, diagnostics_);
}

void BodyReader::ReadInstruction(const Line& line, NetworkId network, std::vector<source::Range>& comments) {
  Instruction instruction{.network = network, .range = line.range};
  instruction.comments = AddComments(comments, line.comment);
  Begin(line);
  now_.failed = line.faulty;
  instructions_.ReadStatement(instruction);
  instruction.faulty = now_.failed;
  program_.instructions.Add(instruction);
  ++program_.statement_count;
}

}  // namespace plcxx::host50
