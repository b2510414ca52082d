"""A machine with a link, for tests: generated code that runs in a process of its own, ten milliseconds a period, and is told
what its inputs are."""

import os
import subprocess

PROGRAM = "W3K0=[W3K0+1]\n$\nT0I(3)=I0A3\nU4A8=I0A3*/I0A4+U4A8*/I0A4\nU4A9=U4A8*/I0A5\nU4A10=T0U\nW2K2=[W3K0]\n"

MAIN = r"""
#include <fcntl.h>
#include <plcxx/debug_link.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstring>
#include <thread>

#include "lamp.hpp"
#include "lamp_link.hpp"

static uint8_t identity[plcxx::kLinkIdentityBytes];
struct Settings : plcxx::LinkSettings {
  static constexpr bool kCanWrite = true;
  static constexpr uint32_t kBytesPerPeriod = 256;
  static constexpr const uint8_t* kIdentity = identity;
};

struct Port {
  int listener = -1, peer = -1;
  bool Get(uint8_t& byte) {
    if (peer < 0) peer = accept4(listener, nullptr, nullptr, SOCK_NONBLOCK);
    const ssize_t count = recv(peer, &byte, 1, 0);
    if (count == 0) close(peer), peer = -1;
    return count == 1;
  }
  bool Put(uint8_t byte) { return send(peer, &byte, 1, MSG_NOSIGNAL) == 1 || peer < 0 || errno != EAGAIN; }
};

static bool inputs[8];
static bool permitted;

struct lamp::Host {
  uint32_t ms = 0;
  plcxx::DebugLink<State, Settings> link;
  Port port;
  State* machine = nullptr;
};

namespace lamp {
uint32_t now_ms(Host& host) noexcept { return host.ms; }
void read_inputs(Host& host, State& m) noexcept {
  m[I0A3] = inputs[3];
  m[I0A4] = inputs[4];
  m[I0A5] = inputs[5];
  host.link.Permit(permitted);
  host.link.AfterInputs(m);
}
void write_outputs(Host& host, const State&) noexcept { host.link.BeforeOutputs(*host.machine, host.port); }
void retentive_store(Host&, const Retentive&) noexcept {}
void retentive_load(Host&, Retentive&) noexcept {}
}  // namespace lamp

/// station SOCKET [other]; on its standard input a byte is an input that changes ('3'), or permits writing or not ('w', 'r').
int main(int count, char** arguments) {
  std::memcpy(identity, lamp_link::kIdentity, sizeof identity);
  if (count > 2) identity[60] ^= 1;
  sockaddr_un address = {AF_UNIX, {}};
  std::snprintf(address.sun_path, sizeof address.sun_path, "%s", arguments[1]);
  unlink(arguments[1]);
  static lamp::State machine;
  static lamp::Host host;
  host.port.listener = socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK, 0);
  host.machine = &machine;
  if (bind(host.port.listener, reinterpret_cast<sockaddr*>(&address), sizeof address) != 0) return 1;
  listen(host.port.listener, 1);
  fcntl(0, F_SETFL, O_NONBLOCK);
  lamp::init(machine, host);
  std::puts("runs");
  std::fflush(stdout);
  for (;; host.ms += 10) {
    lamp::period(machine, host);
    char command = 0;
    const ssize_t got = read(0, &command, 1);
    if (got == 0) return 0;
    if (got == 1 && command >= '0' && command <= '7') inputs[command - '0'] = !inputs[command - '0'];
    if (got == 1 && (command == 'w' || command == 'r')) permitted = command == 'w';
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
}
"""


def build(plcxx, root, folder):
    """The program in the folder, as lamp.plc, and the machine, whose path is given."""
    folder = str(folder)
    with open(os.path.join(folder, "lamp.plc"), "w", encoding="utf-8") as file:
        file.write(PROGRAM)
    with open(os.path.join(folder, "main.cc"), "w", encoding="utf-8") as file:
        file.write(MAIN)
    ran = subprocess.run([plcxx, "emit", "lamp.plc", "--link", "-o", "generated", "--quiet"], cwd=folder, capture_output=True,
                         text=True, check=False)
    assert ran.returncode == 0, ran.stderr
    runtime = os.path.join(root, "runtime_support")
    ran = subprocess.run(["c++", "-std=c++20", "-O1", "-I", "generated", "-I", runtime, "generated/lamp.cpp", "main.cc", "-o", "station"],
                         cwd=folder, capture_output=True, text=True, check=False)
    assert ran.returncode == 0, ran.stderr
    return os.path.join(folder, "station")


class Station:
    """The machine runs. Use as a context manager."""

    def __init__(self, program, socket, *more):
        self.process = subprocess.Popen([program, socket, *more], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        assert self.process.stdout.readline() == "runs\n"

    def tell(self, command):
        self.process.stdin.write(command)
        self.process.stdin.flush()

    def end(self):
        self.process.kill()
        self.process.wait()
        self.process.stdin.close()
        self.process.stdout.close()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.process.poll() is None:
            self.end()
