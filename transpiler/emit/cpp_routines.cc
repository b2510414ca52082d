// Routines, chunks and statements as C++.

#include <algorithm>

#include "transpiler/emit/cpp_printer.h"
#include "transpiler/ir/builder.h"

namespace plcxx::emit {
namespace {

constexpr size_t kLineWidth = 110;

/// Prints one file; the state of the printing is where it stands in the text.
class PartPrinter {
 public:
  PartPrinter(const Emittable& emittable, const source::SourceManager& sources, uint32_t part)
      : emittable_(emittable), program_(*emittable.program), sources_(sources), part_(part) {}

  std::string Run();

 private:
  void Includes();
  void Using();
  void Chunks();
  void Routines();
  void InitStorage();
  void RegionBody(ir::RegionId region);
  void Range(ir::RegionId region, uint32_t begin, uint32_t end);
  void Inst(ir::InstId id);
  void StatementComments(const ir::Statement& statement);
  void If(const ir::Inst& inst);
  void Switch(const ir::Inst& inst);
  void Loop(const ir::Inst& inst);
  void Local(ir::InstId id);
  void Line(std::string text);
  void Comment(std::string_view text);
  std::string Value(uint32_t word) { return Spell(emittable_, local_names_, ir::ValueId(word)).text; }
  /// A condition, switched off together with its statement in the debug flavour.
  std::string Condition(uint32_t word);
  /// Opens a function; its head is written at the end and leaves out the names that its body does not use.
  void OpenFunction(const std::string& head, std::vector<std::string> parameters);
  void CloseFunction();
  bool debug() const { return emittable_.options.flavour == Flavour::kDebug; }

