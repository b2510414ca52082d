// W14: does a network of instructions fit the editor's 50 rows of 9 cells? (specification 10.1, IL layout rule)
#include <algorithm>
#include <vector>

#include "transpiler/dialects/host50/analysis/warnings.h"

namespace plcxx::host50 {
namespace {

struct Size {
  uint32_t width = 0, height = 0;
};

/// The rung machine once more, with sizes for values. The program has no errors.
class Layout {
 public:
  explicit Layout(const Program& program) : program_(program) {}

  void Add(const Instruction& instruction) {
    const InstructionInfo& info = Info(instruction.op);
    switch (info.effect) {
      case RungEffect::kLoad:
        live_ ? blocks_.push_back(acc_) : EndRung();
        acc_ = {1, 1};
        break;
      case RungEffect::kSeries:
        ++acc_.width;
        break;
      case RungEffect::kParallel:
        acc_ = {std::max(acc_.width, 1u), acc_.height + 1};
        break;
      case RungEffect::kJoinSeries: {
        const Size left = TakeBlock();
        acc_ = {left.width + acc_.width, std::max(left.height, acc_.height)};
        break;
      }
      case RungEffect::kJoinParallel: {
        const Size left = TakeBlock();
        acc_ = {std::max(left.width, acc_.width), left.height + acc_.height};
        break;
      }
      case RungEffect::kBranchOpen:
        branches_.push_back(acc_);
        break;
      case RungEffect::kBranchNext:
      case RungEffect::kBranchLast:
        acc_ = {branches_.back().width, 1};
        if (info.effect == RungEffect::kBranchLast) branches_.pop_back();
        break;
      case RungEffect::kOutput:
        Widen(acc_.width + 1);
        rung_rows_ += rung_rows_ == 0 ? acc_.height : std::max(1u, acc_.height);
        acc_.height = 0;  // of the part after this output
        break;
      case RungEffect::kCompare:
      case RungEffect::kElement:
        AddBlock(instruction);
        break;
      case RungEffect::kClose:
        EndRung();
        break;
      case RungEffect::kNothing:
        ++rows_;
        return;  // live stays what it is
    }
    live_ = info.effect != RungEffect::kOutput && info.effect != RungEffect::kClose;
  }

  void EndRung() {
    if (live_) {
      Widen(acc_.width);
      rung_rows_ += std::max(1u, acc_.height);
    }
    rows_ += rung_rows_;
    rung_rows_ = 0;
    acc_ = {};
    live_ = false;
    blocks_.clear();
    branches_.clear();
  }

  uint32_t rows() const { return rows_; }
  uint32_t widest() const { return widest_; }

 private:
  Size TakeBlock() {
    const Size block = blocks_.back();
    blocks_.pop_back();
    return block;
  }

  void Widen(uint32_t width) { widest_ = std::max(widest_, width); }

  void AddBlock(const Instruction& instruction) {
    uint32_t named = 0;
    Size pins = acc_;
    for (uint32_t i = 0; i < instruction.pins.count; ++i) {
      if (!program_.pins[instruction.pins.first + i].from_stack) {
        ++named;
        continue;
      }
      const Size next = TakeBlock();
      pins = {std::max(pins.width, next.width), pins.height + next.height};
    }
    acc_ = {pins.width + 1, std::max(pins.height, 1 + named)};
  }

  const Program& program_;
  Size acc_;
  bool live_ = false;
  std::vector<Size> blocks_, branches_;
  uint32_t rung_rows_ = 0;
  uint32_t rows_ = 0, widest_ = 0;
};

}  // namespace

void CheckLayout(const Program& program, diag::Engine& diagnostics) {
  for (const Network& network : program.networks) {
    if (network.is_drawing) continue;  // it has the limits of a drawing
    Layout layout(program);
    for (uint32_t i = 0; i < network.instructions.count; ++i) {
      layout.Add(program.instructions[InstructionId(network.instructions.first + i)]);
    }
    layout.EndRung();
    if (layout.rows() > kMostRows || layout.widest() > kMostCells) {
      diagnostics.Report(network.range, diag::Host50TooLarge, layout.rows(), layout.widest());
    }
  }
}

}  // namespace plcxx::host50
