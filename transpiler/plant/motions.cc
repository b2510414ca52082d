// Axes, tanks and spindles: what moves with a speed.
#include <algorithm>
#include <utility>

#include "transpiler/plant/element.h"

namespace plcxx::plant {
namespace {

/// A speed in thousandths of a unit a second, for so many milliseconds: millionths of a unit.
constexpr int64_t kMillionths = 1000;  // in a thousandth
constexpr uint64_t kLongMs = 100'000;  // in one piece; the way of a longer time is that of several

int64_t FloorDivided(int64_t value, int64_t by) {
  const int64_t whole = value / by;
  return value % by < 0 ? whole - 1 : whole;
}

/// `position` after `elapsed_ms` at `speed`, within [low, high]; all in millionths but the speed.
int64_t Moved(int64_t position, int64_t speed, uint64_t elapsed_ms, int64_t low, int64_t high) {
  while (elapsed_ms != 0 && speed != 0) {
    const uint64_t ms = std::min(elapsed_ms, kLongMs);
    position = std::clamp(position + speed * static_cast<int64_t>(ms), low, high);
    elapsed_ms -= ms;
  }
  return position;
}

class AxisElement : public Element {
 public:
  explicit AxisElement(const Fields& fields)
      : forward_(fields.TakeCondition("forward", Condition::Never())),
        backward_(fields.TakeCondition("backward", Condition::Never())),
        enable_(fields.TakeCondition("enable", Condition::Always())),
        speed_(fields.Find("speed")->amount),
        speed_step_(fields.Number("speed-step", 1000)),
        from_(fields.Number("from", 0) * kMillionths),
        to_(fields.Number("to", 0) * kMillionths),
        at_(fields.Number("at", fields.Number("from", 0)) * kMillionths),
        low_at_(fields.Number("low-limit-at", fields.Number("from", 0)) * kMillionths),
        high_at_(fields.Number("high-limit-at", fields.Number("to", 0)) * kMillionths),
        cam_from_(fields.Number("reference-from", fields.Number("from", 0)) * kMillionths),
        cam_to_(fields.Number("reference-to", fields.Number("reference-from", fields.Number("from", 0))) * kMillionths),
        line_(fields.Number("line", 1000) * kMillionths),
        position_step_(fields.Number("position-step", 1000) * kMillionths),
        hit_(fields.Number("hit", 0)),
        low_(fields.Drive("low-limit")),
        high_(fields.Drive("high-limit")),
        reference_(fields.Drive("reference")),
        position_(fields.Drive("position")),
        encoder_(fields.Drives("encoder")) {}

  uint32_t size() const override { return 1; }
  void Deliver(std::span<int64_t> state) const override { state[0] = at_; }
  void Advance(uint64_t elapsed_ms, std::span<const int64_t> reads, std::span<int64_t> state) const override {
    const bool ahead = forward_.Holds(reads), back = backward_.Holds(reads);
    if (ahead == back || !enable_.Holds(reads)) return;
    const int64_t speed = speed_.Value(reads, speed_step_);
    state[0] = Moved(state[0], ahead ? speed : -speed, elapsed_ms, from_, to_);
  }
  void Show(std::span<const int64_t> state, std::span<int64_t> drives) const override {
    const int64_t at = state[0];
    if (low_) drives[*low_] = (at <= low_at_) == (hit_ != 0) ? 1 : 0;
    if (high_) drives[*high_] = (at >= high_at_) == (hit_ != 0) ? 1 : 0;
    if (reference_) drives[*reference_] = at >= cam_from_ && at <= cam_to_ ? 1 : 0;
    if (position_) drives[*position_] = FloorDivided(at, position_step_);
    if (!encoder_.empty()) {
      // Of the four quarters of a line A has the second and the third, B the third and the fourth.
      const int64_t quarter = (at - FloorDivided(at, line_) * line_) * 4 / line_;
      drives[encoder_[0]] = quarter == 1 || quarter == 2 ? 1 : 0;
      if (encoder_.size() > 1) drives[encoder_[1]] = quarter >= 2 ? 1 : 0;
    }
  }

 private:
  Condition forward_, backward_, enable_;
  Amount speed_;
  int64_t speed_step_, from_, to_, at_, low_at_, high_at_, cam_from_, cam_to_, line_, position_step_, hit_;
  std::optional<uint32_t> low_, high_, reference_, position_;
  std::vector<uint32_t> encoder_;
};

Amount AmountOf(const Fields& fields, std::string_view key, int64_t otherwise) {
  const Field* const field = fields.Find(key);
  return field == nullptr ? Amount{.thousandths = otherwise, .read = {}} : field->amount;
}

class TankElement : public Element {
 public:
  explicit TankElement(const Fields& fields)
      : fill_(fields.TakeCondition("fill", Condition::Never())),
        drain_(fields.TakeCondition("drain", Condition::Never())),
        fill_rate_(AmountOf(fields, "fill-rate", 0)),
        drain_rate_(AmountOf(fields, "drain-rate", 0)),
        capacity_(fields.Number("capacity", 0) * kMillionths),
        at_(fields.Number("at", 0) * kMillionths),
        level_step_(fields.Number("level-step", 1000) * kMillionths),
        level_(fields.Drive("level")),
        levels_(fields.Values("levels")) {}

