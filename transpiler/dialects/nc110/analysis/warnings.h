// The warnings that need knowledge of the NC-110: its zones, its predefined signals, the machine's text files.
//
// In: a whole tree. Out: diagnostics only. Not its job: what is the same in every dialect (checks/), and what the
// parser sees by itself (W301 to W305, W320 to W341, W360, W364).
#pragma once

#include <cstdint>
#include <vector>

#include "transpiler/diagnostics/diagnostics.h"
#include "transpiler/dialects/nc110/machine/machine.h"
#include "transpiler/dialects/nc110/machine/options.h"
#include "transpiler/dialects/nc110/parser/help_file.h"
#include "transpiler/dialects/nc110/parser/messages_file.h"
#include "transpiler/dialects/nc110/syntax/syntax.h"

namespace plcxx::nc110 {

struct CheckedProgram {
  const Program& tree;
  const Settings& settings;
  const source::SourceManager& sources;
  const HelpTexts& help;
  const TextTable& messages;
};

/// W310 to W314: writes to inputs and to the control's signals, connectors without a direction, high bytes of pairs.
void CheckZones(const CheckedProgram& program, diag::Engine& diagnostics);
/// W358: free memory that is read and never written.
void CheckUnwritten(const CheckedProgram& program, diag::Engine& diagnostics);

/// W324: a reset or direction of a counter, a hold of a timer, that is read and never written.
void CheckUnwrittenFields(const CheckedProgram& program, diag::Engine& diagnostics);
/// W359: U = a + U without another statement that writes U.
void CheckSelfHold(const CheckedProgram& program, diag::Engine& diagnostics);
/// W354: counters whose input depends on their own count and may stay 1 from one step to the next.
void CheckSequencers(const CheckedProgram& program, diag::Engine& diagnostics);
/// W362: messages that are selected and have no text.
void CheckMessages(const CheckedProgram& program, diag::Engine& diagnostics);
/// W365: BCD words compared with decimal constants.
void CheckBcdComparisons(const CheckedProgram& program, diag::Engine& diagnostics);

/// How many statements write each bit of the packages, up to 255.
class WriteCounts {
 public:
  explicit WriteCounts(const Program& tree);
  /// The greatest count among the bits of `operand`.
  uint32_t Of(const Operand& operand) const;

 private:
  std::vector<uint8_t> counts_;
};

}  // namespace plcxx::nc110
