// Switches, what is fixed, and cylinders.
#include <algorithm>
#include <utility>

#include "transpiler/plant/element.h"

namespace plcxx::plant {
namespace {

/// Inputs with what each of them is while the element is on.
std::vector<std::pair<uint32_t, int64_t>> OnValues(const Fields& fields) {
  std::vector<std::pair<uint32_t, int64_t>> values = fields.Values("values");
  for (const uint32_t drive : fields.Drives("input")) values.emplace_back(drive, 1);
  return values;
}

constexpr const char* kNoInput = "it has no input";
constexpr const char* kNameAnInput = "write 'input: NAME', or 'values: {NAME: 1}'";

class SwitchElement : public Element {
 public:
  explicit SwitchElement(const Fields& fields)
      : follows_(fields.TakeCondition("follows", Condition::Never())),
        values_(OnValues(fields)),
        on_ms_(fields.Number("on", 0)),
        off_ms_(fields.Number("off", 0)),
        at_(fields.Number("at", 0)) {}

  uint32_t size() const override { return 2; }
  void Deliver(std::span<int64_t> state) const override {
    state[kIsOn] = at_;
    state[kWaited] = 0;
  }
  void Advance(uint64_t elapsed_ms, std::span<const int64_t> reads, std::span<int64_t> state) const override {
    const int64_t wanted = follows_.Holds(reads) ? 1 : 0;
    if (wanted == state[kIsOn]) {
      state[kWaited] = 0;
      return;
    }
    state[kWaited] += static_cast<int64_t>(elapsed_ms);
    if (state[kWaited] < (wanted != 0 ? on_ms_ : off_ms_)) return;
    state[kIsOn] = wanted;
    state[kWaited] = 0;
  }
  void Show(std::span<const int64_t> state, std::span<int64_t> drives) const override {
    for (const auto& [drive, value] : values_) drives[drive] = state[kIsOn] != 0 ? value : 0;
  }

 private:
  enum : uint8_t { kIsOn, kWaited };
  Condition follows_;
  std::vector<std::pair<uint32_t, int64_t>> values_;
  int64_t on_ms_, off_ms_, at_;
};

class FixedElement : public Element {
 public:
  explicit FixedElement(const Fields& fields) : values_(OnValues(fields)) {}
  void Show(std::span<const int64_t> /*state*/, std::span<int64_t> drives) const override {
    for (const auto& [drive, value] : values_) drives[drive] = value;
  }

 private:
  std::vector<std::pair<uint32_t, int64_t>> values_;
};

/// The way is out time x back time long, so that each millisecond out or back is a whole number of it.
class CylinderElement : public Element {
 public:
  explicit CylinderElement(const Fields& fields)
      : extend_(fields.TakeCondition("extend", Condition::Never())),
        retract_(fields.TakeCondition("retract", Condition::Not(extend_))),
        out_ms_(std::max<int64_t>(1, fields.Number("extend-time", 1))),
        back_ms_(std::max<int64_t>(1, fields.Number("retract-time", out_ms_))),
        extended_(fields.Drive("extended")),
        retracted_(fields.Drive("retracted")),
        is_out_(fields.Word("at", "retracted") == "extended") {}

  uint32_t size() const override { return 1; }
  void Deliver(std::span<int64_t> state) const override { state[0] = is_out_ ? out_ms_ * back_ms_ : 0; }
  void Advance(uint64_t elapsed_ms, std::span<const int64_t> reads, std::span<int64_t> state) const override {
    const bool out = extend_.Holds(reads), back = retract_.Holds(reads);
    if (out == back) return;
    // Longer than the whole way is as long as it.
    const auto ms =
        static_cast<int64_t>(std::min<uint64_t>(elapsed_ms, static_cast<uint64_t>(out ? out_ms_ : back_ms_)));
    const int64_t to = out ? state[0] + ms * back_ms_ : state[0] - ms * out_ms_;
    state[0] = std::clamp<int64_t>(to, 0, out_ms_ * back_ms_);
  }
  void Show(std::span<const int64_t> state, std::span<int64_t> drives) const override {
    if (extended_) drives[*extended_] = state[0] == out_ms_ * back_ms_ ? 1 : 0;
    if (retracted_) drives[*retracted_] = state[0] == 0 ? 1 : 0;
  }

 private:
  Condition extend_, retract_;
  int64_t out_ms_, back_ms_;
  std::optional<uint32_t> extended_, retracted_;
  bool is_out_;
};

}  // namespace

MadeElement MakeSwitch(const Fields& fields) {
  if (OnValues(fields).empty()) return {.element = {}, .fault = FieldFault{"", kNoInput, kNameAnInput}};
  return {.element = std::make_unique<SwitchElement>(fields), .fault = {}};
}

MadeElement MakeFixed(const Fields& fields) {
  if (OnValues(fields).empty()) return {.element = {}, .fault = FieldFault{"", kNoInput, kNameAnInput}};
  return {.element = std::make_unique<FixedElement>(fields), .fault = {}};
}

MadeElement MakeCylinder(const Fields& fields) {
  return {.element = std::make_unique<CylinderElement>(fields), .fault = {}};
}

}  // namespace plcxx::plant
