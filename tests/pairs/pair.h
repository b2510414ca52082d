// Pairs of programs with what is known of them, to judge `plcxx diff` by.
//
// In: a seed. Out: an old and a new version, in any of the six languages; and whether they are written so that they
// behave alike. Not its job: what diff says of them (judge.h).
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "transpiler/symbolic/terms/random.h"

namespace plcxx::pairs {

using terms::Random;

/// By name: the text of each file beside a program.
using Files = std::map<std::string, std::string>;
using ProgramOptions = std::map<std::string, std::string>;

struct ProgramText {
  std::string dialect;
  std::vector<std::string> sources;  // in this order
  Files files;
  ProgramOptions options;
  std::string scenario;  // of the old version, beside it; may be empty
};

struct Pair {
  ProgramText old_program, new_program;
  std::string what;      // was done
  bool alike = false;    // by construction
  bool renames = false;  // locations have other names
};

/// A program of the language: made at random, or one of the golden programs.
ProgramText RandomProgramText(const std::string& dialect, Random& random);
/// One place is another one. The same program where nothing could be changed.
Pair Mutated(const ProgramText& program, Random& random);
/// Written in another way. The same program where there was nothing to do.
Pair Rewritten(const ProgramText& program, Random& random);
/// Programs of hnc are made twice from one tree.
Pair RandomHncPair(Random& random);
/// A project of classicladder, changed as a drawing is, or drawn otherwise.
Pair RandomLadderPair(Random& random, bool alike);

inline uint32_t Below(Random& random, size_t count) { return static_cast<uint32_t>((random.Next() >> 9) % count); }

std::vector<std::string> LinesOf(const std::string& text);
std::string TextOf(const std::vector<std::string>& lines);

}  // namespace plcxx::pairs
