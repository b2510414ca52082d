// W01, W02, W03, W07, W08, W11, W12, W21, N04: who reads and writes which address.
#include <array>
#include <map>
#include <set>
#include <utility>

#include "transpiler/dialects/host50/analysis/accesses.h"
#include "transpiler/dialects/host50/analysis/warnings.h"
#include "transpiler/dialects/host50/machine/signals.h"

namespace plcxx::host50 {
namespace {

/// An address without its attribute.
using Key = std::pair<Area, uint32_t>;
Key PlaceOf(const Address& address) { return {address.area, address.number}; }

/// As written, with the address where that is another text: "PUMP (%Q0)".
std::string Shown(const source::SourceManager& sources, source::Range range, const Address& address) {
  const std::string_view text = sources.Text(range);
  const std::string canonical = ToText(address);
  return EqualIgnoringCase(text, canonical) ? canonical : std::string(text) + " (" + canonical + ")";
}

Address BitOfAccess(const Access& access, uint32_t bit) {
  Address address = access.address;
  address.number = static_cast<uint16_t>(address.number + bit);
  return address;
}

bool IsAlarm(const Address& address) {
  return address.area == Area::kQ && address.number >= kFirstAlarm && address.number < kFirstAlarm + kAlarmCount;
}

class AccessChecks {
 public:
  AccessChecks(const Program& program, const source::SourceManager& sources, diag::Engine& diagnostics)
      : program_(program), sources_(sources), diagnostics_(diagnostics), accesses_(AccessesOf(program)) {
    for (const Access& access : accesses_) {
      if (access.kind != Access::Kind::kWrite) continue;
      for (uint32_t bit = 0; bit < access.bits; ++bit) written_.insert(PlaceOf(BitOfAccess(access, bit)));
    }
  }

  /// Those that one access shows by itself.
  void CheckSingle() {
    for (const Access& access : accesses_) {
      CheckOverwritten(access);
      CheckDocumented(access);
    }
  }

  /// Those for which all of the program must be known.
  void CheckTogether() {
    for (const Access& access : accesses_) {
      CheckCoil(access);
      CheckSections(access);
      CheckWritten(access);
      CheckRun(access);
      CheckAlarm(access);
    }
    if (program_.sections.empty()) return;  // tables only
    for (const Alarm& alarm : program_.alarms) {
      const Address address = {.area = Area::kQ, .number = static_cast<uint16_t>(kFirstAlarm + alarm.index)};
      if (alarm.text.empty() || written_.contains(PlaceOf(address))) continue;
      diagnostics_.Report(alarm.range, diag::Host50AlarmNotDriven, ToText(address));
    }
  }

 private:
  template <class... Args>
  void Report(const Access& access, const diag::Message<Args...>& message, std::type_identity_t<Args>... args) {
    diagnostics_.Report(access.range, message, args...);
  }
  /// Of a bit of the access.
  std::string TextOf(const Access& access, const Address& bit) const {
    return access.bits == 1 ? Shown(sources_, access.range, bit) : ToText(bit);
  }
  SectionKind SectionOf(const Access& access) const {
    const NetworkId network = program_.instructions[access.instruction].network;
    return program_.sections[program_.networks[network].section].kind;
  }

  void CheckOverwritten(const Access& access) {
    const AreaInfo& area = Info(access.address.area);
    if (access.kind != Access::Kind::kWrite || area.writer != Writer::kHost) return;
    Report(access, diag::Host50Overwritten, TextOf(access, access.address));
  }

  /// W11: signals of the NC that its list does not have; one warning for a field.
  void CheckDocumented(const Access& access) {
    const Area area = access.kind == Access::Kind::kRead ? Area::kI : Area::kQ;
    if (access.address.area != area) return;
    bool reported = false;
    for (uint32_t bit = 0; bit < access.bits; ++bit) {
      const Address address = BitOfAccess(access, bit);
      if (address.number < kFirstNcBit || !SignalsAt(address).empty()) continue;
      if (!undocumented_.insert(PlaceOf(address)).second || std::exchange(reported, true)) continue;
      Report(access, diag::Host50Undocumented, TextOf(access, address));
    }
  }

  /// W01, W02.
  void CheckCoil(const Access& access) {
    const Op op = program_.instructions[access.instruction].op;
    const bool out = op == Op::kOut || op == Op::kOuti;
    if (access.kind != Access::Kind::kWrite || (!out && op != Op::kSet && op != Op::kRst)) return;
    const std::string text = TextOf(access, access.address);
    Coils& coils = coils_[PlaceOf(access.address)];
    if (out && coils.out != nullptr) {
      diagnostics_.Report(access.range, diag::Host50DoubleCoil, text)
          .notes.push_back({coils.out->range, "the first one is here"});
    }
    const Access*& same = out ? coils.out : coils.set;
    const Access* other = out ? coils.set : coils.out;
    if (same == nullptr && other != nullptr) {
      diagnostics_.Report(access.range, diag::Host50OutAndSet, text)
          .notes.push_back({other->range, "the other kind of coil is here"});
    }
    if (same == nullptr) same = &access;
  }

  /// W03: bits only, since those are what coils share.
  void CheckSections(const Access& access) {
    if (access.kind != Access::Kind::kWrite || TypeOf(access.address) != Type::kBit) return;
    if (!in_fast_) {
      in_fast_.emplace();
      for (const Access& other : accesses_) {
        if (other.kind != Access::Kind::kWrite || SectionOf(other) != SectionKind::kFast) continue;
        for (uint32_t bit = 0; bit < other.bits; ++bit) in_fast_->insert(PlaceOf(BitOfAccess(other, bit)));
      }
    }
    if (SectionOf(access) == SectionKind::kFast) return;
    bool reported = false;
    for (uint32_t bit = 0; bit < access.bits; ++bit) {
      const Address address = BitOfAccess(access, bit);
      if (in_fast_->erase(PlaceOf(address)) == 0 || std::exchange(reported, true)) continue;
      Report(access, diag::Host50FastAndSlow, TextOf(access, address));
    }
  }

