// A program as a module of LinuxCNC's HAL: `plcxx emit --host linuxcnc`.
//
// `loadrt NAME [names=A,B] [retentive=FOLDER]` makes one instance, or those named; each has its pins, its function
// INSTANCE.period for a thread, and a thread of its own outside of real time for files and messages (Keeper).
// The function runs in a thread whose period is the program's, or goes into it without rest (a servo thread of 1 ms for
// a program of 10 ms); in any other it refuses: outputs stay 0, and INSTANCE.host.period-fault says so.
#pragma once

#include <errno.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <plcxx_host/hal.h>
#include <plcxx_host/keeper.h>
#include <plcxx_host/pins.h>

// Parameters of loadrt.
static char* names = nullptr;
static char* retentive = nullptr;

namespace plcxx::host {

template <class Machine>
class HalModule {
 public:
  static int Load(const char* names, const char* folder) noexcept {
    component_ = hal_init(Machine::kName);
    if (component_ < 0) return component_;
    int result = LoadInstances(names != nullptr && names[0] != '\0' ? names : Machine::kName, folder);
    if (result == 0) result = hal_ready(component_);
    if (result != 0) Unload();
    return result;
  }

  static void Unload() noexcept {
    for (uint32_t i = 0; i < count_; ++i) instances_[i].keeper.Stop();
    count_ = 0;
    if (component_ >= 0) hal_exit(component_);
    component_ = -1;
  }

 private:
  static constexpr uint32_t kMaxInstances = 8;
  /// Of a name in HAL. Its header counts without the 0 at the end.
  static constexpr size_t kNameBytes = HAL_NAME_LEN + 1;

  /// Beside those of the program.
  struct OwnPins {
    HalPin running, period_fault, retentive_fault;
  };

  struct Instance {
    typename Machine::State state;
    typename Machine::Host host;
    HalPin* pins;
    OwnPins* own;
    long period_ns;  // that was looked at
    uint32_t every, calls;
    bool retentive_fault;  // since it was loaded
    char name[kNameBytes];
    Keeper<Machine> keeper;
  };

  static int LoadInstances(const char* names, const char* folder) noexcept {
    for (const char* at = names; *at != '\0';) {
      const size_t length = strcspn(at, ",");
      if (count_ == kMaxInstances) return Refuse(names, "more than 8 instances");
      if (length == 0 || length >= kNameBytes) return Refuse(at, "no name of an instance");
      Instance& instance = instances_[count_];
      memcpy(instance.name, at, length);
      instance.name[length] = '\0';
      for (uint32_t i = 0; i < count_; ++i) {
        if (strcmp(instances_[i].name, instance.name) == 0) return Refuse(instance.name, "an instance twice");
      }
      // Counted before it is complete: Unload stops what Start began.
      ++count_;
      if (const int result = LoadInstance(instance, folder); result != 0) return result;
      at += length;
      if (*at == ',') ++at;
    }
    return 0;
  }

  static int LoadInstance(Instance& instance, const char* folder) noexcept {
    instance.pins = static_cast<HalPin*>(hal_malloc(sizeof(HalPin) * (Machine::kPins + 1)));
    instance.own = static_cast<OwnPins*>(hal_malloc(sizeof(OwnPins)));
    if (instance.pins == nullptr || instance.own == nullptr) return Refuse(instance.name, "HAL has no memory left");
    for (uint32_t i = 0; i < Machine::kPins; ++i) {
      const Pin& pin = Machine::pins[i];
      if (const int result = AddPin(instance, instance.pins[i], pin.type, pin.direction, pin.name); result != 0)
        return result;
    }
    OwnPins& own = *instance.own;
    if (AddPin(instance, own.running, Type::kBit, Direction::kOut, "host.running") != 0 ||
        AddPin(instance, own.period_fault, Type::kBit, Direction::kOut, "host.period-fault") != 0 ||
        AddPin(instance, own.retentive_fault, Type::kBit, Direction::kOut, "host.retentive-fault") != 0)
      return -EINVAL;
    char name[2 * kNameBytes];
    snprintf(name, sizeof name, "%s.period", instance.name);
    if (const int result = ExportFunction(name, &Run, &instance, component_); result != 0) return result;
    const bool kept = instance.keeper.Load(instance.host, folder, instance.name, &Print);
    SetBit(own.retentive_fault, !kept);
    instance.retentive_fault = !kept;
    if (!instance.keeper.Start()) return Refuse(instance.name, "no thread for files and messages");
    return 0;
  }

