// plcxx live --link: values of a running machine, on the terminal.
#pragma once

#include <string>
#include <vector>

#include "transpiler/compilation/compilation.h"

namespace plcxx::driver {

/// As the command line has them.
struct LinkWords {
  std::string address;  // --link; empty: no machine is meant
  std::vector<std::string> read, watch, write, force;
  std::string duration;  // --for
  std::string waveform;  // --save
};

/// What is not right about the words without a machine; empty: nothing.
std::string WrongAbout(const LinkWords& words);

/// Something is to be printed, or held; else the page shows the machine.
bool IsForTerminal(const LinkWords& words);

/// Refuses a machine that runs another program. Gives the exit code.
int RunLink(const LinkWords& words, const compilation::Compilation& compilation);

}  // namespace plcxx::driver
