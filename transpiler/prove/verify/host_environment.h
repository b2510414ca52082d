// The host as compiled code meets it: the same functions of what it has been told as in the execution of the IR.
#pragma once

#include <string>
#include <vector>

#include "transpiler/emit/emittable.h"
#include "transpiler/prove/verify/compiled_code.h"
#include "transpiler/prove/verify/state_image.h"
#include "transpiler/prove/verify/units.h"
#include "transpiler/symbolic/execute/execute.h"

namespace plcxx::prove::verify {

/// What a host function has been told when it has read `bytes` of the state.
terms::TermId HavingSeen(terms::Terms& terms, const std::string& function, terms::TermId calls,
                         std::span<const terms::TermId> bytes);

/// Whether a host function that writes the state may read it at the call: it gets a reference to all of it, where the
/// code passes State.
bool MayReadState(ir::HostAccess access, Passes passes);

/// A byte of the copy of retentive memory that the host may have.
terms::TermId StoredByte(terms::Terms& terms, const std::string& space, uint32_t offset);

class HostEnvironment : public CodeEnvironment {
 public:
  HostEnvironment(terms::Terms& terms, const emit::Emittable& emittable, const execute::Cells& cells,
                  const StateImage& image, Passes passes, terms::TermId now,
                  std::function<terms::TermId(uint32_t slot)> initial)
      : terms_(terms),
        emittable_(emittable),
        cells_(cells),
        image_(image),
        passes_(passes),
        now_(now),
        initial_(std::move(initial)) {}

  terms::TermId Initial(uint32_t slot) override { return initial_(slot); }
  terms::TermId CallHost(CodeMemory& memory, const HostRequest& request, std::string& refusal) override;

 private:
  void Show(CodeMemory& memory, uint32_t slot, const ir::HostFunction& host, uint32_t counter, terms::TermId calls);
  void WriteState(CodeMemory& memory, const ir::HostFunction& host, terms::TermId calls);
  void WriteRetentive(CodeMemory& memory, uint32_t slot, const ir::HostFunction& host, terms::TermId calls);

  terms::Terms& terms_;
  const emit::Emittable& emittable_;
  const execute::Cells& cells_;
  const StateImage& image_;
  Passes passes_;
  terms::TermId now_;
  std::function<terms::TermId(uint32_t slot)> initial_;
};

}  // namespace plcxx::prove::verify