  const Emittable& emittable_;
  const ir::Program& program_;
  const source::SourceManager& sources_;
  uint32_t part_;
  std::string out_;
  std::string function_head_;            // of the function being printed
  std::vector<std::string> parameters_;  // "State& m"
  size_t body_begin_ = 0;
  int indent_ = 0;
  int loop_depth_ = 0;
  uint32_t next_local_ = 1;    // restarts in each chunk and routine
  LocalNames local_names_;     // by InstId
  ir::StatementId statement_;  // the one being printed
};

void PartPrinter::Comment(std::string_view text) {
  out_.append(static_cast<size_t>(indent_) * 2, ' ');
  out_ += "//";
  const std::string safe = CommentText(text);
  if (!safe.empty()) {
    out_ += ' ';
    out_ += safe;
  }
  out_ += '\n';
}

/// Writes a line; a long one is broken before operators.
void PartPrinter::Line(std::string text) {
  const size_t margin = static_cast<size_t>(indent_) * 2;
  if (margin + text.size() <= kLineWidth) {
    std::replace(text.begin(), text.end(), kBreak, ' ');
    out_.append(margin, ' ');
    out_ += text;
    out_ += '\n';
    return;
  }
  std::string line(margin, ' ');
  size_t last_break = std::string::npos;
  for (const char c : text) {
    if (c == kBreak) {
      last_break = line.size();
      line += ' ';
    } else {
      line += c;
    }
    if (line.size() > kLineWidth && last_break != std::string::npos) {
      out_.append(line, 0, last_break);
      out_ += '\n';
      line = std::string(margin + 4, ' ') + line.substr(last_break + 1);
      last_break = std::string::npos;
    }
  }
  out_ += line;
  out_ += '\n';
}

void PartPrinter::StatementComments(const ir::Statement& statement) {
  for (const source::Range& comment : statement.comments) Comment(sources_.Text(comment));
  const std::string_view text = sources_.Text(statement.range);
  size_t begin = 0;
  while (begin < text.size()) {
    size_t end = text.find_first_of("\r\n", begin);
    if (end == std::string_view::npos) end = text.size();
    if (end > begin) Comment(text.substr(begin, end - begin));
    begin = end + 1;
  }
  if (text.empty() && !statement.subject.empty()) Comment(statement.subject);
}

void PartPrinter::Local(ir::InstId id) {
  const ir::Inst& inst = program_[id];
  std::string& name = local_names_[id.index];
  name = "t" + std::to_string(next_local_++);
  const std::string value = SpellDefinition(emittable_, local_names_, id).text;
  Line("const " + std::string(ir::CppName(inst.type)) + " " + name + " = " + value + ";");
}

std::string PartPrinter::Condition(uint32_t word) {
  const Spelling condition = Spell(emittable_, local_names_, ir::ValueId(word));
  if (!debug() || !statement_.valid()) return condition.text;
  const std::string on = "m.on(" + std::to_string(statement_.index) + ") & ";
  return on + (condition.precedence <= ir::Precedence::kUnary ? condition.text : "(" + condition.text + ")");
}

void PartPrinter::If(const ir::Inst& first) {
  const ir::Inst* inst = &first;
  std::string head = "if (" + Condition(inst->a) + ") {";
  for (;;) {
    const ir::StatementId own = statement_;
    Line(std::move(head));
    ++indent_;
    RegionBody(ir::RegionId(inst->b));
    --indent_;
    Line("}");
    statement_ = own;  // an else-if without a marker is still this statement's
    const ir::RegionId otherwise(inst->c);
    if (!otherwise.valid() || program_.regions[otherwise].insts.empty()) return;
    // A chain: an else arm of one statement, which is an If whose condition needs no line of its own.
    const auto& insts = program_.regions[otherwise].insts;
    const ir::InstId last = insts.back();
    bool chain = program_[last].op == ir::OpKind::kIf && emittable_.region_chunks[otherwise.index].empty();
    ir::StatementId statement;
    for (size_t i = 0; chain && i + 1 < insts.size(); ++i) {
      const ir::Inst& other = program_[insts[i]];
      if (other.op == ir::OpKind::kStatement && i == 0) {
        statement = ir::StatementId(other.payload);
      } else {
        const ir::Shape shape = ir::Info(other.op).shape;
        chain = (shape == ir::Shape::kPure || shape == ir::Shape::kLoad || shape == ir::Shape::kConst) &&
                !emittable_.local_value[insts[i].index];
      }
    }
    if (chain) {
      if (statement.valid()) {
        statement_ = statement;
        StatementComments(program_.statements[statement]);
      }
      inst = &program_[last];
      const ir::Inst& condition = program_[ir::ValueId(inst->a)];
      const bool always =
          condition.op == ir::OpKind::kConst && ir::ConstantValue(condition) != 0 && !ir::RegionId(inst->c).valid();
      head = always && !debug() ? "else {" : "else if (" + Condition(inst->a) + ") {";
      if (!statement.valid()) {
        out_.pop_back();  // no comment between: "} else if"
        head.insert(0, " ");
        head.insert(0, "}");
        out_.resize(out_.rfind('\n') + 1);
      }
      continue;
    }
    out_.resize(out_.size() - 1);
    out_ += " else {\n";
    ++indent_;
    RegionBody(otherwise);
    --indent_;
    Line("}");
    return;
  }
}

void PartPrinter::Switch(const ir::Inst& inst) {
  Line("switch (" + Value(inst.a) + ") {");
  ++indent_;
  for (const ir::SwitchCase& arm : program_.switches[ir::SwitchId(inst.payload)].cases) {
    if (arm.values.empty()) {
      Line("default: {");
    } else {
      for (size_t i = 0; i < arm.values.size(); ++i) {
        Line("case " + std::to_string(arm.values[i]) + (i + 1 < arm.values.size() ? ":" : ": {"));
      }
    }
    ++indent_;
    RegionBody(arm.region);
    if (!arm.falls_through) Line("break;");
    --indent_;
    Line("}");
    if (arm.falls_through) Line("[[fallthrough]];");
  }
  --indent_;
  Line("}");
}

void PartPrinter::Loop(const ir::Inst& inst) {
  const ir::Loop& loop = program_.loops[ir::LoopId(inst.payload)];
  PLCXX_CHECK(loop.kind != ir::LoopBound::kBudget);  // arrives with the first dialect that shares a budget
  const std::string round = "round" + (loop_depth_ == 0 ? "" : std::to_string(loop_depth_ + 1));
  const ir::StatementId statement = statement_;
  ++loop_depth_;
  Line("for (uint32_t " + round + " = 0;; ++" + round + ") {");
  ++indent_;
  if (loop.condition.valid()) {
    const auto& insts = program_.regions[loop.condition].insts;
    Range(loop.condition, 0, static_cast<uint32_t>(insts.size()));
    const Spelling condition = Spell(emittable_, local_names_, insts.back());
    std::string text = condition.precedence <= ir::Precedence::kUnary ? condition.text : "(" + condition.text + ")";
    if (debug() && statement.valid()) text = "(m.on(" + std::to_string(statement.index) + ") & " + text + ")";
    Line("if (!" + text + ") break;");
  }
  if (loop.kind == ir::LoopBound::kGuard) {
    Line("if (" + round + " == " + std::to_string(loop.bound) + ") {");
    ++indent_;
    if (loop.exhausted.valid()) RegionBody(loop.exhausted);
    Line("break;");
    --indent_;
    Line("}");
  }
  RegionBody(loop.body);
  --indent_;
  Line("}");
  --loop_depth_;
}

void PartPrinter::Inst(ir::InstId id) {
  const ir::Inst& inst = program_[id];
  if (emittable_.local_value[id.index]) {
    Local(id);
    return;
  }
  switch (ir::Info(inst.op).shape) {
    case ir::Shape::kPure:
    case ir::Shape::kLoad:
    case ir::Shape::kConst:
      return;  // spelled where it is used
    case ir::Shape::kStep:
    case ir::Shape::kCall:
    case ir::Shape::kHostCall: {
      const bool loads_retentive = inst.op == ir::OpKind::kHostCall &&
                                   program_.host_functions[program_.calls[ir::CallId(inst.payload)].host].access ==
                                       ir::HostAccess::kWritesRetentive;
      if (loads_retentive) {
        const std::string& name = program_.host_functions[program_.calls[ir::CallId(inst.payload)].host].name;
        Line("Retentive copy{};");
        Line(name + "(host, copy);");
        Line("if (copy.layout == kRetentiveLayout) m.retentive = copy;");
        return;
      }
      Line(Spell(emittable_, local_names_, id).text + ";");
      return;
    }
    case ir::Shape::kStore: {
      const PlaceStorage& stored = emittable_.layout.places[inst.payload];
      const std::string& name = emittable_.place_names[inst.payload];
      const std::string target = stored.storage == Storage::kLocal ? name : "m[" + name + "]";
      Line(target + " = " + Value(inst.a) + ";");
      return;
    }
    case ir::Shape::kText: {
      std::string literal;
      for (const char c : program_.texts[ir::TextId(inst.b)]) {
        if (c == '"' || c == '\\') literal += '\\';
        literal += c;
      }
      Line("UpdateText(m[" + emittable_.state_names[inst.payload] + "], m[" + emittable_.state_names[inst.a] + "], \"" +
           literal + "\");");
      return;
    }
    case ir::Shape::kIf:
      If(inst);
      return;
    case ir::Shape::kSwitch:
      Switch(inst);
      return;
    case ir::Shape::kLoop:
      Loop(inst);
      return;
    case ir::Shape::kBlock:
      RegionBody(ir::RegionId(inst.a));
      Line("end_" + std::to_string(id.index) + ":;");
      return;
    case ir::Shape::kExit: {
      const std::string leave = "goto end_" + std::to_string(inst.payload) + ";";
      Line(ir::ValueId(inst.a).valid() ? "if (" + Value(inst.a) + ") " + leave : leave);
      return;
    }
    case ir::Shape::kRepeat:
    case ir::Shape::kStatement:
    case ir::Shape::kJump:
    case ir::Shape::kLabel:
      break;
  }
  PLCXX_UNREACHABLE();
}

void PartPrinter::Range(ir::RegionId region, uint32_t begin, uint32_t end) {
  const auto& insts = program_.regions[region].insts;
  bool switched = false;  // inside the debug flavour's `if (m.on(...))`
  bool uses_result = false;
  const auto close = [&] {
    if (switched) {
      --indent_;
      Line("}");
      switched = false;
    }
  };
  for (uint32_t i = begin; i < end; ++i) {
    const ir::Inst& inst = program_[insts[i]];
    if (inst.op == ir::OpKind::kStatement) {
      close();
      if (i > begin && indent_ == 1) out_ += '\n';
      statement_ = ir::StatementId(inst.payload);
      const ir::Statement& statement = program_.statements[statement_];
      StatementComments(statement);
      if (debug() && !statement.opens_block && !statement.closes_block) {
        Line("if (m.on(" + std::to_string(statement_.index) + ")) {");
        ++indent_;
        switched = true;
      }
      continue;
    }
    // A step whose result the next instruction spells is not a statement of its own.
    const bool step_value =
        inst.type != ir::Type::kNone &&
        (ir::Info(inst.op).shape == ir::Shape::kStep || ir::Info(inst.op).shape == ir::Shape::kCall ||
         ir::Info(inst.op).shape == ir::Shape::kHostCall) &&
        !emittable_.local_value[insts[i].index];
    if (step_value) {
      uses_result = false;
      for (uint32_t k = i + 1; k < end && !uses_result; ++k) {
        if (program_[insts[k]].op == ir::OpKind::kStatement) break;
        for (const ir::ValueId used : ir::UsedValues(program_, program_[insts[k]])) uses_result |= used == insts[i];
      }
      if (uses_result) continue;
    }
    Inst(insts[i]);
  }
  close();
}

void PartPrinter::RegionBody(ir::RegionId region) {
  const std::vector<uint32_t>& chunks = emittable_.region_chunks[region.index];
  if (chunks.empty()) {
    Range(region, 0, static_cast<uint32_t>(program_.regions[region].insts.size()));
    return;
  }
  uint32_t part = 0;
  for (const uint32_t index : chunks) {
    const Chunk& chunk = emittable_.chunks[index];
    if (chunk.part == part_) {
      Line(chunk.name + "(m, host);");
    } else if (chunk.part != part) {
      Line(emittable_.parts[chunk.part].entry + "(m, host);");
      part = chunk.part;
    }
  }
}

void PartPrinter::Chunks() {
  bool any = false;
  for (const Chunk& chunk : emittable_.chunks) {
    if (chunk.part != part_) continue;
    // A chunk is its region's items; called from one place, it would be inlined into one huge function again.
    if (!any) out_ += "namespace {\n\n";
    any = true;
    OpenFunction("[[gnu::noinline]] void " + chunk.name, {"State& m", "Host& host"});
    Range(chunk.region, chunk.begin, chunk.end);
    CloseFunction();
  }
  if (any) out_ += "}  // namespace\n\n";
}

void PartPrinter::InitStorage() {
  for (const Member& member : emittable_.layout.members) {
    if (member.name == "retentive") {
      Line("m.retentive = Retentive{};");
      Line("m.retentive.layout = kRetentiveLayout;");
    } else {
      Line("Clear(m." + member.name + ");");
    }
  }
  for (uint32_t s = 0; s < program_.spaces.size(); ++s) {
    for (const ir::InitialByte& initial : program_.spaces[ir::SpaceId(s)].initial) {
      const ByteStorage& stored = emittable_.layout.bytes[s][initial.offset];
      constexpr char kHex[] = "0123456789ABCDEF";
      const std::string value = std::string("0x") + kHex[initial.value >> 4] + kHex[initial.value & 15];
      if (stored.whole.storage == Storage::kRetentiveByte) {
        Line("m.retentive.bytes[" + std::to_string(stored.whole.index) + "] = " + value + ";");
      } else if (stored.whole.storage == Storage::kByte) {
        Line("m.byte[" + std::to_string(stored.whole.index) + "] = " + value + ";");
      } else {
        for (int bit = 0; bit < 8; ++bit) {
          if (stored.bits[bit].storage == Storage::kBit && (initial.value >> bit & 1) != 0) {
            Line("m.bit[" + std::to_string(stored.bits[bit].index) + "] = true;");
          }
        }
      }
    }
  }
  if (debug()) Line("m.ReapplyForces();");
}

void PartPrinter::OpenFunction(const std::string& head, std::vector<std::string> parameters) {
  function_head_ = head;
  parameters_ = std::move(parameters);
  body_begin_ = out_.size();
  next_local_ = 1;
  indent_ = 1;
}

void PartPrinter::CloseFunction() {
  const std::string_view body = std::string_view(out_).substr(body_begin_);
  // A parameter that the body does not name must not be a warning: it gets no name.
  const auto named = [body](std::string_view name) {
    for (size_t line = 0; line < body.size();) {
      const size_t end = std::min(body.find('\n', line), body.size());
      const std::string_view text = body.substr(line, end - line);
      line = end + 1;
      if (text.find_first_not_of(' ') != std::string_view::npos &&
          text.substr(text.find_first_not_of(' ')).starts_with("//"))
        continue;
      for (size_t at = text.find(name); at != std::string_view::npos; at = text.find(name, at + 1)) {
        const auto letter = [](char c) {
          return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
        };
        const bool begins = at == 0 || !letter(text[at - 1]);
        const bool ends = at + name.size() == text.size() || !letter(text[at + name.size()]);
        if (begins && ends) return true;
      }
    }
    return false;
  };
  std::string head = function_head_ + "(";
  for (size_t i = 0; i < parameters_.size(); ++i) {
    const size_t blank = parameters_[i].rfind(' ');
    head += (i == 0 ? "" : ", ") +
            (named(parameters_[i].substr(blank + 1)) ? parameters_[i] : parameters_[i].substr(0, blank));
  }
  out_.insert(body_begin_, head + ") noexcept {\n");
  out_ += "}\n\n";
  indent_ = 0;
}

void PartPrinter::Routines() {
  for (const ir::Routine& routine : program_.routines) {
    if (routine.simulation_only && !debug()) continue;
    if (!routine.comment.empty()) Comment(routine.comment);
    std::vector<std::string> parameters = {"State& m"};
    for (const ir::Parameter& parameter : routine.parameters) {
      parameters.push_back(std::string(ir::CppName(parameter.type)) + " " + parameter.name);
    }
    parameters.emplace_back("Host& host");
    OpenFunction(std::string(ir::CppName(routine.result)) + " " + routine.name, std::move(parameters));
    if (routine.kind == ir::RoutineKind::kInit) InitStorage();
    // What the control does before and after the statements stands apart from them.
    for (const ir::RegionId region : {routine.prologue, routine.body, routine.epilogue}) {
      if (!region.valid() || program_.regions[region].insts.empty()) continue;
      if (out_.size() > body_begin_) out_ += '\n';
      statement_ = {};
      RegionBody(region);
    }
    CloseFunction();
  }
}

void PartPrinter::Includes() {
  const std::string& suffix = emittable_.parts[part_].suffix;
  out_ += "// " + emittable_.options.name + suffix +
          ".cpp: generated by plcxx. Do not edit: change the PLC program and run plcxx again.\n";
  out_ += "#include \"" + emittable_.options.name + ".hpp\"\n\n";
  if (part_ == 0) {
    out_ += "#include <stddef.h>\n\n";
  }
}

void PartPrinter::Using() {
  std::vector<std::string> names = emittable_.functions;
  if (part_ == 0) names.insert(std::upper_bound(names.begin(), names.end(), "Clear"), "Clear");
  for (const std::string& name : names) out_ += "using plcxx::" + name + ";\n";
  if (!names.empty()) out_ += '\n';
}

std::string PartPrinter::Run() {
  Includes();
  out_ += "namespace " + emittable_.namespace_name + " {\n\n";
  Using();
  if (part_ == 0) {
    for (size_t i = 1; i < emittable_.parts.size(); ++i) {
      out_ += "void " + emittable_.parts[i].entry + "(State& m, Host& host) noexcept;\n";
      if (i + 1 == emittable_.parts.size()) out_ += '\n';
    }
    for (const Member& member : emittable_.layout.members) {
      out_ += "static_assert(offsetof(State, " + member.name + ") == " + std::to_string(member.offset) +
              ", \"the symbol map holds for this layout\");\n";
    }
    if (!emittable_.layout.members.empty()) out_ += '\n';
  }
  Chunks();
  if (part_ == 0) {
    Routines();
  } else {
    const std::string& entry = emittable_.parts[part_].entry;
    out_ += "void " + entry + "(State& m, Host& host) noexcept;\n";
    out_ += "void " + entry + "(State& m, Host& host) noexcept {\n";
    for (const Chunk& chunk : emittable_.chunks) {
      if (chunk.part == part_ && chunk.top_level) out_ += "  " + chunk.name + "(m, host);\n";
    }
    out_ += "}\n\n";
  }
  out_ += "}  // namespace " + emittable_.namespace_name + "\n";
  return std::move(out_);
}

}  // namespace

std::string PrintPart(const Emittable& emittable, const source::SourceManager& sources, uint32_t part) {
  return PartPrinter(emittable, sources, part).Run();
}

}  // namespace plcxx::emit
