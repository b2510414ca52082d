#include "transpiler/dialects/technol/analysis/warnings.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <tuple>

#include "transpiler/dialects/technol/analysis/accesses.h"
#include "transpiler/dialects/technol/parser/parser.h"

namespace plcxx::technol {
namespace {

constexpr uint8_t kAnyBit = 8;

class Warner {
 public:
  Warner(const Flow& flow, diag::Engine& diagnostics)
      : flow_(flow), program_(flow.program()), diagnostics_(diagnostics), accesses_(AccessesOf(program_)) {}

  void Run() {
    DoubleCoils();
    ReadsAndWrites();
    Mechanisms();
    ControlOwned();
    Requests();
    SharedByParts();
  }

 private:
  template <class... Args, class... Values>
  void At(InstructionId id, const diag::Message<Args...>& message, Values&&... values) {
    Report(diagnostics_, program_, program_.instructions[id], message, std::forward<Values>(values)...);
  }
  const std::string& NameOf(const Operand& operand) const { return program_.symbols[operand.symbol].name; }
  /// The module that an instruction belongs to: of a mechanism the one around it.
  UnitId ModuleOf(InstructionId id) const {
    UnitId unit = program_.instructions[id].unit;
    while (unit.valid() && program_.units[unit].parent.valid()) unit = program_.units[unit].parent;
    return unit;
  }
  std::string UnitName(UnitId unit) const {
    if (!unit.valid() || program_.units[unit].kind == UnitKind::kSubprograms) return "the subprograms";
    return program_.units[unit].name;
  }

  void DoubleCoils();
  void ReadsAndWrites();
  void Mechanisms();
  void ControlOwned();
  void Requests();
  void SharedByParts();

