#include "transpiler/dialects/host50/lowering.h"

#include <algorithm>
#include <utility>

#include "transpiler/dialects/host50/lowering_internal.h"

namespace plcxx::host50 {
namespace {

bool IsLineEnd(char c) { return c == '\n' || c == '\r'; }

/// Of the tokens: blanks, line ends and comments do not count.
dialects::TextHash HashOfTokens(std::string_view text) {
  dialects::TextHash hash;
  char quote = 0;
  bool comment = false;
  for (const char c : text) {
    if (IsLineEnd(c)) {
      comment = false;
      quote = 0;
      continue;
    }
    if (comment) continue;
    if (quote != 0) {
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == ';') {
      comment = true;
      continue;
    } else if (c == ' ' || c == '\t') {
      continue;
    }
    hash.Add(c);
  }
  return hash;
}

/// What an instruction is about, for the names of chunks: its result, or what it has a state of.
int32_t SubjectOperand(const Instruction& instruction) {
  const InstructionInfo& info = Info(instruction.op);
  for (uint32_t i = 0; i < info.operand_count; ++i) {
    const OperandRole role = info.operands[i];
    if (Writes(role) || role == OperandRole::kTimer || role == OperandRole::kCounter) return static_cast<int32_t>(i);
  }
  return -1;
}

}  // namespace

Lowering::Lowering(const Program& tree, const Settings& settings, const source::SourceManager& sources)
    : tree_(tree), settings_(settings), sources_(sources) {
  results_.resize(tree.instructions.size());
  own_instances_.resize(tree.instructions.size());
  is_target_.resize(tree.networks.size());
  has_way_back_.resize(tree.sections.size());
  routines_.resize(tree.sections.size());
}

void Lowering::FindJumps() {
  for (const Instruction& instruction : tree_.instructions) {
    if (instruction.op != Op::kLbl) continue;
    const NetworkId target = OperandOf(tree_, instruction, 0).network;
    is_target_[target.index] = true;
    const SectionId section = tree_.networks[instruction.network].section;
    if (target <= instruction.network) has_way_back_[section.index] = true;
  }
}

/// A comment without its ';', a remark without its quotes: how they begin is the language's matter, not the text's.
source::Range Lowering::TextOf(source::Range comment) const {
  while (comment.begin < comment.end && sources_.Text(comment).front() == ';') ++comment.begin;
  const std::string_view text = sources_.Text(comment);
  if (text.size() >= 2 && text.front() == '"' && text.back() == '"') ++comment.begin, --comment.end;
  return comment;
}

void Lowering::AddComments(Span comments) {
  for (uint32_t i = 0; i < comments.count; ++i) {
    waiting_comments_.push_back(TextOf(tree_.comments[comments.first + i].range));
  }
}

/// From the first to the end of the last one's line: what stands there is a row comment. A drawing's rows are whole.
source::Range Lowering::LinesOf(source::Range first, source::Range last, bool is_drawing) const {
  const source::File& file = sources_.Get(sources_.FileAt(first.begin));
  size_t begin = first.begin - file.base, end = last.end - file.base;
  while (end < file.text.size() && !IsLineEnd(file.text[end])) ++end;
  while (end > begin && (file.text[end - 1] == ' ' || file.text[end - 1] == '\t')) --end;
  while (is_drawing && begin > 0 && !IsLineEnd(file.text[begin - 1])) --begin;
  return {file.base + static_cast<source::Offset>(begin), file.base + static_cast<source::Offset>(end)};
}

bool Lowering::Acts(const Instruction& instruction) const {
  const RungEffect effect = Info(instruction.op).effect;
  return effect != RungEffect::kNothing && effect != RungEffect::kClose;
}

uint32_t Lowering::LineOf(InstructionId id) const { return sources_.Locate(tree_.instructions[id].range.begin).line; }

/// A rung ends where no instruction behind it uses a result of it; in a drawing also not inside a row, and not above
/// a row that it has reached already.
std::vector<Span> Lowering::RungsOf(const Network& network) const {
  const uint32_t first = network.instructions.first, end = first + network.instructions.count;
  std::vector<uint32_t> last_use(network.instructions.count), lowest_line(network.instructions.count + 1, 0xFFFFFFFF);
  for (uint32_t i = end; i-- > first;) {
    last_use[i - first] = std::max(last_use[i - first], i);
    ForEachTaken(tree_.instructions[InstructionId(i)], [&](InstructionId taken) {
      last_use[taken.index - first] = std::max(last_use[taken.index - first], i);
    });
    const uint32_t line = network.is_drawing ? LineOf(InstructionId(i)) : 0;
    lowest_line[i - first] = std::min(line, lowest_line[i - first + 1]);
  }
  std::vector<Span> rungs;
  uint32_t reach = 0, line = 0;
  for (uint32_t i = first; i < end; ++i) {
    const bool apart = !network.is_drawing || line < lowest_line[i - first];
    if (rungs.empty() || (i > reach && apart)) rungs.push_back({i, 0});
    ++rungs.back().count;
    reach = std::max(reach, last_use[i - first]);
    if (network.is_drawing) line = std::max(line, LineOf(InstructionId(i)));
  }
  return rungs;
}

/// Of the first instruction that writes something or has a state; else "CALL" or the like.
std::string Lowering::SubjectOf(Span rung) const {
  std::string otherwise;
  for (uint32_t i = 0; i < rung.count; ++i) {
    const Instruction& instruction = tree_.instructions[InstructionId(rung.first + i)];
    if (instruction.op == Op::kCall) {
      return SubroutineName(tree_.sections[OperandOf(tree_, instruction, 0).section].number);
    }
    const int32_t operand = SubjectOperand(instruction);
    if (operand >= 0) return NameInCode(OperandOf(tree_, instruction, static_cast<uint32_t>(operand)).address);
    if (otherwise.empty() && Info(instruction.op).form == Form::kBlock) otherwise = Info(instruction.op).name;
  }
  return otherwise;
}

uint32_t Lowering::AddStatement(source::Range range, std::string subject) {
  const uint32_t number = statement_ids_.Next(HashOfTokens(sources_.Text(range)));
  const ir::StatementId id = program_.statements.Add(
      {.range = range, .comments = std::exchange(waiting_comments_, {}), .subject = std::move(subject), .id = number});
  builder_.SetRange(range);
  builder_.Statement(id);
  return number;
}

void Lowering::BeginStatement(Span rung) {
  // A drawing is executed in another order than its rows.
  source::Range first = tree_.instructions[InstructionId(rung.first)].range, last = first;
  for (uint32_t i = 0; i < rung.count; ++i) {
    const Instruction& instruction = tree_.instructions[InstructionId(rung.first + i)];
    if (instruction.range.begin < first.begin) first = instruction.range;
    if (instruction.range.end > last.end) last = instruction.range;
    AddComments(instruction.comments);
  }
  const source::Range range = LinesOf(first, last, tree_.networks[now_.network].is_drawing);
  // Row comments, and comments between the lines, are part of the lines.
  std::erase_if(waiting_comments_, [&range](source::Range comment) { return comment.begin >= range.begin; });
  now_.statement_id = AddStatement(range, SubjectOf(rung));
}

void Lowering::LowerRung(Span rung) {
  // Remarks and RUNG at its begin belong to the next rung, and at its end there are none.
  while (rung.count > 0 && !Acts(tree_.instructions[InstructionId(rung.first)])) {
    const Instruction& text = tree_.instructions[InstructionId(rung.first)];
    AddComments(text.comments);
    if (text.op == Op::kRemark) waiting_comments_.push_back(TextOf(OperandOf(tree_, text, 0).range));
    ++rung.first, --rung.count;
  }
  if (rung.count == 0) return;
  BeginStatement(rung);
  pending_.clear();
  open_if_.then = {};
  for (uint32_t i = 0; i < rung.count; ++i) Execute(InstructionId(rung.first + i));
}

void Lowering::BeginNetwork(NetworkId id) {
  now_.network = id;
  const Network& network = tree_.networks[id];
  builder_.SetRange(network.range);
  if (is_target_[id.index]) builder_.Label(id.index);
  AddComments(network.comments);
  waiting_comments_.push_back(TextOf(network.range));
}

void Lowering::LowerNetwork(NetworkId id) {
  const Network& network = tree_.networks[id];
  CountUses(network.instructions);
  for (const Span rung : RungsOf(network)) LowerRung(rung);
}

void Lowering::CountJumps(ir::Lifetime lifetime) {
  const std::string name = "jumps_left";
  if (lifetime == ir::Lifetime::kRoutine) {
    now_.jumps_left = NewLocal(name);
  } else {
    const Section& section = tree_.sections[now_.section];
    const bool is_subroutine = section.kind == SectionKind::kSubroutine;
    now_.jumps_left =
        NewSystemPlace(is_subroutine ? SubroutineName(section.number) + "_" + name : name, ir::Type::kI32);
  }
}

void Lowering::EndSection() {
  AddComments(tree_.sections[now_.section].end_comments);
  if (!waiting_comments_.empty()) {
    // A statement without code carries what nothing else follows.
    const source::Range last = waiting_comments_.back();
    waiting_comments_.pop_back();
    AddStatement(last, {});
  }
  builder_.SetRange({});
  if (now_.end_is_used) builder_.Label(now_.end_label);
}

void Lowering::LowerSection(SectionId id, ir::RegionId body) {
  const Section& section = tree_.sections[id];
  now_ = {.section = id,
          .network = {},
          .jumps_left = {},
          .end_label = tree_.networks.size() + id.index,
          .period_ms = section.kind == SectionKind::kFast ? 1 : settings_.slowdiv};
  builder_.SetRegion(body);
  builder_.SetRange({});
  AddComments(section.comments);
  if (section.kind == SectionKind::kSlow && settings_.slices == SlicesOption::kSliced) {
    SlicedSlow(id);
  } else {
    if (has_way_back_[id.index]) {
      // A subroutine's count is its own in each call, so it is no local that it would share with its caller.
      CountJumps(section.kind == SectionKind::kSlow ? ir::Lifetime::kRoutine : ir::Lifetime::kVolatile);
      builder_.Store(now_.jumps_left, builder_.Constant(ir::Type::kI32, kMostJumps));
    }
    for (uint32_t i = 0; i < section.networks.count; ++i) {
      BeginNetwork(NetworkId(section.networks.first + i));
      LowerNetwork(NetworkId(section.networks.first + i));
    }
  }
  EndSection();
}

void Lowering::Sections() {
  for (uint32_t i = 0; i < tree_.sections.size(); ++i) {
    const SectionId id(i);
    if (routines_[i].valid()) LowerSection(id, program_.routines[routines_[i]].body);
  }
}

ir::Program Lowering::Run() {
  program_.dialect = "host50";
  if (tree_.faulty) return std::move(program_);
  AddSpaces(program_, settings_.channels);
  CollectSymbols();
  CountOwnNames();
  FindJumps();
  AddRoutines();
  Sections();
  Init();
  Period();
  Schedule();
  Tables();
  Document();
  return std::move(program_);
}

ir::Program Lower(const Program& tree, const Settings& settings, const source::SourceManager& sources) {
  return Lowering(tree, settings, sources).Run();
}

}  // namespace plcxx::host50
