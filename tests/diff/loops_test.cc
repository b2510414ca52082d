// plcxx diff: loops of which nobody knows how often they go round, and what may and may not pass through them.
#include <gtest/gtest.h>

#include <string>

#include "tests/diff/compared_texts.h"

namespace plcxx::review::diff {
namespace {

constexpr uint64_t kTimeMs = 20'000;

Diff CompareMechanisms(const std::string& old_text, const std::string& new_text) {
  return ComparedTexts(kTechnol, old_text, new_text, {.time_ms = kTimeMs});
}

/// Where it is seen how a loop ends, and what else it does may stay open.
Diff CompareUntilShown(const std::string& old_text, const std::string& new_text, const std::string& difference) {
  return ComparedUntilShown(kTechnol, old_text, new_text, {difference}, kTimeMs);
}

ItemVerdict VerdictOf(const Diff& diff, const std::string& name) {
  for (const DiffItem& item : diff.items) {
    if (item.name == name) return item.verdict;
  }
  return ItemVerdict::kEqual;
}

std::string Replaced(std::string text, const std::string& part, const std::string& other) {
  const size_t at = text.find(part);
  EXPECT_NE(at, std::string::npos) << part;
  return at == std::string::npos ? text : text.replace(at, part.size(), other);
}

/// Two mechanisms that raise errors; the first one tries three times, so that it goes back.
const std::string kTwoMechanisms = R"(          DATA
IN0:      DFM A1,A2,B1,B2
OUT0:     DFM OA,OB
TRIES:    DS 1
          DATA_END
          MODULE_MAIN
          LDR  A1
          FL1  1,MA
          LDR  B1
          FL1  1,MB
          MECH_BEGIN MB
          FL   1,OB
          LDR  B2
          TEX0 -,5,B_FAULT
          JUM  B_DONE
B_FAULT:  ESET 20,2
B_DONE:   FL   0,OB
          MECH_END MB
          MECH_BEGIN MA
          LOD  CNST.0
          STO  TRIES
AGAIN:    FL   1,OA
          LDR  A2
          TEX0 -,5,A_FAULT
          JUM  A_DONE
A_FAULT:  FL   0,OA
          LOD  TRIES
          AD   CNST.1
          STO  TRIES
          LT   CNST.3
          JL1  AGAIN
          ESET 10,1
A_DONE:   MECH_END MA
          MODULE_MAIN_END
          STOP
)";

TEST(Loops, AnErrorThatIsRaisedElsewhereChangesNoLoop) {
  // MA is told nothing of what the control was told by MB.
  const Diff diff = CompareMechanisms(kTwoMechanisms, Replaced(kTwoMechanisms, "LDR  B1", "LDR  -B1"));
  EXPECT_EQ(VerdictOf(diff, "OB"), ItemVerdict::kDifferent);
  EXPECT_EQ(VerdictOf(diff, "OA"), ItemVerdict::kEqual);
  EXPECT_EQ(VerdictOf(diff, "MA"), ItemVerdict::kEqual);
  EXPECT_EQ(VerdictOf(diff, "TRIES"), ItemVerdict::kEqual);
  // Both tell it: what it has been told is another story.
  EXPECT_NE(VerdictOf(diff, "calls of error_raised"), ItemVerdict::kEqual);
}

/// A loop that goes round as often as an input says, and writes LAMP now and then without looking at it.
const std::string kCounting = R"(          DATA
IN0:      DFM KEY
OUT0:     DFM LAMP,OTHER
LEFT:     DS 2
          DATA_END
          MODULE_MAIN
          LDR  KEY
          WR   LAMP
          LOD  IN10
          STO  LEFT
ROUND:    LOD  LEFT
          EQ   CNST.7
          FL1  1,LAMP
          LOD  LEFT
          SU   CNST.1
          STO  LEFT
          NE   CNST.0
          JL1  ROUND
          LDR  KEY
          WR   OTHER
          MODULE_MAIN_END
          STOP
)";

TEST(Loops, WhatALoopOnlyWritesKeepsWhatWasThereBefore) {
  // Most often the loop leaves LAMP as it was: the change in front of it comes through.
  const Diff lamp = CompareMechanisms(kCounting, Replaced(kCounting, "WR   LAMP", "FL   0,LAMP"));
  EXPECT_EQ(VerdictOf(lamp, "LAMP"), ItemVerdict::kDifferent);
  EXPECT_EQ(VerdictOf(lamp, "LEFT"), ItemVerdict::kEqual);
  EXPECT_EQ(VerdictOf(lamp, "OTHER"), ItemVerdict::kEqual);
  const Diff rounds = CompareUntilShown(kCounting, Replaced(kCounting, "LOD  IN10", "LOD  IN11"), "LAMP");
  EXPECT_EQ(VerdictOf(rounds, "LAMP"), ItemVerdict::kDifferent);
}

