// The thread beside the scan that may wait: it writes retentive memory to files and prints what happened.
//
// In: a machine's Exchange. The scan never waits for it. At the end it does once more what there is to do, so that the
// last block given is in the files when Stop comes back.
#pragma once

#include <pthread.h>
#include <sched.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

#include <plcxx_host/pins.h>
#include <plcxx_host/retentive_files.h>

namespace plcxx::host {

/// Where text goes: standard error, or rtapi_print_msg.
using PrintLine = void (*)(Severity severity, const char* machine, const char* text);

/// "fault: kind PARAM_RANGE, index 3"
inline void EventText(const EventKind& kind, const Event& event, char* text, size_t size) noexcept {
  int at = snprintf(text, size, "%s", kind.name);
  for (uint32_t i = 0; i < kind.argument_count && i < Event::kMaxArguments; ++i) {
    if (at < 0 || static_cast<size_t>(at) >= size) return;
    const EventArgument& argument = kind.arguments[i];
    const uint32_t value = event.arguments[i];
    const size_t left = size - static_cast<size_t>(at);
    const char* const between = i == 0 ? ": " : ", ";
    const int more = value < argument.word_count
                         ? snprintf(text + at, left, "%s%s %s", between, argument.name, argument.words[value])
                         : snprintf(text + at, left, "%s%s %u", between, argument.name, static_cast<unsigned>(value));
    if (more < 0) return;
    at += more;
  }
}

/// `Machine`: the struct of that name in NAME_pins.hpp.
template <class Machine>
class Keeper {
 public:
  using Host = typename Machine::Host;

  /// Before the first period: what was stored last goes into `host`. `folder` nullptr: nothing is kept.
  /// False: it is said, and nothing will be kept.
  bool Load(Host& host, const char* folder, const char* name, PrintLine print) noexcept {
    host_ = &host;
    name_ = name;
    print_ = print;
    if constexpr (Machine::kRetentiveBytes == 0) return true;
    if (folder == nullptr || folder[0] == '\0') {
      Say(Severity::kNotice, "retentive memory is not kept: no folder for it is named");
      return false;
    }
    if (!files_.Open(folder, name)) {
      SayError("retentive memory is not kept", folder);
      return false;
    }
    keeps_ = true;
    switch (files_.Load(host.stored, Machine::kRetentiveBytes)) {
      case Loaded::kContent:
        host.stored_is_there = true;
        return true;
      case Loaded::kNothing:
        Say(Severity::kNotice, "no retentive memory is stored yet: the program's own values count");
        return true;
      case Loaded::kDamaged:
        Say(Severity::kFault, "both files of the retentive memory are damaged: the program's own values count");
        return false;
      case Loaded::kOtherSize:
        Say(Severity::kFault, "the retentive memory is that of another program: the program's own values count");
        return false;
      case Loaded::kUnreadable:
        SayError("the retentive memory cannot be read", folder);
        return false;
    }
    return false;
  }

  bool Start() noexcept {
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    sched_param none{};
    // Where the caller is real-time itself, this thread must not be.
    pthread_attr_setinheritsched(&attributes, PTHREAD_EXPLICIT_SCHED);
    pthread_attr_setschedpolicy(&attributes, SCHED_OTHER);
    pthread_attr_setschedparam(&attributes, &none);
    running_ = pthread_create(&thread_, &attributes, &Keeper::Loop, this) == 0;
    pthread_attr_destroy(&attributes);
    return running_;
  }

  /// The scan runs no more.
  void Stop() noexcept {
    if (running_) {
      __atomic_store_n(&stop_, true, __ATOMIC_RELEASE);
      pthread_join(thread_, nullptr);
      running_ = false;
    }
    if (host_ != nullptr) Work(When::kAtOnce);
  }

  /// The last attempt to store failed.
  bool failed() const noexcept { return __atomic_load_n(&failed_, __ATOMIC_RELAXED); }

 private:
  static constexpr int kTurnMs = 20;
  /// A program that counts in retentive memory must not wear out the disk: one store a second.
  static constexpr uint32_t kTurnsBetweenStores = 1000 / kTurnMs;

  static void* Loop(void* self) {
    auto& keeper = *static_cast<Keeper*>(self);
    while (!__atomic_load_n(&keeper.stop_, __ATOMIC_ACQUIRE)) {
      keeper.Work(When::kInTurn);
      const timespec pause{0, kTurnMs * 1'000'000};
      nanosleep(&pause, nullptr);
    }
    return nullptr;
  }

  enum class When : uint8_t { kInTurn, kAtOnce };
  void Work(When when) noexcept {
    char text[320];
    Event event;
    while (host_->events.Pop(event)) {
      if (event.what == Event::kMessage) {
        const MessageText& message = Machine::messages[event.arguments[0]];
        snprintf(text, sizeof text, "message %u: %s", static_cast<unsigned>(message.number), message.text);
        Say(Severity::kFault, text);
      } else if (event.what < Machine::kEvents) {
        EventText(Machine::events[event.what], event, text, sizeof text);
        Say(Machine::events[event.what].severity, text);
      }
    }
    if (const uint32_t lost = host_->events.lost(); lost != lost_) {
      snprintf(text, sizeof text, "%u events were not printed: they came too fast",
               static_cast<unsigned>(lost - lost_));
      lost_ = lost;
      Say(Severity::kFault, text);
    }
    if constexpr (Machine::kRetentiveBytes > 0) {
      if (!keeps_) return;
      if (const uint8_t* block = host_->retentive.Take(); block != nullptr) pending_ = block;
      if (wait_ > 0) --wait_;
      if (pending_ == nullptr || (wait_ > 0 && when == When::kInTurn)) return;
      const bool stored = files_.Store(pending_, Machine::kRetentiveBytes);
      if (!stored && !failed()) SayError("the retentive memory cannot be stored", "");
      __atomic_store_n(&failed_, !stored, __ATOMIC_RELAXED);
      if (stored) pending_ = nullptr;  // else it is tried again
      wait_ = kTurnsBetweenStores;
    }
  }

  void Say(Severity severity, const char* text) noexcept { print_(severity, name_, text); }
  void SayError(const char* text, const char* where) noexcept {
    char line[400];
    snprintf(line, sizeof line, "%s: %s%s%s", text, where, where[0] != '\0' ? ": " : "", strerror(errno));
    Say(Severity::kFault, line);
  }

  Host* host_ = nullptr;
  const char* name_ = "";
  PrintLine print_ = nullptr;
  RetentiveFiles files_;
  pthread_t thread_{};
  uint32_t lost_ = 0, wait_ = 0;
  const uint8_t* pending_ = nullptr;  // given, and not stored yet
  bool keeps_ = false, running_ = false, stop_ = false, failed_ = false;
};

}  // namespace plcxx::host
