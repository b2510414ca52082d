// Axis blocks: writers of the signals of the PLC axes, and what they tell the control (6.8).
#pragma once

#include <functional>
#include <string_view>

#include "transpiler/dialects/host50/lowering/context.h"
#include "transpiler/dialects/host50/lowering/host_calls.h"

namespace plcxx::host50 {

class Cells;
class Faults;
class Logic;
class Numbers;
class OwnInstances;
class Results;

class Axes : Context {
 public:
  Axes(const Context& context, HostCalls& host, Cells& cells, OwnInstances& instances, Faults& faults, Logic& logic,
       Numbers& numbers, Results& results);

  void Command(InstructionId id);

 private:
  /// One axis block; the numbers are known where it is active.
  struct AxisRequest {
    const Instruction* instruction = nullptr;
    const AxisBlock* block = nullptr;
    uint32_t kind = 0;
    ir::StateId state;
    ir::ValueId method, position, speed;
  };
  void CommandKnownAxis(AxisRequest request, uint32_t axis, ir::ValueId input);
  void CommandComputedAxis(AxisRequest request, ir::ValueId axis, ir::ValueId input);
  void StopAxis(const AxisRequest& request, ir::ValueId axis);
  void ReadNumbers(AxisRequest& request);
  void WriteAxisSignals(const AxisRequest& request, uint32_t axis);
  /// Tells the control when the request is new or other than before.
  void SendRequest(const AxisRequest& request, ir::ValueId axis);
  /// Whether a position or speed is another than the one last sent.
  ir::ValueId RealsDiffer(ir::ValueId now, ir::ValueId before);
  void SwitchOverAxes(ir::ValueId axis, const std::function<void(uint32_t)>& arm);
  ir::PlaceId AxisField(const AxisRequest& request, std::string_view field);

  HostCalls& host_;
  Cells& cells_;
  OwnInstances& instances_;
  Faults& faults_;
  Logic& logic_;
  Numbers& numbers_;
  Results& results_;
};

}  // namespace plcxx::host50