/// Looks for a tool in a table of eight, as a subprogram.
const std::string kSearch = R"(          DATA
IN0:      DFM KEY
FOUND:    DS 2
TOOL:     DS 2
CMOS      STRUC
TAB       DW 9 DUP (?)
CMOS      ENDS
          DATA_END
          MODULE_MAIN
          LOD  IN4
          CALL SEARCH
          LOD  FOUND
          STO  OUT4
          MODULE_MAIN_END
SEARCH:   STO  TOOL
          LOD  CNST.0
          STO  FOUND
          MOV  BX,0
NEXT:     LOD  TOOL
          EQ   WORD.LABEL_MEM.TAB[BX]
          JL1  HERE
          ADD  BX,2
          CMP  BX,16
          JB   NEXT
          RET
HERE:     SHR  BX,1
          INC  BX
          MOV  FOUND,BX
          RET
          STOP
)";

/// The same, place by place.
std::string Unrolled() {
  std::string places;
  for (const char* const offset : {"0", "2", "4", "6", "8", "10", "12", "14"}) {
    places += std::string("          MOV  BX,") + offset + "\n          EQ   WORD.(LABEL_MEM.TAB+" + offset +
              ")\n          JL1  HERE\n";
  }
  const size_t begin = kSearch.find("          MOV  BX,0\n"), end = kSearch.find("          RET\n");
  return kSearch.substr(0, begin) + "          LOD  TOOL\n" + places + kSearch.substr(end);
}

TEST(Loops, ASearchThatEndsByItsCounterIsWhatItDoesPlaceByPlace) {
  // Each round may be the last one, so that how many there are is known by what all of them have in common.
  const Diff diff = CompareMechanisms(kSearch, Unrolled());
  EXPECT_EQ(NamesIn(diff), "");
  const Diff shorter = CompareUntilShown(Replaced(kSearch, "BX,16", "BX,14"), Unrolled(), "OUT4");
  EXPECT_EQ(VerdictOf(shorter, "OUT4"), ItemVerdict::kDifferent);
  const Diff longer = CompareUntilShown(Replaced(kSearch, "BX,16", "BX,18"), Unrolled(), "OUT4");
  EXPECT_EQ(VerdictOf(longer, "OUT4"), ItemVerdict::kDifferent);
}

/// Turns a magazine from pocket to pocket: each round waits for the sensor to go and to come.
const std::string kTurning = R"(          DATA
IN0:      DFM KEY,POCKET
OUT0:     DFM TURN
GOAL:     DS 2
STEPS:    DS 2
CMOS      STRUC
PLACE     DW ?
CMOS      ENDS
          DATA_END
          MODULE_MAIN
          LDR  KEY
          FL1  1,TURNING
          MECH_BEGIN TURNING
          LOD  IN4
          SU   LABEL_MEM.PLACE
          AND  CNST.7
          STO  STEPS
          EQ   CNST.0
          JL1  DONE
          FL   1,TURN
ROUND:    LDR  POCKET
          TEX1 -,150,LATE
          LDR  POCKET
          TEX0 -,150,LATE
          LOD  LABEL_MEM.PLACE
          AD   CNST.1
          AND  CNST.7
          STO  LABEL_MEM.PLACE
          LOD  STEPS
          SU   CNST.1
          STO  STEPS
          NE   CNST.0
          JL1  ROUND
LATE:     FL   0,TURN
DONE:     MECH_END TURNING
          MODULE_MAIN_END
          STOP
)";

TEST(Loops, ARoundThatWaitsForASensorToGoAndToComeIsNotTakenTwice) {
  // In one pass the sensor is one thing or the other: no backward jump is counted, and no fault of it can be raised.
  std::string renamed = kTurning;
  for (size_t at = 0; (at = renamed.find("STEPS", at)) != std::string::npos;) renamed.replace(at, 5, "REST");
  EXPECT_EQ(NamesIn(CompareMechanisms(kTurning, renamed)), "");
  const Diff rewritten = CompareMechanisms(kTurning, Replaced(kTurning, "LOD  IN4", "LOD  CNST.8\n          AD   IN4"));
  EXPECT_EQ(NamesIn(rewritten), "");
  const Diff other =
      CompareUntilShown(kTurning, Replaced(kTurning, "LOD  IN4", "LOD  CNST.7\n          AD   IN4"), "TURN");
  EXPECT_EQ(VerdictOf(other, "TURN"), ItemVerdict::kDifferent);
}

}  // namespace
}  // namespace plcxx::review::diff
