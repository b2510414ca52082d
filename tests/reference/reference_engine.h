// A reference as an engine, so that it runs in lockstep with the simulator under the machinery of scenarios.
//
// In: the reference, the program, the simulator beside it. Out: snapshots that are the simulator's own with everything
// replaced that the reference knows: the memory that the host sees, and the fields of elements that a scenario can
// name. What is left (elapsed times, edges) is not compared; it shows in what depends on it.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tests/reference/reference.h"
#include "transpiler/ir/program.h"
#include "transpiler/sim/engine.h"
#include "transpiler/sim/simulator.h"

namespace plcxx::reference {

class ReferenceEngine : public sim::Engine {
 public:
  using Make = std::function<std::unique_ptr<Reference>(HostCalls host)>;

  /// `program` and `beside` outlive the engine.
  ReferenceEngine(const ir::Program& program, sim::Simulator& beside, const Make& make);

  const Reference& reference() const { return *reference_; }
  /// What one snapshot compares: bytes of memory and fields of elements.
  uint64_t compared() const { return compared_; }
  /// What the program has and the reference has not (a space, a host function) and the other way round.
  const std::vector<std::string>& mismatches() const { return mismatches_; }

  std::string_view name() const override { return "reference"; }
  void PowerOn() override { reference_->PowerOn(); }
  void RunPeriod(uint32_t now_ms) override { reference_->RunPeriod(now_ms); }
  void RunFastOnly(uint32_t now_ms) override { reference_->RunFastOnly(now_ms); }
  void RunElapse(uint32_t now_ms) override { reference_->RunElapse(now_ms); }
  void AnswerHostCalls(sim::HostAnswers answers) override { answers_ = std::move(answers); }
  uint64_t Read(const ir::Place& place) override;
  void Write(const ir::Place& place, uint64_t value) override;
  void Force(const ir::Place& place, uint64_t value) override;
  void Release(const ir::Place& place) override;
  void SendText(std::string_view text) override { reference_->SendText(text); }
  /// A reference has no debugger.
  void EnableStatement(ir::StatementId, bool) override {}
  void StoreRetentive() override { reference_->StoreRetentive(); }
  std::vector<sim::HostEvent> TakeEvents() override;
  std::vector<uint8_t> Snapshot() override;

 private:
  static constexpr uint32_t kNone = 0xFFFFFFFF;

  struct KnownField {
    std::string name;  // empty: the reference does not know it
    Element element;
    size_t at = 0;  // in a snapshot
    uint32_t bytes = 1;
  };

  Answer Call(std::string_view function, const std::vector<uint64_t>& arguments);
  AddressSpace* MemoryOf(const ir::Place& place);
  KnownField* FieldOf(const ir::Place& place);
  uint32_t ByteAt(const ir::Place& place, uint32_t significance) const;

  const ir::Program& program_;
  sim::Simulator& beside_;
  std::unique_ptr<Reference> reference_;
  std::vector<uint32_t> memory_of_space_;        // by SpaceId: an index of Reference::memories
  std::vector<size_t> space_at_;                 // by SpaceId: where its bytes begin in a snapshot
  std::vector<std::vector<KnownField>> fields_;  // by StateId and field
  std::vector<std::string> mismatches_;
  uint64_t compared_ = 0;
  sim::HostAnswers answers_;
  std::vector<sim::HostEvent> events_;
};

}  // namespace plcxx::reference
