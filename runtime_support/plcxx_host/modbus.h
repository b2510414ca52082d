// A program whose terminals are coils and registers of Modbus TCP: `plcxx emit --host modbus`.
//
// As a server, another device writes the inputs and reads the outputs; as a client, the program reads inputs from
// remote terminals and writes its outputs there. A thread of its own talks to the network; the scan gets the newest
// picture and never waits. Where there was none for --timeout, or an answer that means nothing, the inputs get their
// declared safe values until the connection is back.
//   server: inputs are coils and holding registers, outputs are discrete inputs and input registers
//   client: inputs are discrete inputs and input registers, outputs are coils and holding registers
// Bits and numbers count from 0 in the order of the table; a number takes two registers, high word first, a float in
// IEEE single precision.
#pragma once

#include <errno.h>
#include <math.h>
#include <netdb.h>
#include <poll.h>
#include <pthread.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <unistd.h>

#include <modbus/modbus.h>

#include <plcxx_host/handover.h>
#include <plcxx_host/posix.h>

namespace plcxx::host {

enum class ModbusRole : uint8_t { kServer, kClient };

struct ModbusOptions {
  ModbusRole role = ModbusRole::kServer;
  char host[256] = "";
  char port[16] = "";
  int unit = 255;
  uint32_t timeout_ms = 500, poll_ms = 0;
};

template <class Machine>
class ModbusIo {
 public:
  static const char* Usage() noexcept {
    return "  -- --client HOST:PORT     reads inputs from remote terminals and writes outputs there\n"
           "  -- --server ADDRESS:PORT  waits for a master that does both\n"
           "     --timeout MS           inputs are safe after so long without a good answer (500)\n"
           "     --safe PIN=VALUE       what an input is then, once for each (0)\n"
           "     --poll MS              from one request to the next, as a client (the program's period)\n"
           "     --unit N               of the peer (255)\n"
           "  --map server|client       prints which pin is where, and ends; alone on the command line\n";
  }
  Opened Open(int argc, char** argv) noexcept {
    Count();
    if (!ReadOptions(argc, argv)) return Opened::kWrongUse;
    last_good_ns_ = 0;  // nothing has been received yet: safe values
    const int error = pthread_create(&thread_, nullptr, &ModbusIo::Loop, this);
    if (error == 0) return Opened::kYes;
    fprintf(stderr, "%s: modbus: no thread for the network: %s\n", Machine::kName, strerror(error));
    return Opened::kFailed;
  }

  void Read(Value* pins, int64_t now_ns) noexcept {
    const int64_t last = __atomic_load_n(&last_good_ns_, __ATOMIC_ACQUIRE);
    const bool alive = last != 0 && now_ns - last <= int64_t{options_.timeout_ms} * kNsPerMs;
    if (const uint8_t* fresh = received_.Take(); fresh != nullptr) memcpy(newest_, fresh, sizeof newest_);
    const Value* const from = alive ? newest_ : safe_;
    for (uint32_t i = 0; i < Machine::kPins; ++i) {
      if (IsInput(i)) pins[i] = from[i];
    }
    __atomic_store_n(&alive_, alive, __ATOMIC_RELAXED);
  }
  void Write(const Value* pins) noexcept { sent_.Give(pins); }

  void Close() noexcept {
    __atomic_store_n(&stop_, true, __ATOMIC_RELEASE);
    pthread_join(thread_, nullptr);
  }

  /// What is where; for people, as a table.
  static void PrintMap(ModbusRole role) noexcept {
    const bool server = role == ModbusRole::kServer;
    uint32_t counts[4] = {};
    for (uint32_t i = 0; i < Machine::kPins; ++i) {
      const Pin& pin = Machine::pins[i];
      if (pin.role != Role::kTerminal) continue;
      const bool in = pin.direction == Direction::kIn, bit = pin.type == Type::kBit;
      uint32_t& count = counts[(in ? 0 : 2) + (bit ? 0 : 1)];
      const char* const table =
          bit ? (in == server ? "coil" : "discrete input") : (in == server ? "holding register" : "input register");
      printf("%-16s %5u  %-3s %-32s %s  %s\n", table, static_cast<unsigned>(bit ? count : 2 * count), in ? "in" : "out",
             pin.name, pin.address, pin.comment);
      ++count;
    }
  }

