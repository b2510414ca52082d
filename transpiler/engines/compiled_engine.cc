#include "transpiler/engines/compiled_engine.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <deque>
#include <span>
#include <string>
#include <utility>

#include "transpiler/compile/child_process.h"
#include "transpiler/engines/harness.h"
#include "transpiler/support/check.h"

namespace plcxx::engines {
namespace {

// What the child may have answered before anybody reads it: less than the pipe holds, so that it goes on meanwhile.
constexpr size_t kMostUnreadBytes = 32 * 1024;
constexpr size_t kMostOpenPieces = 128;

/// Where one bit or byte of a place is: a byte of State, or of the shadow of what the program does not use.
struct PlacePart {
  bool in_state = false;
  uint32_t offset = 0;
  uint8_t bit = 0;       // of that byte
  bool is_bool = false;  // the byte holds 0 or 1
};

class CompiledEngine : public sim::Engine {
 public:
  explicit CompiledEngine(std::shared_ptr<CompiledProgram> compiled)
      : compiled_(std::move(compiled)),
        program_(*compiled_->program),
        layout_(compiled_->layout),
        state_(layout_.size, 0) {
    for (const ir::Space& space : program_.spaces) {
      shadow_.emplace_back(space.bytes, 0);
      shadow_mask_.emplace_back(space.bytes, 0);
      shadow_value_.emplace_back(space.bytes, 0);
    }
    force_mask_.assign(layout_.size, 0);
    force_value_.assign(layout_.size, 0);
    FindStored();
  }

  CompiledEngine(const CompiledEngine&) = delete;
  CompiledEngine& operator=(const CompiledEngine&) = delete;

  /// A child that has answered everything may serve another engine.
  ~CompiledEngine() override {
    if (child_ == nullptr || owes_answer_ || !open_.empty()) return;
    Command("Q");
    if (child_->Send(outgoing_)) compiled_->executable->GiveBack(std::move(child_));
  }

  bool Start() {
    child_ = compiled_->executable->TakeProcess(*compiled_->platform);
    if (child_ == nullptr) return false;
    Command("", {compiled_->number});
    return true;
  }

  std::string_view name() const override { return compiled_->platform->name; }

  bool ExpectCalls(std::span<const sim::AnsweredCall> calls) override {
    Ask(Asking::kTells);
    expected_ = calls;
    return true;
  }

  void PowerOn() override {
    for (uint32_t s = 0; s < shadow_.size(); ++s) {
      std::fill(shadow_[s].begin(), shadow_[s].end(), uint8_t{0});
      for (const ir::InitialByte& initial : program_.spaces[ir::SpaceId(s)].initial)
        shadow_[s][initial.offset] = initial.value;
      for (size_t i = 0; i < shadow_[s].size(); ++i) ApplyShadowForce(s, i);
    }
    Piece("I");
  }

  void RunPeriod(uint32_t now_ms) override { Piece("P", {now_ms}); }

  void RunFastOnly(uint32_t now_ms) override { Piece("F", {now_ms}); }

  void RunElapse(uint32_t now_ms) override { Piece("L", {now_ms}); }

  void AnswerHostCalls(sim::HostAnswers answers) override {
    answers_ = std::move(answers);
    Ask(answers_ ? Asking::kWithState : Asking::kNobody);
  }

  uint32_t RunAhead() override {
    runs_ahead_ = true;
    return static_cast<uint32_t>(
        std::clamp(kMostUnreadBytes / (state_.size() + sizeof(uint32_t)), size_t{1}, kMostOpenPieces));
  }

  void EndPiece() override {
    if (open_.empty()) return;
    const size_t known = open_.front();
    open_.pop_front();
    Answer(known);
  }

  uint64_t Read(const ir::Place& place) override {
    if (place.is_field()) {
      uint64_t value = 0;
      std::memcpy(&value, &state_[FieldAt(place)], ir::Bytes(place.type));
      return value;
    }
    if (place.type == ir::Type::kBit) return ReadByte(place.space, place.offset) >> place.bit & 1;
    uint64_t value = 0;
    const uint32_t bytes = ir::Bytes(place.type);
    for (uint32_t i = 0; i < bytes; ++i) {
      value |= static_cast<uint64_t>(ReadByte(place.space, place.offset + i)) << (8 * ByteIndex(place.space, i, bytes));
    }
    return value;
  }

