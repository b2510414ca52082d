// Comparison of words without sign and as two's complement: NC110 6.5, PROSTEP 6.3 and FM 80 to 88, HOST50 6.5,
// TECHNOL 6.5, HNC 6.2.
#include "transpiler/symbolic/meaning/rows.h"

namespace plcxx::meaning {

Bit Equal8(I8 a, I8 b) { return a == b; }
Bit Equal16(I16 a, I16 b) { return a == b; }
Bit Equal32(I32 a, I32 b) { return a == b; }
Bit Equal64(I64 a, I64 b) { return a == b; }
Bit IsZero64(I64 a) { return a == 0; }
Bit NotEqual8(I8 a, I8 b) { return a != b; }
Bit NotEqual16(I16 a, I16 b) { return a != b; }
Bit NotEqual32(I32 a, I32 b) { return a != b; }

Bit Less8(I8 a, I8 b) { return Less(a, b); }
Bit Less16(I16 a, I16 b) { return Less(a, b); }
Bit Less32(I32 a, I32 b) { return Less(a, b); }
Bit LessEqual16(I16 a, I16 b) { return AtMost(a, b); }
Bit LessEqual32(I32 a, I32 b) { return AtMost(a, b); }
Bit Greater8(I8 a, I8 b) { return Less(b, a); }
Bit Greater16(I16 a, I16 b) { return Less(b, a); }
Bit Greater32(I32 a, I32 b) { return Less(b, a); }
Bit GreaterEqual16(I16 a, I16 b) { return AtMost(b, a); }
Bit GreaterEqual32(I32 a, I32 b) { return AtMost(b, a); }

Bit SignedLess8(I8 a, I8 b) { return SignedLess(a, b); }
Bit SignedLess16(I16 a, I16 b) { return SignedLess(a, b); }
Bit SignedLess32(I32 a, I32 b) { return SignedLess(a, b); }
Bit SignedLessEqual8(I8 a, I8 b) { return SignedAtMost(a, b); }
Bit SignedLessEqual16(I16 a, I16 b) { return SignedAtMost(a, b); }
Bit SignedLessEqual32(I32 a, I32 b) { return SignedAtMost(a, b); }
Bit SignedGreater8(I8 a, I8 b) { return SignedLess(b, a); }
Bit SignedGreater16(I16 a, I16 b) { return SignedLess(b, a); }
Bit SignedGreater32(I32 a, I32 b) { return SignedLess(b, a); }
Bit SignedGreaterEqual8(I8 a, I8 b) { return SignedAtMost(b, a); }
Bit SignedGreaterEqual16(I16 a, I16 b) { return SignedAtMost(b, a); }
Bit SignedGreaterEqual32(I32 a, I32 b) { return SignedAtMost(b, a); }

}  // namespace plcxx::meaning