  /// W07.
  void CheckWritten(const Access& access) {
    const Area area = access.address.area;
    if (access.kind != Access::Kind::kRead || (area != Area::kB && area != Area::kW && area != Area::kF)) return;
    bool reported = false;
    for (uint32_t bit = 0; bit < access.bits; ++bit) {
      const Address address = BitOfAccess(access, bit);
      if (IsRetentive(address) || written_.contains(PlaceOf(address))) continue;
      if (!unwritten_.insert(PlaceOf(address)).second || std::exchange(reported, true)) continue;
      Report(access, diag::Host50NeverWritten, TextOf(access, address));
    }
  }

  /// W22.
  void CheckRun(const Access& access) {
    const Area area = access.address.area;
    if (access.kind != Access::Kind::kRead || (area != Area::kTm && area != Area::kC)) return;
    if (!run_) {
      run_.emplace();
      for (const Operand& operand : program_.operands) {
        const bool names = operand.role == OperandRole::kTimer || operand.role == OperandRole::kCounter;
        if (names && operand.kind == OperandKind::kAddress) run_->insert(PlaceOf(operand.address));
      }
    }
    // A counter's value may be all that is used of it: as a word that is kept at power-off.
    if (run_->contains(PlaceOf(access.address)) || written_.contains(PlaceOf(access.address))) return;
    Address whole = access.address;
    whole.attribute = Attribute::kNone;
    if (run_->insert(PlaceOf(whole)).second) Report(access, diag::Host50ReadNeverRun, TextOf(access, whole));
  }

  /// W12.
  void CheckAlarm(const Access& access) {
    if (access.kind != Access::Kind::kWrite) return;
    if (alarm_texts_.empty()) {
      alarm_texts_.resize(kAlarmCount);
      for (const Alarm& alarm : program_.alarms) alarm_texts_[alarm.index] = !alarm.text.empty();
    }
    for (uint32_t bit = 0; bit < access.bits; ++bit) {
      const Address address = BitOfAccess(access, bit);
      if (!IsAlarm(address) || alarm_texts_[address.number - kFirstAlarm]) continue;
      alarm_texts_[address.number - kFirstAlarm] = true;  // the first write only
      Report(access, diag::Host50NoAlarmText, TextOf(access, address));
    }
  }

  struct Coils {
    const Access* out = nullptr;  // the first OUT or OUTI
    const Access* set = nullptr;  // the first SET or RST
  };

  const Program& program_;
  const source::SourceManager& sources_;
  diag::Engine& diagnostics_;
  std::vector<Access> accesses_;
  std::set<Key> written_, undocumented_, unwritten_;
  std::map<Key, Coils> coils_;
  std::optional<std::set<Key>> in_fast_;  // written in FAST, not yet reported
  std::optional<std::set<Key>> run_;      // timers and counters with a block, and those that were reported
  std::vector<bool> alarm_texts_;         // by alarm: it has a text, or its lack was reported
};

}  // namespace

void CheckAccesses(const Program& program, const source::SourceManager& sources, diag::Engine& diagnostics) {
  AccessChecks checks(program, sources, diagnostics);
  checks.CheckSingle();
  if (!program.faulty) checks.CheckTogether();
}

void CheckAxisSignals(const Program& program, const source::SourceManager& sources, diag::Engine& diagnostics) {
  std::map<Key, const Instruction*> owners;
  const uint32_t base = program.settings.axisbase == AxisBaseOption::kZero ? 0 : 1;
  for (const Instruction& instruction : program.instructions) {
    const AxisBlock* block = instruction.unknown ? nullptr : AxisBlockOf(instruction.op);
    if (block == nullptr || instruction.operands.count == 0) continue;
    const Operand& axis = program.operands[instruction.operands.first];
    if (axis.kind != OperandKind::kConstant || instruction.faulty) continue;
    const uint32_t index = axis.bits - base;
    for (const uint32_t bit : {kAxisMove, kAxisPositionMode, kAxisAbsolute, kAxisHoming}) {
      owners.emplace(Key(Area::kQ, bit + index), &instruction);
    }
    if (block->method != AxisValue::kNotWritten) owners.emplace(Key(Area::kQw, kAxisMethod + index), &instruction);
    if (block->speed != AxisValue::kNotWritten) owners.emplace(Key(Area::kQf, kAxisSpeed + index), &instruction);
    if (block->position != AxisValue::kNotWritten) owners.emplace(Key(Area::kQf, kAxisPosition + index), &instruction);
  }
  for (const Access& access : AccessesOf(program)) {
    if (access.kind != Access::Kind::kWrite) continue;
    for (uint32_t bit = 0; bit < access.bits; ++bit) {
      const Address address = BitOfAccess(access, bit);
      const auto owner = owners.find(PlaceOf(address));
      if (owner == owners.end()) continue;
      const std::string text = access.bits == 1 ? Shown(sources, access.range, address) : ToText(address);
      diagnostics.Report(access.range, diag::Host50AxisSignal, text, Info(owner->second->op).name)
          .notes.push_back({owner->second->range, "the block is here"});
      break;
    }
  }
}

}  // namespace plcxx::host50