 private:
  static constexpr int kPauseMs = 100;  // before a connection is tried again

  static bool IsInput(uint32_t i) noexcept {
    return Machine::pins[i].role == Role::kTerminal && Machine::pins[i].direction == Direction::kIn;
  }
  static bool IsOutput(uint32_t i) noexcept {
    return Machine::pins[i].role == Role::kTerminal && Machine::pins[i].direction == Direction::kOut;
  }

  void Count() noexcept {
    for (uint32_t i = 0; i < Machine::kPins; ++i) {
      const bool bit = Machine::pins[i].type == Type::kBit;
      if (IsInput(i)) ++(bit ? in_bits_ : in_numbers_);
      if (IsOutput(i)) ++(bit ? out_bits_ : out_numbers_);
    }
  }

  // --- options ---

  static bool Fail(const char* what, const char* why) noexcept {
    fprintf(stderr, "%s: '%s': %s\n", Machine::kName, what, why);
    return false;
  }
  static bool Number(const char* text, uint32_t least, uint32_t most, uint32_t& value) noexcept {
    uint64_t number = 0;
    if (!ReadWholeNumber(text, least, most, number)) return false;
    value = static_cast<uint32_t>(number);
    return true;
  }
  bool Address(const char* text) noexcept {
    const char* const colon = strrchr(text, ':');
    uint32_t port = 0;
    const bool needs_host = options_.role == ModbusRole::kClient;  // a server may listen everywhere
    if (colon == nullptr || (needs_host && colon == text) ||
        static_cast<size_t>(colon - text) >= sizeof options_.host || !Number(colon + 1, 1, 65535, port))
      return Fail(text, "no address: write HOST:PORT");
    memcpy(options_.host, text, static_cast<size_t>(colon - text));
    snprintf(options_.port, sizeof options_.port, "%u", static_cast<unsigned>(port));
    return true;
  }
  bool Safe(const char* text) noexcept {
    const char* const equal = strchr(text, '=');
    for (uint32_t i = 0; equal != nullptr && i < Machine::kPins; ++i) {
      const Pin& pin = Machine::pins[i];
      if (!IsInput(i) || strlen(pin.name) != static_cast<size_t>(equal - text) ||
          strncmp(pin.name, text, static_cast<size_t>(equal - text)) != 0)
        continue;
      char* end = nullptr;
      const double number = strtod(equal + 1, &end);
      if (end == equal + 1 || *end != '\0' || !SetNumber(safe_[i], pin.type, number))
        return Fail(text, "the pin cannot have this value");
      if (has_safe_[i]) return Fail(text, "given twice");
      has_safe_[i] = true;
      return true;
    }
    return Fail(text, "no input of the program: write PIN=VALUE, names are in --map");
  }
  static bool SetNumber(Value& value, Type type, double number) noexcept {
    switch (type) {
      case Type::kBit:
        value.bit = number != 0;
        return number == 0 || number == 1;
      case Type::kS32:
        if (!(number >= -2147483648.0 && number <= 2147483647.0)) return false;
        value.s32 = static_cast<int32_t>(number);
        return true;
      case Type::kU32:
        if (!(number >= 0 && number <= 4294967295.0)) return false;
        value.u32 = static_cast<uint32_t>(number);
        return true;
      case Type::kFloat:
        value.real = number;
        return isfinite(number) != 0;
    }
    return false;
  }
  bool ReadOptions(int argc, char** argv) noexcept {
    static constexpr const char* kOptions =
        "no option; there are: --server, --client, --unit, --timeout, --poll, --safe";
    bool addressed = false, has_unit = false, has_timeout = false;
    for (int i = 0; i < argc; ++i) {
      const char* const word = argv[i];
      const bool server = strcmp(word, "--server") == 0, address = server || strcmp(word, "--client") == 0,
                 unit = strcmp(word, "--unit") == 0, timeout = strcmp(word, "--timeout") == 0,
                 poll = strcmp(word, "--poll") == 0, safe = strcmp(word, "--safe") == 0;
      if (!address && !unit && !timeout && !poll && !safe) return Fail(word, kOptions);
      if (address && addressed) return Fail(word, "a second address: one of --server and --client, once");
      if ((unit && has_unit) || (timeout && has_timeout) || (poll && options_.poll_ms != 0)) {
        return Fail(word, "given twice");
      }
      if (i + 1 == argc) return Fail(word, "needs a value");
      const char* const value = argv[++i];
      if (address) {
        options_.role = server ? ModbusRole::kServer : ModbusRole::kClient;
        if (!Address(value)) return false;
        addressed = true;
      }
      if (unit) {
        uint32_t number = 0;
        if (!Number(value, 0, 255, number)) return Fail(value, "no unit: 0 to 255");
        options_.unit = static_cast<int>(number);
        has_unit = true;
      }
      if (timeout) {
        if (!Number(value, 1, 60'000, options_.timeout_ms)) return Fail(value, "no timeout: 1 to 60000 ms");
        has_timeout = true;
      }
      if (poll && !Number(value, 1, 60'000, options_.poll_ms)) {
        return Fail(value, "no time between two requests: 1 to 60000 ms");
      }
      if (safe && !Safe(value)) return false;
    }
    if (!addressed) return Fail("--server", "missing: --server ADDRESS:PORT, or --client HOST:PORT");
    if (options_.role == ModbusRole::kServer && options_.poll_ms != 0) {
      return Fail("--poll", "is between the requests of a client: leave it out");
    }
    if (options_.poll_ms == 0) options_.poll_ms = Machine::kBaseMs;
    return true;
  }

  // --- the thread that talks to the network ---

  static void* Loop(void* self) {
    auto& io = *static_cast<ModbusIo*>(self);
    bool was_alive = false;
    io.Say("no connection yet: safe inputs");
    while (!io.stopped()) {
      if (io.options_.role == ModbusRole::kServer) {
        io.Serve(was_alive);
      } else {
        io.Ask(was_alive);
      }
      if (!io.stopped()) usleep(kPauseMs * 1000);
    }
    return nullptr;
  }

  bool stopped() const noexcept { return __atomic_load_n(&stop_, __ATOMIC_ACQUIRE); }
  void Good() noexcept { __atomic_store_n(&last_good_ns_, ClockNs(), __ATOMIC_RELEASE); }
  /// Says each change once.
  void Follow(bool& was_alive) noexcept {
    const bool alive = __atomic_load_n(&alive_, __ATOMIC_RELAXED);
    if (alive != was_alive) Say(alive ? "connected" : "connection lost: safe inputs");
    was_alive = alive;
  }
  static void Say(const char* text) noexcept { fprintf(stderr, "%s: modbus: %s\n", Machine::kName, text); }
  void SayError(const char* what) noexcept { SayOnce(what, errno, modbus_strerror(errno)); }
  /// Of an address; libmodbus says "connection refused" of a name that nobody knows, too.
  void SayUnreachable(const char* what) noexcept {
    const int error = errno;
    addrinfo hints = {};
    hints.ai_socktype = SOCK_STREAM;
    hints.ai_flags = options_.role == ModbusRole::kServer ? AI_PASSIVE : 0;
    addrinfo* addresses = nullptr;
    const int unknown = error == ECONNREFUSED && options_.host[0] != '\0'
                            ? getaddrinfo(options_.host, options_.port, &hints, &addresses)
                            : 0;
    if (addresses != nullptr) freeaddrinfo(addresses);
    if (unknown != 0) {
      SayOnce(what, unknown, gai_strerror(unknown));  // its numbers are below zero
    } else {
      SayOnce(what, error, modbus_strerror(error));
    }
  }
  void SayOnce(const char* what, int error, const char* why) noexcept {
    if (error == last_error_) return;
    last_error_ = error;
    fprintf(stderr, "%s: modbus: %s %s:%s: %s\n", Machine::kName, what, options_.host, options_.port, why);
  }
  modbus_t* NewContext() noexcept {
    modbus_t* const bus = modbus_new_tcp_pi(options_.host[0] != '\0' ? options_.host : nullptr, options_.port);
    if (bus == nullptr) return nullptr;
    const uint32_t wait = options_.timeout_ms / 2 > 0 ? options_.timeout_ms / 2 : 1;
    modbus_set_response_timeout(bus, wait / 1000, wait % 1000 * 1000);
    modbus_set_byte_timeout(bus, wait / 1000, wait % 1000 * 1000);
    modbus_set_slave(bus, options_.unit);
    return bus;
  }

  /// Two registers of each number of one direction; false: one is no number.
  static void PutRegisters(const Value& value, Type type, uint16_t* registers) noexcept {
    uint32_t bits = type == Type::kFloat ? 0 : value.u32;
    if (type == Type::kFloat) {
      const auto single = static_cast<float>(value.real);
      memcpy(&bits, &single, sizeof bits);
    }
    registers[0] = static_cast<uint16_t>(bits >> 16);
    registers[1] = static_cast<uint16_t>(bits);
  }
  static bool GetRegisters(Value& value, Type type, const uint16_t* registers) noexcept {
    const uint32_t bits = uint32_t{registers[0]} << 16 | registers[1];
    if (type != Type::kFloat) {
      value.u32 = bits;
      return true;
    }
    float single = 0;
    memcpy(&single, &bits, sizeof single);
    if (!isfinite(single)) return false;
    value.real = static_cast<double>(single);
    return true;
  }
  bool TakeInputs(const uint8_t* bits, const uint16_t* registers) noexcept {
    Value image[Machine::kPins + 1] = {};
    for (uint32_t i = 0; i < Machine::kPins; ++i) {
      if (!IsInput(i)) continue;
      if (Machine::pins[i].type == Type::kBit) {
        image[i].bit = *bits++ != 0;
      } else {
        if (!GetRegisters(image[i], Machine::pins[i].type, registers)) return false;
        registers += 2;
      }
    }
    received_.Give(image);
    Good();
    return true;
  }
  void GiveOutputs(uint8_t* bits, uint16_t* registers) noexcept {
    if (const uint8_t* fresh = sent_.Take(); fresh != nullptr) memcpy(outputs_, fresh, sizeof outputs_);
    for (uint32_t i = 0; i < Machine::kPins; ++i) {
      if (!IsOutput(i)) continue;
      if (Machine::pins[i].type == Type::kBit) {
        *bits++ = outputs_[i].bit ? 1 : 0;
      } else {
        PutRegisters(outputs_[i], Machine::pins[i].type, registers);
        registers += 2;
      }
    }
  }

  void Serve(bool& was_alive) noexcept {
    modbus_t* const bus = NewContext();
    modbus_mapping_t* const tables =
        modbus_mapping_new(static_cast<int>(in_bits_), static_cast<int>(out_bits_), static_cast<int>(2 * in_numbers_),
                           static_cast<int>(2 * out_numbers_));
    int listening = bus != nullptr && tables != nullptr ? modbus_tcp_pi_listen(bus, kMaxClients) : -1;
    if (listening < 0) SayUnreachable("cannot listen at");
    pollfd sockets[kMaxClients + 1];
    nfds_t count = 1;
    sockets[0] = {listening, POLLIN, 0};
    while (listening >= 0 && !stopped()) {
      Follow(was_alive);
      if (poll(sockets, count, 20) <= 0) continue;
      for (nfds_t i = count - 1; i >= 1; --i) {
        if (sockets[i].revents == 0 || Answer(bus, tables, sockets[i].fd)) continue;
        close(sockets[i].fd);
        sockets[i] = sockets[--count];
      }
      if ((sockets[0].revents & POLLIN) != 0) {
        const int fresh = accept(listening, nullptr, nullptr);
        if (fresh >= 0 && count <= kMaxClients) {
          sockets[count++] = {fresh, POLLIN, 0};
        } else if (fresh >= 0) {
          close(fresh);
        }
      }
    }
    for (nfds_t i = 1; i < count; ++i) close(sockets[i].fd);
    if (listening >= 0) close(listening);
    if (tables != nullptr) modbus_mapping_free(tables);
    if (bus != nullptr) modbus_free(bus);
  }

  /// One request; false: the connection is to be closed.
  bool Answer(modbus_t* bus, modbus_mapping_t* tables, int socket) noexcept {
    uint8_t request[MODBUS_TCP_MAX_ADU_LENGTH];
    modbus_set_socket(bus, socket);
    // A peer that begins a request and does not end it holds up the others for this long, and no longer.
    modbus_set_indication_timeout(bus, 0, 50'000);
    const int bytes = modbus_receive(bus, request);
    if (bytes < 0) {
      if (errno != ECONNRESET) SayError("a request that means nothing, at");
      return false;
    }
    if (bytes == 0) return true;
    GiveOutputs(tables->tab_input_bits, tables->tab_input_registers);
    if (modbus_reply(bus, request, bytes, tables) < 0) return false;
    if (!TakeInputs(tables->tab_bits, tables->tab_registers)) Say("a float that is no number: not taken");
    return true;
  }

  void Ask(bool& was_alive) noexcept {
    modbus_t* const bus = NewContext();
    if (bus == nullptr || modbus_connect(bus) != 0) {
      SayUnreachable("cannot connect to");
    } else {
      int64_t next = ClockNs();
      while (!stopped()) {
        Follow(was_alive);
        if (!Exchange(bus)) {
          SayError("no good answer from");
          break;
        }
        last_error_ = 0;
        next += int64_t{options_.poll_ms} * kNsPerMs;
        if (const int64_t wait = next - ClockNs(); wait > 0) {
          usleep(static_cast<useconds_t>(wait / 1000));
        } else {
          next = ClockNs();
        }
      }
      modbus_close(bus);
    }
    if (bus != nullptr) modbus_free(bus);
    Follow(was_alive);
  }

  /// All inputs, then all outputs, in as few requests as the protocol has room for.
  bool Exchange(modbus_t* bus) noexcept {
    uint8_t in_bits[Machine::kPins + 1] = {}, out_bits[Machine::kPins + 1] = {};
    uint16_t in_registers[2 * Machine::kPins + 2] = {}, out_registers[2 * Machine::kPins + 2] = {};
    const auto in_pieces = [](uint32_t count, uint32_t most, auto&& piece) {
      for (uint32_t at = 0; at < count; at += most) {
        const int part = static_cast<int>(count - at < most ? count - at : most);
        if (piece(static_cast<int>(at), part) != part) return false;
      }
      return true;
    };
    if (!in_pieces(in_bits_, MODBUS_MAX_READ_BITS,
                   [&](int at, int n) { return modbus_read_input_bits(bus, at, n, in_bits + at); }))
      return false;
    if (!in_pieces(2 * in_numbers_, MODBUS_MAX_READ_REGISTERS,
                   [&](int at, int n) { return modbus_read_input_registers(bus, at, n, in_registers + at); }))
      return false;
    if (!TakeInputs(in_bits, in_registers)) {
      errno = EMBBADDATA;
      return false;
    }
    GiveOutputs(out_bits, out_registers);
    return in_pieces(out_bits_, MODBUS_MAX_WRITE_BITS,
                     [&](int at, int n) { return modbus_write_bits(bus, at, n, out_bits + at); }) &&
           in_pieces(2 * out_numbers_, MODBUS_MAX_WRITE_REGISTERS,
                     [&](int at, int n) { return modbus_write_registers(bus, at, n, out_registers + at); });
  }

  static constexpr nfds_t kMaxClients = 8;
  static constexpr uint32_t kImageBytes = sizeof(Value) * (Machine::kPins + 1);

  ModbusOptions options_;
  uint32_t in_bits_ = 0, in_numbers_ = 0, out_bits_ = 0, out_numbers_ = 0;
  Value safe_[Machine::kPins + 1] = {}, newest_[Machine::kPins + 1] = {}, outputs_[Machine::kPins + 1] = {};
  bool has_safe_[Machine::kPins + 1] = {};
  Handover<kImageBytes> received_ = {}, sent_ = {};
  int64_t last_good_ns_ = 0;
  int last_error_ = 0;
  bool alive_ = false, stop_ = false;
  pthread_t thread_{};
};

template <class Machine>
int RunModbus(int argc, char** argv) {
  if (argc == 3 && strcmp(argv[1], "--map") == 0 &&
      (strcmp(argv[2], "server") == 0 || strcmp(argv[2], "client") == 0)) {
    ModbusIo<Machine>::PrintMap(argv[2][0] == 's' ? ModbusRole::kServer : ModbusRole::kClient);
    return 0;
  }
  if (argc > 1 && strcmp(argv[1], "--map") == 0) {
    fprintf(stderr, "%s: '--map': takes server or client, alone on the command line\n", Machine::kName);
    return 2;
  }
  static ModbusIo<Machine> io;
  return RunLoop<Machine>(argc, argv, io);
}

}  // namespace plcxx::host
