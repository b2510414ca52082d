// What a soak looks at while machines run: what must not happen, messages that come and go, outputs that move.
//
// In: a program, its properties. Out: of one machine, part by part: causes of findings, and what becomes of messages
// and outputs. Not its job: running machines, judging what was seen of all of them together (soak.h).
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "transpiler/scenarios/property_machine.h"
#include "transpiler/scenarios/property_monitor.h"
#include "transpiler/soak/machines.h"

namespace plcxx::soak {

enum class CauseKind : uint8_t {
  kProperty,   // is violated
  kFault,      // the program reports one to its host
  kLoopGuard,  // a loop was ended by its guard, and nobody was told
  kStuck,      // a part was not completed in the time that it may take
  kEndless,    // a part executes more than any part should
  kMessage     // stands, whatever the inputs do
};

struct Cause {
  CauseKind kind{};
  uint32_t number = 0;   // of the property, message
  std::string key;       // the same for the same cause, and another one for another
  std::string text;      // "fault PARAM_RANGE at lathe.plc:12"
  std::string function;  // of kFault
};

/// What is looked at, the same for all machines.
class WatchPlan {
 public:
  WatchPlan(const scenarios::ProveMachine& machine, std::vector<prove::properties::Property> properties);

  const ir::Program& program() const { return *machine_.version.program; }
  const execute::Cells& cells() const { return machine_.version.cells; }
  const std::vector<prove::properties::Property>& properties() const { return properties_; }
  /// None: the call is no fault.
  std::optional<Cause> FaultOf(const sim::HostEvent& event) const;
  Cause PropertyCause(uint32_t number) const;
  static Cause MessageCause(uint32_t number, const std::string& text);
  static Cause StuckCause(PieceEnd end);

  struct Guard {
    ir::InstId executed;  // where the loop's guard has ended it
    Cause cause;
  };
  const std::vector<Guard>& guards() const { return guards_; }

  /// Bytes of outputs that the program writes, with the bits that are meant.
  struct OutputByte {
    ir::SpaceId space;
    uint32_t offset = 0;
    uint8_t mask = 0;
  };
  const std::vector<OutputByte>& outputs() const { return outputs_; }
  /// "lathe.plc:12"
  std::string PlaceOf(ir::StatementId statement) const;

 private:
  void FindGuards();
  void FindOutputs();

  const scenarios::ProveMachine& machine_;
  std::vector<prove::properties::Property> properties_;
  std::vector<bool> is_fault_;                                     // by HostFunctionId
  std::unordered_map<uint32_t, ir::StatementId> statement_of_id_;  // looked up only
  std::vector<Guard> guards_;
  std::vector<OutputByte> outputs_;
};

/// What became of a message.
struct MessageLife {
  uint64_t came = 0, went = 0;
  uint64_t stood_ms = 0;
  uint64_t steps = 0;  // in which something was done while it stood

  void Add(const MessageLife& other);
};

/// Values that each output byte had: bits that were 1, bits that were 0.
struct OutputLife {
  std::vector<uint8_t> ones, zeros;  // in the order of WatchPlan::outputs

  void Add(const OutputLife& other);
};

/// One machine's eyes.
class Watch {
 public:
  explicit Watch(const WatchPlan& plan);

  /// After PowerOn or Restore, and after a power cycle: what was before explains nothing any more.
  void BeginFrom(Machines& machines, size_t machine);
  /// `given`: of the machine, since it began.
  void AfterPart(Machines& machines, size_t machine, sim::Clock::Part part, std::span<const uint8_t> given);
  /// After a whole step, which may have done something.
  void AfterStep(Machines& machines, size_t machine);

  /// What was seen since the last call.
  std::vector<Cause> TakeCauses();
  const std::map<uint32_t, MessageLife>& messages() const { return messages_; }
  const OutputLife& outputs() const { return outputs_; }
  uint64_t parts() const { return parts_; }
  /// Messages that came in the last step.
  const std::set<uint32_t>& came() const { return came_; }

 private:
  void LookAtOutputs(sim::Engine& engine);

  const WatchPlan& plan_;
  std::vector<std::unique_ptr<scenarios::PropertyMonitor>> monitors_;
  std::vector<Cause> causes_;
  std::vector<uint32_t> active_;
  uint64_t time_ms_ = 0;
  std::map<uint32_t, MessageLife> messages_;
  std::set<uint32_t> came_;
  OutputLife outputs_;
  uint64_t parts_ = 0;
};

}  // namespace plcxx::soak
