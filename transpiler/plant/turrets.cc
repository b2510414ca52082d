// Turrets and magazines: positions on a circle.
#include <algorithm>
#include <utility>

#include "transpiler/plant/coding.h"
#include "transpiler/plant/element.h"

namespace plcxx::plant {
namespace {

constexpr int64_t kLockMs = 200;

/// What turns, as both kinds have it. One position is `time` long, in milliseconds.
struct Circle {
  Condition forward = Condition::Never(), reverse = Condition::Never();
  int64_t positions = 1, time_ms = 1, window_ms = 0;
  int64_t first = 1, at = 1;

  int64_t length() const { return positions * time_ms; }
  /// From 0; none: between two.
  std::optional<int64_t> PositionAt(int64_t angle) const {
    const int64_t nearest = (angle + time_ms / 2) / time_ms;
    const int64_t distance = angle - nearest * time_ms;
    if (distance > window_ms || -distance > window_ms) return std::nullopt;
    return nearest % positions;
  }
  void Turn(uint64_t elapsed_ms, std::span<const int64_t> reads, int64_t& angle) const {
    const bool ahead = forward.Holds(reads), back = reverse.Holds(reads);
    if (ahead == back) return;
    const auto way = static_cast<int64_t>(elapsed_ms % static_cast<uint64_t>(length()));
    angle = (angle + (ahead ? way : length() - way)) % length();
  }
};

Circle MakeCircle(const Fields& fields, std::string_view count_key) {
  Circle circle;
  circle.forward = fields.TakeCondition("forward", Condition::Never());
  circle.reverse = fields.TakeCondition("reverse", Condition::Never());
  circle.positions = fields.Number(count_key, 1);
  circle.time_ms = std::max<int64_t>(1, fields.Number("time", 1));
  circle.window_ms = fields.Number("window", circle.time_ms / 4);
  circle.first = fields.Number("first", 1);
  circle.at = fields.Number("at", circle.first);
  return circle;
}

std::optional<FieldFault> FaultOf(const Circle& circle, std::string_view what) {
  constexpr int64_t kMostOnACircle = 1000;
  if (circle.positions > kMostOnACircle)
    return FieldFault{std::string(what), "there are more than 1000 of them", "write fewer"};
  if (circle.at < circle.first || circle.at >= circle.first + circle.positions) {
    return FieldFault{"at", "there is no number " + std::to_string(circle.at),
                      "write one from " + std::to_string(circle.first) + " to " +
                          std::to_string(circle.first + circle.positions - 1)};
  }
  if (2 * circle.window_ms > circle.time_ms) {
    return FieldFault{"window", "the windows of two neighbours overlap", "write at most half of 'time'"};
  }
  return std::nullopt;
}

class TurretElement : public Element {
 public:
  TurretElement(const Fields& fields, Circle circle)
      : circle_(std::move(circle)),
        code_(fields.Drives("code")),
        coding_(CodingOf(fields.Word("coding", "binary"))),
        strobe_(fields.Drive("strobe")),
        home_(fields.Drive("home")),
        has_lock_(fields.Find("lock") != nullptr),
        lock_(fields.TakeCondition("lock", Condition::Never())),
        unlock_(fields.TakeCondition("unlock", Condition::Not(lock_))),
        lock_ms_(fields.Number("lock-time", kLockMs)),
        locked_(fields.Drive("locked")) {}

  uint32_t size() const override { return 2; }
  void Deliver(std::span<int64_t> state) const override {
    state[kAngle] = (circle_.at - circle_.first) * circle_.time_ms;
    state[kPressed] = has_lock_ ? lock_ms_ : 0;
  }
  void Advance(uint64_t elapsed_ms, std::span<const int64_t> reads, std::span<int64_t> state) const override {
    uint64_t turns_ms = elapsed_ms;
    if (has_lock_) turns_ms = MoveLock(elapsed_ms, reads, state);
    if (state[kPressed] == 0) circle_.Turn(turns_ms, reads, state[kAngle]);
  }
  void Show(std::span<const int64_t> state, std::span<int64_t> drives) const override {
    const std::optional<int64_t> position = circle_.PositionAt(state[kAngle]);
    if (strobe_) drives[*strobe_] = position ? 1 : 0;
    if (home_) drives[*home_] = position && *position == 0 ? 1 : 0;
    if (locked_) drives[*locked_] = has_lock_ && state[kPressed] == lock_ms_ && position ? 1 : 0;
    const uint64_t code =
        position ? CodeOf(coding_, static_cast<uint64_t>(*position + circle_.first), static_cast<uint64_t>(*position))
                 : 0;
    for (size_t bit = 0; bit < code_.size(); ++bit) drives[code_[bit]] = static_cast<int64_t>(code >> bit & 1);
  }

