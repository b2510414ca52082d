#include "transpiler/prove/verify/host_environment.h"

#include <array>

#include "transpiler/symbolic/execute/host_writes.h"
#include "transpiler/symbolic/meaning/meaning.h"
#include "transpiler/symbolic/terms/gather.h"

namespace plcxx::prove::verify {
namespace {

bool GetsRetentive(ir::HostAccess access) {
  return access == ir::HostAccess::kReadsRetentive || access == ir::HostAccess::kWritesRetentive;
}

}  // namespace

terms::TermId HavingSeen(terms::Terms& terms, const std::string& function, terms::TermId calls,
                         std::span<const terms::TermId> bytes) {
  std::vector<terms::TermId> arguments{calls};
  arguments.insert(arguments.end(), bytes.begin(), bytes.end());
  return terms.Apply(terms.Function("seen by " + function, 64), arguments);
}

bool MayReadState(ir::HostAccess access, Passes passes) {
  return access == ir::HostAccess::kReadsState ||
         (access == ir::HostAccess::kWritesState && passes == Passes::kStateAndHost);
}

terms::TermId StoredByte(terms::Terms& terms, const std::string& space, uint32_t offset) {
  const terms::TermId at = terms.Const(offset, 32);
  return terms.Apply(terms.Function("stored " + space, 8), {&at, 1});
}

/// What it has been told includes what it has seen; `slot` is where the memory begins that it gets.
void HostEnvironment::Show(CodeMemory& memory, uint32_t slot, const ir::HostFunction& host, uint32_t counter,
                           terms::TermId calls) {
  const bool retentive = host.access == ir::HostAccess::kReadsRetentive;
  const uint32_t begin = retentive ? image_.retentive_begin() : 0;
  const uint32_t end = retentive ? image_.retentive_end() : image_.size();
  std::vector<terms::TermId> bytes;
  for (uint32_t at = begin; at < end; ++at) {
    if (image_[at].kind != ByteKind::kNothing) bytes.push_back(memory.Read(slot + at - begin));
  }
  memory.Write(counter, HavingSeen(terms_, host.name, calls, bytes));
}

void HostEnvironment::WriteState(CodeMemory& memory, const ir::HostFunction& host, terms::TermId calls) {
  const ir::Program& program = *emittable_.program;
  for (uint32_t s = 0; s < emittable_.layout.bytes.size(); ++s) {
    const ir::SpaceId space(s);
    for (uint32_t offset = 0; offset < emittable_.layout.bytes[s].size(); ++offset) {
      const emit::layout::ByteStorage& stored = emittable_.layout.bytes[s][offset];
      const uint8_t may_write = execute::BitsMayWrite(program, host, space, offset);
      if (may_write == 0) continue;
      const std::string& name = program.spaces[space].name;
      const terms::TermId byte = execute::ByteFromHost(terms_, host.name, calls, name, offset);
      const terms::TermId written = execute::BitsWrittenByHost(terms_, host.name, calls, name, offset);
      const uint8_t clears = execute::BitsControlWrites(program.spaces[space], offset).clears;
      // What the code has written there stays where the host leaves the bit.
      const auto after = [&](uint8_t bit, terms::TermId told, terms::TermId before) {
        if ((may_write >> bit & 1) == 0) return before;
        if ((clears >> bit & 1) != 0) return terms_.And(told, before);
        return terms_.Ite(terms_.Extract(written, bit, 1), told, before);
      };
      if (stored.whole.storage != emit::layout::Storage::kNone) {
        const terms::TermId before = memory.Read(stored.whole.offset);
        std::array<terms::TermId, 8> bits;
        for (uint8_t bit = 0; bit < 8; ++bit)
          bits[bit] = after(bit, terms_.Extract(byte, bit, 1), terms_.Extract(before, bit, 1));
        memory.Write(stored.whole.offset, terms::Gather(terms_, bits));
        continue;
      }
      for (uint8_t bit = 0; bit < 8; ++bit) {
        if (stored.bits[bit].storage == emit::layout::Storage::kNone || (may_write >> bit & 1) == 0) continue;
        const uint32_t slot = stored.bits[bit].offset;
        memory.Write(slot, after(bit, terms_.Zext(terms_.Extract(byte, bit, 1), 8), memory.Read(slot)));
      }
    }
  }
}

void HostEnvironment::WriteRetentive(CodeMemory& memory, uint32_t slot, const ir::HostFunction& host,
                                     terms::TermId calls) {
  const ir::Program& program = *emittable_.program;
  const terms::TermId hash = terms_.Const(image_.layout_hash(), 32);
  // Without a copy, as at the first power-on, it leaves alone what it is given.
  const terms::TermId has_copy = execute::HasCopy(terms_, host.name, calls);
  const auto write = [&](uint32_t at, terms::TermId byte) {
    const uint32_t place = slot + at - image_.retentive_begin();
    memory.Write(place, terms_.Ite(has_copy, byte, memory.Read(place)));
  };
  for (uint32_t at = image_.retentive_begin(); at < image_.retentive_end(); ++at) {
    if (image_[at].kind == ByteKind::kLayout) write(at, terms_.Extract(hash, image_[at].low, 8));
  }
  for (uint32_t s = 0; s < emittable_.layout.bytes.size(); ++s) {
    const ir::SpaceId space(s);
    for (uint32_t offset = 0; offset < emittable_.layout.bytes[s].size(); ++offset) {
      if (execute::BitsMayWrite(program, host, space, offset) != 0)
        write(emittable_.layout.bytes[s][offset].whole.offset, StoredByte(terms_, program.spaces[space].name, offset));
    }
  }
}

terms::TermId HostEnvironment::CallHost(CodeMemory& memory, const HostRequest& request, std::string& refusal) {
  const ir::Program& program = *emittable_.program;
  const std::string prefix = emittable_.namespace_name + "::";
  ir::HostFunctionId id;
  for (uint32_t i = 0; i < program.host_functions.size(); ++i) {
    if (request.function == prefix + program.host_functions[ir::HostFunctionId(i)].name) id = ir::HostFunctionId(i);
  }
  if (!id.valid()) {
    refusal = "a call of " + std::string(request.function) + ", which is no host function";
    return {};
  }
  const ir::HostFunction& host = program.host_functions[id];
  using Kind = HostArgument::Kind;
  size_t next = 0;
  const auto take = [&](Kind kind) -> const HostArgument* {
    const HostArgument* argument = next < request.arguments.size() ? &request.arguments[next++] : nullptr;
    return argument != nullptr && argument->kind == kind ? argument : nullptr;
  };
  bool fits = take(Kind::kHost) != nullptr;
  uint32_t slot = 0;
  if (host.access != ir::HostAccess::kNone) {
    const HostArgument* memory_argument = take(Kind::kMemory);
    const bool retentive = GetsRetentive(host.access);
    const uint32_t bytes = retentive ? image_.retentive_end() - image_.retentive_begin() : image_.size();
    fits = fits && memory_argument != nullptr && (retentive || memory_argument->slot == 0) &&
           memory_argument->bytes >= bytes;
    slot = memory_argument != nullptr ? memory_argument->slot : 0;
  }
  std::vector<terms::TermId> values;
  for (const ir::Parameter& parameter : host.parameters) {
    const HostArgument* argument = take(Kind::kValue);
    fits = fits && argument != nullptr && terms_.Width(argument->value) == meaning::WidthOf(parameter.type);
    if (argument != nullptr) values.push_back(argument->value);
  }
  const HostArgument* out = host.out.name.empty() ? nullptr : take(Kind::kMemory);
  const uint8_t width = host.result == ir::Type::kNone ? uint8_t{0} : meaning::WidthOf(host.result);
  const uint64_t out_bytes = host.out.name.empty() ? 0 : ir::Bytes(host.out.type);
  fits = fits && (host.out.name.empty() || (out != nullptr && out->bytes >= out_bytes)) &&
         next == request.arguments.size() && width == request.result_width;
  if (!fits) {
    refusal = "a call of " + std::string(request.function) + " with other parameters than its declaration";
    return {};
  }
  if (id == program.schedule.now) return now_;

  const uint32_t counter = image_.size() + id.index;
  terms::TermId calls, told;
  for (const execute::CellId chain : cells_.ChainsOf(id, false)) {
    const uint32_t at = image_.size() + chain.index - cells_.calls;
    told = execute::CallsAfter(terms_, host.name, memory.Read(at), values);
    if (!calls.valid()) calls = told;
    memory.Write(at, told);
  }
  if (out != nullptr) {
    const uint8_t out_width = meaning::WidthOf(host.out.type);
    const terms::TermId answer = terms_.Zext(execute::SecondAnswerOf(terms_, host.name, told, out_width),
                                             out_width < 8 ? uint8_t{8} : out_width);
    const terms::TermId gives = execute::GivesSecond(terms_, host.name, told);
    for (uint32_t i = 0; i < terms_.Width(answer) / 8U; ++i) {
      const terms::TermId byte = terms_.Extract(answer, static_cast<uint8_t>(8 * i), 8);
      memory.Write(out->slot + i, terms_.Ite(gives, byte, memory.Read(out->slot + i)));
    }
  }
  const terms::TermId result = width == 0 ? terms::TermId() : execute::AnswerOf(terms_, host.name, told, width);
  switch (host.access) {
    case ir::HostAccess::kNone:
      break;
    case ir::HostAccess::kReadsState:
    case ir::HostAccess::kReadsRetentive:
      Show(memory, slot, host, counter, calls);
      break;
    case ir::HostAccess::kWritesState:
      if (MayReadState(host.access, passes_)) Show(memory, slot, host, counter, calls);
      WriteState(memory, host, told);
      break;
    case ir::HostAccess::kWritesRetentive:
      WriteRetentive(memory, slot, host, calls);
      break;
  }
  return result;
}

}  // namespace plcxx::prove::verify