  void Write(const ir::Place& place, uint64_t value) override {
    Apply(place, value, [this](const PlacePart& cell, ir::SpaceId space, uint8_t mask, uint8_t bits) {
      if (cell.in_state) {
        state_[cell.offset] = static_cast<uint8_t>((state_[cell.offset] & ~mask) | (bits & mask));
        state_[cell.offset] = static_cast<uint8_t>((state_[cell.offset] & ~force_mask_[cell.offset]) |
                                                   (force_value_[cell.offset] & force_mask_[cell.offset]));
        Command("W", {cell.offset, mask, bits});
      } else {
        uint8_t& byte = shadow_[space.index][cell.offset];
        byte = static_cast<uint8_t>((byte & ~mask) | (bits & mask));
        ApplyShadowForce(space.index, cell.offset);
      }
    });
  }

  void Force(const ir::Place& place, uint64_t value) override {
    PLCXX_CHECK(compiled_->flavour == emit::Flavour::kDebug);  // else FlavourFor chose wrongly
    Apply(place, value, [this](const PlacePart& cell, ir::SpaceId space, uint8_t mask, uint8_t bits) {
      std::vector<uint8_t>& masks = cell.in_state ? force_mask_ : shadow_mask_[space.index];
      std::vector<uint8_t>& values = cell.in_state ? force_value_ : shadow_value_[space.index];
      masks[cell.offset] = static_cast<uint8_t>(masks[cell.offset] | mask);
      values[cell.offset] = static_cast<uint8_t>((values[cell.offset] & ~mask) | (bits & mask));
      if (cell.in_state) {
        state_[cell.offset] = static_cast<uint8_t>((state_[cell.offset] & ~mask) | (bits & mask));
        Command("K", {cell.offset, mask, bits});
      } else {
        ApplyShadowForce(space.index, cell.offset);
      }
    });
  }

  void Release(const ir::Place& place) override {
    Apply(place, 0, [this](const PlacePart& cell, ir::SpaceId space, uint8_t mask, uint8_t) {
      std::vector<uint8_t>& masks = cell.in_state ? force_mask_ : shadow_mask_[space.index];
      masks[cell.offset] = static_cast<uint8_t>(masks[cell.offset] & ~mask);
      if (cell.in_state) Command("R", {cell.offset, mask});
    });
  }

  void SendText(std::string_view text) override {
    Command("T", {static_cast<uint32_t>(text.size())});
    outgoing_ += text;
    Answer();
  }

  void EnableStatement(ir::StatementId statement, bool enabled) override {
    Command("E", {statement.index, enabled ? 1u : 0u});
  }

  void StoreRetentive() override { Command("S"); }

  std::vector<sim::HostEvent> TakeEvents() override { return std::exchange(events_, {}); }

  std::vector<uint8_t> Snapshot() override {
    std::vector<uint8_t> bytes;
    for (uint32_t s = 0; s < program_.spaces.size(); ++s) {
      if (program_.spaces[ir::SpaceId(s)].host_visible) bytes.insert(bytes.end(), shadow_[s].begin(), shadow_[s].end());
    }
    for (const Stored& stored : stored_) {
      uint8_t& byte = bytes[stored.at];
      const uint8_t state = state_[stored.offset];
      byte = stored.bit == ir::kNoBit ? state
                                      : static_cast<uint8_t>((byte & ~(1u << stored.bit)) | (state & 1u) << stored.bit);
    }
    for (uint32_t i = 0; i < program_.states.size(); ++i) {
      const ir::StateKind kind = program_.states[ir::StateId(i)].kind;
      const auto fields = ir::Info(kind).fields;
      for (uint8_t f = 0; f < static_cast<uint8_t>(fields.size()); ++f) {
        const uint32_t at = layout_.states[i].offset + emit::layout::FieldOffset(kind, f);
        const uint32_t size = ir::Bytes(fields[f].type) * fields[f].count;
        bytes.insert(bytes.end(), state_.begin() + at, state_.begin() + at + size);
      }
    }
    return bytes;
  }

 private:
  /// What of a snapshot is in State: a byte, or a bit of one that is a bool there.
  struct Stored {
    size_t at;
    uint32_t offset;
    uint8_t bit;
  };

