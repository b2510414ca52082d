// The logic of one expression: everything that & | ^ ! == < > and the widenings between them stand for.
//
// One name for what the headers of bits, comparison and arithmetic define, so that a generated header that computes
// with signals and words need not know which of them an operation comes from. The meanings are there, none is here.
// Not its job: anything with state (timers.h, counters.h, one_shots.h, texts.h).
#pragma once

#include "plcxx/arith.h"
#include "plcxx/bits.h"
#include "plcxx/compare.h"