 private:
  enum : uint8_t { kAngle, kPressed };

  /// Gives how much of the time it was free.
  uint64_t MoveLock(uint64_t elapsed_ms, std::span<const int64_t> reads, std::span<int64_t> state) const {
    const bool into = lock_.Holds(reads), out = unlock_.Holds(reads);
    const auto ms = static_cast<int64_t>(std::min<uint64_t>(elapsed_ms, static_cast<uint64_t>(lock_ms_)));
    const std::optional<int64_t> position = circle_.PositionAt(state[kAngle]);
    if (into && !out && position) {
      state[kAngle] = *position * circle_.time_ms;  // the lock pulls it to its middle
      state[kPressed] = std::min(lock_ms_, state[kPressed] + ms);
      return 0;
    }
    if (out && !into) {
      const int64_t pressed = state[kPressed];
      state[kPressed] = std::max<int64_t>(0, pressed - ms);
      return elapsed_ms - std::min(elapsed_ms, static_cast<uint64_t>(pressed));
    }
    return elapsed_ms;
  }

  Circle circle_;
  std::vector<uint32_t> code_;
  Coding coding_;
  std::optional<uint32_t> strobe_, home_;
  bool has_lock_;
  Condition lock_, unlock_;
  int64_t lock_ms_;
  std::optional<uint32_t> locked_;
};

class MagazineElement : public Element {
 public:
  MagazineElement(const Fields& fields, Circle circle)
      : circle_(std::move(circle)), pulse_(fields.Drive("pulse")), reference_(fields.Drive("reference")) {}

  uint32_t size() const override { return 1; }
  void Deliver(std::span<int64_t> state) const override { state[0] = (circle_.at - circle_.first) * circle_.time_ms; }
  void Advance(uint64_t elapsed_ms, std::span<const int64_t> reads, std::span<int64_t> state) const override {
    circle_.Turn(elapsed_ms, reads, state[0]);
  }
  void Show(std::span<const int64_t> state, std::span<int64_t> drives) const override {
    const std::optional<int64_t> pocket = circle_.PositionAt(state[0]);
    if (pulse_) drives[*pulse_] = pocket ? 1 : 0;
    if (reference_) drives[*reference_] = pocket && *pocket == 0 ? 1 : 0;
  }

 private:
  Circle circle_;
  std::optional<uint32_t> pulse_, reference_;
};

/// Whether so many inputs can show every position.
std::optional<FieldFault> CodeFault(const Fields& fields, const Circle& circle) {
  const size_t inputs = fields.Drives("code").size();
  if (inputs == 0) return std::nullopt;
  const Coding coding = CodingOf(fields.Word("coding", "binary"));
  const auto last = static_cast<uint64_t>(circle.positions - 1);
  uint64_t bits = 0;
  for (uint64_t i = 0; i <= last; ++i) {
    if (coding == Coding::kOneHot && i >= inputs) {
      bits = ~uint64_t{0};
      break;
    }
    bits |= CodeOf(coding, i + static_cast<uint64_t>(circle.first), i);
  }
  if (inputs < 64 && bits >> inputs != 0) {
    return FieldFault{"code",
                      std::to_string(inputs) + " inputs cannot show " + std::to_string(circle.positions) + " positions",
                      "name more inputs, the lowest bit first"};
  }
  return std::nullopt;
}

}  // namespace

MadeElement MakeTurret(const Fields& fields) {
  Circle circle = MakeCircle(fields, "positions");
  std::optional<FieldFault> fault = FaultOf(circle, "positions");
  if (!fault) fault = CodeFault(fields, circle);
  for (const char* const key : {"unlock", "lock-time", "locked"}) {
    if (!fault && fields.Find("lock") == nullptr && fields.Find(key) != nullptr) {
      fault = FieldFault{key, "there is no lock", "write 'lock', the condition that presses it in"};
    }
  }
  if (fault) return {.element = {}, .fault = std::move(fault)};
  return {.element = std::make_unique<TurretElement>(fields, std::move(circle)), .fault = {}};
}

MadeElement MakeMagazine(const Fields& fields) {
  Circle circle = MakeCircle(fields, "pockets");
  if (std::optional<FieldFault> fault = FaultOf(circle, "pockets")) return {.element = {}, .fault = std::move(fault)};
  return {.element = std::make_unique<MagazineElement>(fields, std::move(circle)), .fault = {}};
}

}  // namespace plcxx::plant
