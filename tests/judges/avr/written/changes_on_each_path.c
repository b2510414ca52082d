// Counters changed in several arms, by continue, in the condition behind a comma, in nested switches and loops.
// shows: o int 40
// sets: X[0] 0, X[1] 0, X[2] 1
// sets: X[0] 3, X[1] 1, X[2] 0
// sets: X[0] 255, X[1] 2, X[2] 1
int o[40]; static int gi; static unsigned char gb;
static int calls; static int c(int v) { calls++; return v; }
void init() { plc1_time = 1; plc2_time = 1; }
void plc1()
{
  int k = 0, i, n = 0; unsigned u; unsigned char b; signed char s; long l; int a = X[1];
  for (i = 0; i < 12; ) { if (X[i % 3] & 1) { i += 2; n++; } else { i += 2; n += 3; } } o[k++] = n; o[k++] = i; for (i = 9; i >= 0; ) { switch (a) { case 0: i--; break; case 1: if (n > 20) { n -= 2; i--; break; } /* fall */ default: n++; --i; continue; } n += 2; } o[k++] = n; o[k++] = i; u = 100; while (u > 3) { if (u & 1) { n ^= u; u -= 3; continue; } if (a == 2) { u -= 3; } else { n++; u = u - 3; } } o[k++] = n; o[k++] = u; b = 0; do { if (b == X[0]) { b++; goto on; } n += b; b++; on: n++; } while (b < 9); o[k++] = n; o[k++] = b; i = 0; while (c(a), i < 4) { i++; if (i == 2) continue; n += 5; } o[k++] = n; o[k++] = calls; for (s = -4; n += s, s < 4 && n != 7; s++) if (a) n--; o[k++] = n; o[k++] = s; for (l = 0; l < 50000L; l += 10000L) { int j = 0; while (j < 5) { if (j == a) { j++; break; } n += j; ++j; } o[k] += j; } k++; o[k++] = n; for (gi = 0; gi < 6; ) { if (a) { gi++; if (X[2]) break; } else if (X[2]) { n += 2; gi++; } else gi++; n++; } o[k++] = n; o[k++] = gi; gb = 20; while (gb) { a == 1 ? gb-- : (n++, gb--); if (gb == X[0]) break; } o[k++] = n; o[k++] = gb; i = 5; while (i--, i >= 0) { if (i == a) n += 100; } o[k++] = i; o[k++] = n; i = 0; do { n += i; if (a && i > 6) break; } while (i += 2, i < 10); o[k++] = i; o[k++] = n; i = 0; while (i < 9) { do { i += 3; } while (0); for (u = 0; u < 2; u++) n += u; } o[k++] = n; i = 0; while (n = n * 3 % 1000, i++ < 3 && n != 500) n += i; o[k++] = n; o[k++] = i; calls = 0;
}
void plc2() { }