  void FindStored() {
    size_t at = 0;
    for (uint32_t s = 0; s < program_.spaces.size(); ++s) {
      if (!program_.spaces[ir::SpaceId(s)].host_visible) continue;
      for (uint32_t i = 0; i < program_.spaces[ir::SpaceId(s)].bytes; ++i, ++at) {
        for (uint8_t bit = 0; bit < 8; ++bit) {
          const PlacePart cell = BitCell(ir::SpaceId(s), i, bit);
          if (cell.in_state) stored_.push_back({at, cell.offset, cell.is_bool ? bit : ir::kNoBit});
          if (cell.in_state && !cell.is_bool) break;  // the whole byte
        }
      }
    }
  }

  void Check(bool alive) {
    if (!alive)
      throw EngineFault{"engine '" + compiled_->platform->name + "': the program ended or did not answer within 10 s"};
  }

  void Command(const char* letter, std::initializer_list<uint32_t> words = {}) {
    outgoing_ += letter;
    for (const uint32_t word : words) outgoing_.append(reinterpret_cast<const char*>(&word), sizeof word);
  }

  void Ask(Asking asking) {
    if (std::exchange(asking_, asking) != asking) Command("H", {static_cast<uint32_t>(asking)});
  }

  void Piece(const char* letter, std::initializer_list<uint32_t> words = {}) {
    Command(letter, words);
    const auto expected = std::exchange(expected_, {});
    for (const sim::AnsweredCall& call : expected) {
      for (const auto& change : call.changes) change(*this);
      CommandAnswer(call.answer);
    }
    if (asking_ == Asking::kTells) Command("D");
    if (!runs_ahead_) {
      Answer(expected.size());
      return;
    }
    PLCXX_CHECK(asking_ != Asking::kWithState);  // the child waits for an answer that nobody knows yet
    open_.push_back(expected.size());
  }

  void CommandAnswer(const sim::HostAnswer& answer) {
    const uint64_t second = answer.out.value_or(0);
    Command("A", {Low(answer.result), High(answer.result), answer.out ? 1u : 0u, Low(second), High(second)});
  }

  /// What a command ends with; what the child asks before is answered, unless it has the answers already: `known`.
  void Answer(size_t known = 0) {
    owes_answer_ = true;  // as long as nothing is thrown
    uint32_t count = 0;
    for (;;) {
      Receive(&count, sizeof count);
      if (count != kHostQuestion) break;
      const sim::HostEvent call = ReceiveCall();
      if (asking_ == Asking::kWithState) Receive(state_.data(), state_.size());
      const sim::HostAnswer answer = answers_(call.function, call.arguments);
      if (known > 0) {
        --known;
      } else {
        CommandAnswer(answer);
      }
    }
    for (uint32_t i = 0; i < count; ++i) events_.push_back(ReceiveCall());
    Receive(state_.data(), state_.size());
    owes_answer_ = false;
  }

  /// The child is sent what it has to do first.
  void Receive(void* bytes, size_t size) {
    if (!outgoing_.empty()) Check(child_->Send(std::exchange(outgoing_, {})));
    Check(child_->Receive(bytes, size));
  }

  static uint32_t Low(uint64_t value) { return static_cast<uint32_t>(value); }
  static uint32_t High(uint64_t value) { return static_cast<uint32_t>(value >> 32); }

  sim::HostEvent ReceiveCall() {
    std::array<uint32_t, 2> head{};
    Receive(head.data(), sizeof head);
    sim::HostEvent call{ir::HostFunctionId(head[0]), std::vector<uint64_t>(head[1])};
    if (head[1] > 0) Receive(call.arguments.data(), head[1] * sizeof(uint64_t));
    return call;
  }

  /// The place of byte `i` of a value of `bytes` bytes in that value, least significant first.
  uint32_t ByteIndex(ir::SpaceId space, uint32_t i, uint32_t bytes) const {
    return program_.spaces[space].order == ir::ByteOrder::kLittle ? i : bytes - 1 - i;
  }

  uint32_t FieldAt(const ir::Place& place) const {
    return layout_.states[place.state.index].offset +
           emit::layout::FieldOffset(program_.states[place.state].kind, place.field);
  }

