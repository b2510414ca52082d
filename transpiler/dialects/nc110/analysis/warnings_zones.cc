#include <bitset>

#include "transpiler/dialects/nc110/analysis/accesses.h"
#include "transpiler/dialects/nc110/analysis/warnings.h"
#include "transpiler/dialects/nc110/machine/signals.h"

namespace plcxx::nc110 {
namespace {

constexpr uint32_t kMostConnectors = 256;

class ZoneChecker {
 public:
  ZoneChecker(const CheckedProgram& program, diag::Engine& diagnostics)
      : program_(program), diagnostics_(diagnostics), pair_of_(kAllPackageBytes) {}

  void Run();

 private:
  void CheckDirection(const Access& access);
  void CheckPair(const Access& access);
  static uint32_t Index(const Operand& operand) { return PackageBase(operand.package) + ByteOf(operand); }

  const CheckedProgram& program_;
  diag::Engine& diagnostics_;
  std::bitset<kMostConnectors> unassigned_seen_, free_n_seen_;
  std::vector<Operand> pair_of_;  // by byte: the pair whose high byte it is
};

void ZoneChecker::Run() {
  bool pairs = false;
  ForEachAccess(program_.tree, [&](const Access& access) {
    if (access.kind == AccessKind::kPair) {
      pair_of_[Index(HighByteOf(access.operand))] = access.operand;
      pairs = true;
    }
    CheckDirection(access);
  });
  if (!pairs) return;
  ForEachAccess(program_.tree, [this](const Access& access) { CheckPair(access); });
}

void ZoneChecker::CheckDirection(const Access& access) {
  const Operand& operand = access.operand;
  if (!IsMemory(operand)) return;
  const uint32_t processes = program_.settings.processes;
  const ir::Direction direction = DirectionOf(operand.package, operand.number, processes);
  const bool writes = IsWrite(access.kind);
  if (operand.package == Package::kA) {
    if (direction == ir::Direction::kInput && writes) {
      diagnostics_.Report(access.range, diag::Nc110InputWrite, ToText(operand));
    }
    if (direction == ir::Direction::kInternal && !unassigned_seen_[operand.number]) {
      unassigned_seen_.set(operand.number);
      diagnostics_.Report(access.range, diag::Nc110UnassignedConnector, ToText(operand));
    }
  } else if (direction == ir::Direction::kInput && writes && !IsAcknowledgement(operand)) {
    const std::string name = PredefinedName(operand, processes);
    diagnostics_.Report(access.range, diag::Nc110NcSignalWrite, ToText(operand),
                        name.empty() ? std::string("an NC to PLC signal") : "its signal " + name);
  } else if (operand.package == Package::kN && direction == ir::Direction::kInternal && writes &&
             !free_n_seen_[operand.number]) {
    free_n_seen_.set(operand.number);
    diagnostics_.Report(access.range, diag::Nc110FreeNWrite, ToText(operand));
  }
}

void ZoneChecker::CheckPair(const Access& access) {
  // A constant is how a program keeps the high byte 0.
  if (!IsMemory(access.operand) || access.kind == AccessKind::kWriteConstant) return;
  const Operand& pair = pair_of_[Index(access.operand)];
  if (pair.kind == OperandKind::kNone) return;
  diagnostics_.Report(access.range, diag::Nc110PairHighByte, ToText(access.operand), ToText(pair));
}

}  // namespace

void CheckZones(const CheckedProgram& program, diag::Engine& diagnostics) { ZoneChecker(program, diagnostics).Run(); }

}  // namespace plcxx::nc110