  static int AddPin(Instance& instance, HalPin& pin, Type type, Direction direction, const char* name) noexcept {
    char full[kNameBytes + 64];
    const int length = snprintf(full, sizeof full, "%s.%s", instance.name, name);
    if (length < 0 || static_cast<size_t>(length) >= kNameBytes) {
      rtapi_print_msg(RTAPI_MSG_ERR,
                      "%s: the pin %s.%s has %d characters, and HAL takes %d: name the instance shorter\n",
                      Machine::kName, instance.name, name, length, HAL_NAME_LEN);
      return -EINVAL;
    }
    const int result = NewPin(pin, component_, type, direction, full);
    if (result != 0) rtapi_print_msg(RTAPI_MSG_ERR, "%s: HAL refuses the pin %s (%d)\n", Machine::kName, full, result);
    return result;
  }

  static int Refuse(const char* what, const char* why) noexcept {
    rtapi_print_msg(RTAPI_MSG_ERR, "%s: '%s': %s\n", Machine::kName, what, why);
    return -EINVAL;
  }

  /// From the keeper's thread.
  static void Print(Severity severity, const char* instance, const char* text) {
    rtapi_print_msg(severity == Severity::kFault ? RTAPI_MSG_ERR : RTAPI_MSG_INFO, "%s: %s\n", instance, text);
  }

  // --- in the real-time thread ---

  static void Run(void* argument, long period_ns) {
    auto& instance = *static_cast<Instance*>(argument);
    if (period_ns != instance.period_ns) LookAtPeriod(instance, period_ns);
    if (instance.every == 0) return;
    if (++instance.calls < instance.every) return;
    instance.calls = 0;
    for (uint32_t i = 0; i < Machine::kPins; ++i) {
      if (Machine::pins[i].direction != Direction::kOut)
        Take(instance.host.pins[i], instance.pins[i], Machine::pins[i].type);
    }
    Machine::Step(instance.state, instance.host);
    for (uint32_t i = 0; i < Machine::kPins; ++i) {
      if (Machine::pins[i].direction != Direction::kIn)
        Give(instance.host.pins[i], instance.pins[i], Machine::pins[i].type);
    }
    SetBit(instance.own->retentive_fault, instance.retentive_fault || instance.keeper.failed());
  }

  /// `every`: so many calls are one period of the program; 0: the thread's period does not fit.
  static void LookAtPeriod(Instance& instance, long period_ns) noexcept {
    instance.period_ns = period_ns;
    constexpr long kWanted = static_cast<long>(Machine::kBaseMs) * 1'000'000;
    const long every = period_ns > 0 ? (kWanted + period_ns / 2) / period_ns : 0;
    const long difference = every * period_ns - kWanted;
    // A clock may be off by parts of a thousand; a rest of the division is not.
    const bool fits = every > 0 && (difference < 0 ? -difference : difference) <= kWanted / 200;
    instance.every = fits ? static_cast<uint32_t>(every) : 0;
    instance.calls = instance.every > 0 ? instance.every - 1 : 0;  // the first call is a period
    if (!fits) {
      for (uint32_t i = 0; i < Machine::kPins; ++i) {
        if (Machine::pins[i].direction == Direction::kOut) Give(Value{}, instance.pins[i], Machine::pins[i].type);
      }
      instance.host.events.Push(
          {Machine::kPeriodFault, {static_cast<uint32_t>(period_ns / 1000), Machine::kBaseMs * 1000}});
    }
    SetBit(instance.own->running, fits);
    SetBit(instance.own->period_fault, !fits);
  }

  static void Take(Value& value, const HalPin& pin, Type type) noexcept {
    switch (type) {
      case Type::kBit:
        value.bit = GetBit(pin);
        return;
      case Type::kS32:
        value.s32 = GetS32(pin);
        return;
      case Type::kU32:
        value.u32 = GetU32(pin);
        return;
      case Type::kFloat:
        value.real = GetReal(pin);
        return;
    }
  }
  static void Give(const Value& value, HalPin& pin, Type type) noexcept {
    switch (type) {
      case Type::kBit:
        SetBit(pin, value.bit);
        return;
      case Type::kS32:
        SetS32(pin, value.s32);
        return;
      case Type::kU32:
        SetU32(pin, value.u32);
        return;
      case Type::kFloat:
        SetReal(pin, value.real);
        return;
    }
  }

  static inline int component_ = -1;
  static inline uint32_t count_ = 0;
  static inline Instance instances_[kMaxInstances] = {};  // no constructor runs when the module is loaded
};

}  // namespace plcxx::host

/// What a module has to have for LinuxCNC.
#define PLCXX_HAL_MODULE(Machine)                                                              \
  RTAPI_MP_STRING(names, "names of the instances")                                             \
  RTAPI_MP_STRING(retentive, "folder for the retentive memory")                                \
  extern "C" {                                                                                 \
  int rtapi_app_main(void) { return plcxx::host::HalModule<Machine>::Load(names, retentive); } \
  void rtapi_app_exit(void) { plcxx::host::HalModule<Machine>::Unload(); }                     \
  }
