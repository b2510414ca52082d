// Refuses to compile where floating point would not be that of the simulator.
//
// Every operation of a program is rounded to its own type, and there are infinities and NaN. An option that gives this
// up for all of a firmware (-ffast-math, -Ofast) and the registers of the x87 give other results without a word. What
// no compiler tells is not here: -ffp-contract=off has to be given where the processor multiplies and adds at once.
#pragma once

static_assert(__FINITE_MATH_ONLY__ == 0,
              "numbers with a point have infinities and NaN in a PLC program: compile without -ffast-math and -Ofast");
static_assert(__FLT_EVAL_METHOD__ != 1 && __FLT_EVAL_METHOD__ != 2,
              "each operation of a PLC program is rounded to its own type: for 32-bit x86 compile with -msse2 "
              "-mfpmath=sse");