  uint32_t size() const override { return 1; }
  void Deliver(std::span<int64_t> state) const override { state[0] = at_; }
  void Advance(uint64_t elapsed_ms, std::span<const int64_t> reads, std::span<int64_t> state) const override {
    constexpr int64_t kStep = 1000;
    const int64_t in = fill_.Holds(reads) ? fill_rate_.Value(reads, kStep) : 0;
    const int64_t out = drain_.Holds(reads) ? drain_rate_.Value(reads, kStep) : 0;
    state[0] = Moved(state[0], in - out, elapsed_ms, 0, capacity_);
  }
  void Show(std::span<const int64_t> state, std::span<int64_t> drives) const override {
    for (const auto& [drive, level] : levels_) drives[drive] = state[0] >= level * kMillionths ? 1 : 0;
    if (level_) drives[*level_] = state[0] / level_step_;
  }

 private:
  Condition fill_, drain_;
  Amount fill_rate_, drain_rate_;
  int64_t capacity_, at_, level_step_;
  std::optional<uint32_t> level_;
  std::vector<std::pair<uint32_t, int64_t>> levels_;
};

/// Its speed is kept in thousandths of 1/min times the milliseconds of the ramp: in each millisecond it changes by
/// `top-speed`.
class SpindleElement : public Element {
 public:
  explicit SpindleElement(const Fields& fields)
      : forward_(fields.TakeCondition("forward", Condition::Never())),
        reverse_(fields.TakeCondition("reverse", Condition::Never())),
        enable_(fields.TakeCondition("enable", Condition::Always())),
        top_(fields.Number("top-speed", 0)),
        speed_(AmountOf(fields, "speed", top_)),
        speed_step_(fields.Number("speed-step", 1000)),
        actual_step_(fields.Number("actual-step", 1000)),
        ramp_ms_(std::max<int64_t>(1, fields.Number("ramp", 1))),
        reached_(fields.Drive("reached")),
        zero_(fields.Drive("zero")),
        pulse_(fields.Drive("pulse")),
        actual_(fields.Drive("actual")) {}

  uint32_t size() const override { return 3; }
  void Deliver(std::span<int64_t> state) const override { std::ranges::fill(state, 0); }
  void Advance(uint64_t elapsed_ms, std::span<const int64_t> reads, std::span<int64_t> state) const override {
    const bool right = forward_.Holds(reads), left = reverse_.Holds(reads);
    int64_t wanted = 0;
    if (right != left && enable_.Holds(reads)) {
      wanted = std::clamp(speed_.Value(reads, speed_step_), -top_, top_) * (right ? 1 : -1);
    }
    state[kWanted] = wanted * ramp_ms_;
    const auto ms = static_cast<int64_t>(std::min<uint64_t>(elapsed_ms, static_cast<uint64_t>(2 * ramp_ms_)));
    const int64_t change = ms * top_;
    state[kSpeed] = state[kSpeed] < state[kWanted] ? std::min(state[kWanted], state[kSpeed] + change)
                                                   : std::max(state[kWanted], state[kSpeed] - change);
    const int64_t a_minute = state[kSpeed] / ramp_ms_;
    const auto turned = static_cast<int64_t>(elapsed_ms % kRevolution) * (a_minute % kRevolution) % kRevolution;
    state[kAngle] = (state[kAngle] + turned + kRevolution) % kRevolution;
  }
  void Show(std::span<const int64_t> state, std::span<int64_t> drives) const override {
    if (reached_) drives[*reached_] = state[kWanted] != 0 && state[kSpeed] == state[kWanted] ? 1 : 0;
    if (zero_) drives[*zero_] = state[kSpeed] == 0 ? 1 : 0;
    if (pulse_) drives[*pulse_] = state[kAngle] >= kRevolution / 2 ? 1 : 0;
    if (actual_) drives[*actual_] = state[kSpeed] / ramp_ms_ / actual_step_;
  }

 private:
  enum : uint8_t { kSpeed, kWanted, kAngle };
  static constexpr int64_t kRevolution = 60'000'000;  // thousandths of 1/min times milliseconds
  Condition forward_, reverse_, enable_;
  int64_t top_;
  Amount speed_;
  int64_t speed_step_, actual_step_, ramp_ms_;
  std::optional<uint32_t> reached_, zero_, pulse_, actual_;
};

FieldFault Outside(const char* key, const char* of) {
  return {key, std::string("it is outside of ") + of, "write a number within"};
}

}  // namespace

MadeElement MakeAxis(const Fields& fields) {
  const int64_t from = fields.Number("from", 0), to = fields.Number("to", 0), at = fields.Number("at", from);
  std::optional<FieldFault> fault;
  if (from >= to) fault = FieldFault{"to", "the way has no length", "write a number above 'from'"};
  if (!fault && (at < from || at > to)) fault = Outside("at", "'from' and 'to'");
  if (!fault && fields.Drives("encoder").size() > 2)
    fault = FieldFault{"encoder", "an encoder has one input or two", "name A and B"};
  if (fault) return {.element = {}, .fault = std::move(fault)};
  return {.element = std::make_unique<AxisElement>(fields), .fault = {}};
}

MadeElement MakeTank(const Fields& fields) {
  const int64_t at = fields.Number("at", 0);
  if (at < 0 || at > fields.Number("capacity", 0)) return {.element = {}, .fault = Outside("at", "0 and 'capacity'")};
  return {.element = std::make_unique<TankElement>(fields), .fault = {}};
}

MadeElement MakeSpindle(const Fields& fields) {
  constexpr int64_t kMaxSpeed = 1'000'000'000;  // in thousandths: a million a minute
  if (fields.Number("top-speed", 0) > kMaxSpeed) {
    return {.element = {}, .fault = FieldFault{"top-speed", "no spindle turns so fast", "write at most 1000000"}};
  }
  return {.element = std::make_unique<SpindleElement>(fields), .fault = {}};
}

}  // namespace plcxx::plant