  const Flow& flow_;
  const Program& program_;
  diag::Engine& diagnostics_;
  std::vector<MemoryAccess> accesses_;
};

/// TW006: by WR at two places of a module, or by WR and FL there.
void Warner::DoubleCoils() {
  struct Written {
    bool first_is_coil = false, by_coil = false;
  };
  std::map<std::tuple<UnitId, UnitId, Area, int64_t, uint8_t>, Written> bits;  // by module, then mechanism or place
  for (const MemoryAccess& access : accesses_) {
    const Operand& operand = *access.operand;
    if (!Writes(access.kind) || access.kind == AccessKind::kStore || operand.kind != OperandKind::kBit) continue;
    const UnitId module = ModuleOf(access.at);
    const bool coil = access.kind == AccessKind::kCoil;
    const auto [found, is_first] =
        operand.is_activation_bit()
            ? bits.try_emplace({module, operand.mechanism, Area::kNone, 0, uint8_t{0}})
            : bits.try_emplace({module, UnitId(), operand.address.area, operand.address.offset, operand.bit});
    Written& before = found->second;
    if (is_first) {
      before.first_is_coil = coil;
    } else if (coil && before.first_is_coil) {
      At(access.at, diag::TechnolDoubleCoil, NameOf(operand), UnitName(module));
    } else if (coil || before.by_coil) {
      At(access.at, diag::TechnolCoilAndFlag, NameOf(operand), UnitName(module));
    }
    before.by_coil |= coil;
  }
}

/// TW007, TW008: cells and bits of the program's own data. A value that is declared counts as written.
void Warner::ReadsAndWrites() {
  TouchedMemory reads, writes;
  for (const MemoryAccess& access : accesses_) (Writes(access.kind) ? writes : reads).Add(*access.operand);
  std::set<SymbolId> carriers;  // a byte that no instruction names is known by its bits, which are looked at
  for (const Symbol& symbol : program_.symbols) {
    if (symbol.kind == SymbolKind::kBit && symbol.byte.valid()) carriers.insert(symbol.byte);
  }
  for (uint32_t i = 0; i < program_.symbols.size(); ++i) {
    const Symbol& symbol = program_.symbols[SymbolId(i)];
    const bool bit = symbol.kind == SymbolKind::kBit;
    if (symbol.uses == 0 && carriers.contains(SymbolId(i))) continue;
    if (symbol.origin != SymbolOrigin::kSource || (!bit && symbol.kind != SymbolKind::kCell)) continue;
    if (symbol.area != Area::kUser && symbol.area != Area::kOut && symbol.area != Area::kIn) continue;
    const uint32_t bytes = bit ? 1 : symbol.bytes;
    const uint8_t which = bit ? symbol.bit : kAnyBit;
    const bool read = reads.Holds(symbol.area, symbol.offset, bytes, which);
    const bool written = writes.Holds(symbol.area, symbol.offset, bytes, which);
    const std::string kind = bit ? "bit" : "cell";
    if (read && !written && symbol.area != Area::kIn) {
      const auto end = std::min<size_t>(symbol.offset + bytes, program_.user_data.size());
      const bool declared =
          symbol.area == Area::kUser &&
          std::any_of(program_.user_data.begin() + symbol.offset,
                      program_.user_data.begin() + static_cast<ptrdiff_t>(end), [](uint8_t byte) { return byte != 0; });
      if (!declared) diagnostics_.Report(symbol.range, diag::TechnolNeverWritten, kind, symbol.name);
    }
    if (written && !read && symbol.area == Area::kUser) {
      diagnostics_.Report(symbol.range, diag::TechnolNeverRead, kind, symbol.name);
    }
  }
}

/// TW009.
void Warner::Mechanisms() {
  std::set<UnitId> started;
  for (const MemoryAccess& access : accesses_) {
    const bool sets = access.kind == AccessKind::kSet || access.kind == AccessKind::kCoil;
    if (sets && access.operand->is_activation_bit()) started.insert(access.operand->mechanism);
  }
  for (uint32_t i = 0; i < program_.units.size(); ++i) {
    const Unit& unit = program_.units[UnitId(i)];
    if (unit.kind != UnitKind::kMechanism || started.contains(UnitId(i))) continue;
    diagnostics_.Report(unit.open, diag::TechnolNeverActivated, unit.name);
  }
}

/// TW012: what the control or the machine writes.
void Warner::ControlOwned() {
  std::map<Area, std::vector<const Symbol*>> owned;
  for (const Symbol& symbol : program_.symbols) {
    const bool cell = symbol.kind == SymbolKind::kCell && symbol.bytes <= 4 && symbol.origin != SymbolOrigin::kSource;
    if (!cell || (symbol.direction != Direction::kMachineIn && symbol.direction != Direction::kNcToPlc)) continue;
    if (symbol.area == Area::kSys && symbol.name == "SYSNC") continue;  // its bits are the scheduler's
    owned[symbol.area].push_back(&symbol);
  }
  std::set<InstructionId> reported;
  for (const MemoryAccess& access : accesses_) {
    if (!Writes(access.kind) || access.operand->is_activation_bit()) continue;
    const Address& address = access.operand->address;
    const uint32_t bytes = access.operand->kind == OperandKind::kBit ? 1 : access.operand->width / 8U;
    const auto here = owned.find(address.area);
    if (here == owned.end()) continue;
    for (const Symbol* of_area : here->second) {
      const Symbol& symbol = *of_area;
      const bool touches = address.index == Register::kNone
                               ? Touches(*access.operand, symbol.area, symbol.offset, symbol.bytes, kAnyBit)
                               : address.offset >= symbol.offset && address.offset < symbol.offset + symbol.bytes;
      if (!touches || bytes == 0 || !reported.insert(access.at).second) continue;
      At(access.at, diag::TechnolAgainstDirection,
         access.operand->symbol.valid() ? NameOf(*access.operand) : symbol.name,
         symbol.direction == Direction::kMachineIn ? "the machine writes it" : "the control writes it");
    }
  }
}

/// TW013, TW014, TW024: the request bits.
void Warner::Requests() {
  struct Request {
    InstructionId first_set;
    std::vector<UnitId> mechanisms;
    bool waited = false;
  };
  std::map<std::pair<int64_t, uint8_t>, Request> requests;
  const auto is_request = [&](const Operand& operand) {
    return operand.kind == OperandKind::kBit && !operand.is_activation_bit() && operand.address.area == Area::kSys &&
           operand.symbol.valid() && program_.symbols[operand.symbol].name.starts_with("REQ_");
  };
  for (const MemoryAccess& access : accesses_) {
    if (!is_request(*access.operand)) continue;
    Request& request = requests[{access.operand->address.offset, access.operand->bit}];
    const UnitId unit = program_.instructions[access.at].unit;
    const std::string& name = NameOf(*access.operand);
    if (access.kind == AccessKind::kRead) request.waited = true;
    if (access.kind == AccessKind::kClear) At(access.at, diag::TechnolRequestCleared, name);
    if (access.kind != AccessKind::kSet && access.kind != AccessKind::kCoil) continue;
    if (!request.first_set.valid()) request.first_set = access.at;
    if (!unit.valid() || program_.units[unit].kind != UnitKind::kMechanism) continue;
    if (std::ranges::find(request.mechanisms, unit) != request.mechanisms.end()) continue;
    if (request.mechanisms.size() == 1) {
      At(access.at, diag::TechnolRequestShared, name, UnitName(request.mechanisms.front()), UnitName(unit));
    }
    request.mechanisms.push_back(unit);
  }
  for (const auto& [where, request] : requests) {
    if (!request.first_set.valid() || request.waited) continue;
    for (const MemoryAccess& access : accesses_) {
      if (access.at != request.first_set || !is_request(*access.operand)) continue;
      // The control never clears REQ_PIS_HALT: nothing can wait for its end.
      if (NameOf(*access.operand) != "REQ_PIS_HALT")
        At(access.at, diag::TechnolRequestNotWaited, NameOf(*access.operand));
    }
  }
}

/// TW025: wider than a byte, written in both parts.
void Warner::SharedByParts() {
  const auto is_fast = [&](InstructionId id) {
    const UnitId unit = ModuleOf(id);
    return unit.valid() && program_.units[unit].kind == UnitKind::kModule &&
           program_.units[unit].module == ModuleKind::kFast;
  };
  TouchedMemory slow;
  for (const MemoryAccess& access : accesses_) {
    const UnitId unit = ModuleOf(access.at);
    const bool counts = unit.valid() && program_.units[unit].kind != UnitKind::kSubprograms &&
                        program_.units[unit].module != ModuleKind::kInit;
    if (Writes(access.kind) && counts && !is_fast(access.at)) slow.Add(*access.operand);
  }
  std::set<std::tuple<Area, int64_t>> reported;
  for (const MemoryAccess& fast : accesses_) {
    const Operand& operand = *fast.operand;
    if (!Writes(fast.kind) || !is_fast(fast.at) || operand.kind != OperandKind::kMemory || operand.width <= 8) continue;
    const Address& address = operand.address;
    const auto offset = static_cast<uint32_t>(address.offset);
    if (address.index != Register::kNone || !slow.Holds(address.area, offset, operand.width / 8U, kAnyBit)) continue;
    if (!reported.insert({address.area, address.offset}).second) continue;
    At(fast.at, diag::TechnolSharedByParts, operand.symbol.valid() ? NameOf(operand) : ToText(program_, operand));
  }
}

}  // namespace

void Warn(const Flow& flow, diag::Engine& diagnostics) { Warner(flow, diagnostics).Run(); }

}  // namespace plcxx::technol