  void ApplyShadowForce(uint32_t space, size_t at) {
    uint8_t& byte = shadow_[space][at];
    byte =
        static_cast<uint8_t>((byte & ~shadow_mask_[space][at]) | (shadow_value_[space][at] & shadow_mask_[space][at]));
  }

  /// The cell of one bit of a byte of a space.
  PlacePart BitCell(ir::SpaceId space, uint32_t at, uint8_t bit) const {
    if (at >= layout_.bytes[space.index].size()) return {false, at, bit, false};  // a local of routines
    const emit::layout::ByteStorage& stored = layout_.bytes[space.index][at];
    if (stored.bits[bit].storage != emit::layout::Storage::kNone) return {true, stored.bits[bit].offset, 0, true};
    // Bytes of words too: this machine and all platforms are little-endian.
    if (stored.whole.storage != emit::layout::Storage::kNone) return {true, stored.whole.offset, bit, false};
    return {false, at, bit, false};
  }

  uint8_t ReadByte(ir::SpaceId space, uint32_t at) const {
    uint8_t value = 0;
    for (uint8_t bit = 0; bit < 8; ++bit) {
      const PlacePart cell = BitCell(space, at, bit);
      const uint8_t byte = cell.in_state ? state_[cell.offset] : shadow_[space.index][cell.offset];
      value = static_cast<uint8_t>(value | ((byte >> cell.bit & 1) << bit));
    }
    return value;
  }

  /// Calls change(cell, space, mask, bits) for each byte of storage that holds part of the place.
  template <class Change>
  void Apply(const ir::Place& place, uint64_t value, Change&& change) {
    if (place.is_field()) {
      for (uint32_t i = 0; i < ir::Bytes(place.type); ++i) {
        change(PlacePart{true, FieldAt(place) + i, 0, false}, ir::SpaceId(), 0xFF,
               static_cast<uint8_t>(value >> (8 * i)));
      }
      return;
    }
    const uint32_t bytes = ir::Bytes(place.type);
    for (uint32_t i = 0; i < bytes; ++i) {
      const auto byte = static_cast<uint8_t>(value >> (8 * ByteIndex(place.space, i, bytes)));
      for (uint8_t bit = 0; bit < 8; ++bit) {
        const bool single = place.type == ir::Type::kBit;
        if (single && bit != place.bit) continue;
        const bool one = ((single ? value : static_cast<uint64_t>(byte >> bit)) & 1) != 0;
        const PlacePart cell = BitCell(place.space, place.offset + i, bit);
        const auto mask = cell.is_bool ? uint8_t{0xFF} : static_cast<uint8_t>(1u << cell.bit);
        const auto bits = cell.is_bool ? static_cast<uint8_t>(one ? 1 : 0) : static_cast<uint8_t>(one ? mask : 0);
        change(cell, place.space, mask, bits);
      }
    }
  }

  std::shared_ptr<CompiledProgram> compiled_;
  const ir::Program& program_;
  const emit::layout::Layout& layout_;
  std::unique_ptr<compile::ChildProcess> child_;
  bool owes_answer_ = false;  // the child; then it serves nobody else
  bool runs_ahead_ = false;
  std::deque<size_t> open_;  // of each piece that was begun and not ended: how many calls have their answers already
  std::string outgoing_;     // commands that nothing was received behind yet
  Asking asking_ = Asking::kNobody;
  std::span<const sim::AnsweredCall> expected_;  // of the next piece
  std::vector<uint8_t> state_;                   // mirror of the child's State
  std::vector<uint8_t> force_mask_, force_value_;
  std::vector<std::vector<uint8_t>> shadow_, shadow_mask_, shadow_value_;  // by SpaceId
  std::vector<Stored> stored_;
  std::vector<sim::HostEvent> events_;
  sim::HostAnswers answers_;
};

}  // namespace

std::variant<std::unique_ptr<sim::Engine>, CompileFailure> StartCompiled(std::shared_ptr<CompiledProgram> program) {
  auto engine = std::make_unique<CompiledEngine>(std::move(program));
  if (!engine->Start())
    return CompileFailure{"cannot start the program of engine '" + std::string(engine->name()) + "'"};
  return std::unique_ptr<sim::Engine>(std::move(engine));
}

}  // namespace plcxx::engines
