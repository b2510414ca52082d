// The host as compiled code meets it: the same functions of what it has been told as in the execution of the IR.
#pragma once

#include <string>
#include <vector>

#include "transpiler/emit/emittable.h"
#include "transpiler/prove/compiled/compiled_code.h"
#include "transpiler/prove/compiled/state_image.h"
#include "transpiler/prove/execute/execute.h"

namespace plcxx::prove {

/// What a host function has been told when it has read `bytes` of the state.
TermId HavingSeen(Terms& terms, const std::string& function, TermId calls, std::span<const TermId> bytes);

/// A byte of the copy of retentive memory that the host may have.
TermId StoredByte(Terms& terms, const std::string& space, uint32_t offset);

class HostSurroundings : public CodeSurroundings {
 public:
  HostSurroundings(Terms& terms, const emit::Emittable& emittable, const StateImage& image, TermId now,
                   std::function<TermId(uint32_t slot)> initial)
      : terms_(terms), emittable_(emittable), image_(image), now_(now), initial_(std::move(initial)) {}

  TermId Initial(uint32_t slot) override { return initial_(slot); }
  TermId CallHost(CodeMemory& memory, const HostRequest& request, std::string& refusal) override;

 private:
  void WriteState(CodeMemory& memory, const ir::HostFunction& host, TermId calls);
  void WriteRetentive(CodeMemory& memory, uint32_t slot, const ir::HostFunction& host, TermId calls);

  Terms& terms_;
  const emit::Emittable& emittable_;
  const StateImage& image_;
  TermId now_;
  std::function<TermId(uint32_t slot)> initial_;
};

}  // namespace plcxx::prove
