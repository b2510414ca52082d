// Which loops are proved to end, after how many iterations, a loop in a line.
#include "plc.h"
int i, j, n, a, limit, table[8];
unsigned u;
unsigned char c;
char s;
long l;
unsigned long w;
float f;
const int seven = 7;
const int few[3] = {2, 4, 6};
union { int i; unsigned char b[2]; } both;
struct { int count; int field : 4; unsigned small : 3; } record;
int *pointer = &a;
static int any() { return R[0]; }
static void changes() { i = R[1]; }
static void changes_table() { table[1] = R[2]; }

// Counters of every type, each relation, from either side.
static void relations() {
  int k;
  for (k = 0; k < 10; k++) a++;
  for (k = 0; k <= 10; k++) a++;
  for (k = 0; k != 10; k++) a++;
  for (k = 10; k > 0; k--) a++;
  for (k = 10; k >= 0; k--) a++;
  for (k = 0; 10 > k; k++) a++;
  for (k = 0; 10 >= k; k++) a++;
  for (k = 10; 0 < k; k--) a++;
  for (k = 10; 0 <= k; k--) a++;
  for (k = 0; 10 != k; k++) a++;
  for (k = 0; k == 0; k++) a++;
  for (k = 0; k > 10; k++) a++;
  for (k = 5; k < 5; k++) a++;
  for (k = 5; k <= 5; k++) a++;
  for (k = 0; !(k >= 10); k++) a++;
  for (k = 0; !!(k < 10); k++) a++;
  for (k = 0; k < 32767; k++) a++;
  for (k = 0; k > -32768; k--) a++;
}
static void steps() {
  int k, m = 3;
  for (k = 0; k < 10; ++k) a++;
  for (k = 10; k > 0; --k) a++;
  for (k = 0; k < 10; k += 3) a++;
  for (k = 10; k > 0; k -= 3) a++;
  for (k = 0; k < 10; k = k + 3) a++;
  for (k = 0; k < 10; k = 3 + k) a++;
  for (k = 10; k > 0; k = k - 3) a++;
  for (k = 0; k != 9; k += 3) a++;
  for (k = 32000; k < 32764; k += 3) a++;
  for (k = 0; k < 10; k -= -2) a++;
  for (k = 0; k < 10; k = (k + 2)) a++;
  for (k = 0; k < 10; k = (long)k + 2) a++;
  for (k = 0; k < 10; k = 2 + (long)k) a++;
  for (k = 0; k < 10; k++, a++) a--;
  for (k = 0; k < 10; a++, k++) a--;
  for (k = 0; k < 10; a = k++) a--;
  for (k = 0; k < 10; table[k++] = 1) a--;
}
static void types() {
  unsigned char b; char t; unsigned v; long q; unsigned long x;
  for (b = 0; b < 10; b++) a++;
  for (b = 0; b < 255; b++) a++;
  for (b = 10; b > 0; b--) a++;
  for (b = 10; b != 0; b -= 2) a++;
  for (b = 0; b < 10; b = b + 1) a++;
  for (b = 0; b < 10; b += 7) a++;
  for (t = 0; t < 100; t++) a++;
  for (t = 0; t < 127; t++) a++;
  for (t = -128; t < 0; t += 64) a++;
  for (t = 0; t < 10; t = t + 2) a++;
  for (v = 0; v < 10; v++) a++;
  for (v = 0; v < 65535u; v++) a++;
  for (v = 10; v > 0; v--) a++;
  for (v = 10; v >= 1; v -= 2) a++;
  for (v = 1; v != 0; v++) a++;
  for (v = 40000u; v < 50000u; v += 20000u) a++;
  for (q = 0; q < 10; q++) a++;
  for (q = 0; q < 100000L; q += 1000) a++;
  for (q = 100000L; q > 0; q -= 1000) a++;
  for (q = 0; q < 10; q = q + 1) a++;
  for (q = 0; q < 10; q = q + 1L) a++;
  for (x = 0; x < 10; x++) a++;
  for (x = 10; x > 0; x--) a++;
  for (b = 0; (int)b < 10; b++) a++;
  for (v = 0; (long)v < 10; v++) a++;
  for (t = 0; (unsigned)t < 10; t++) a++;
  for (t = -5; (unsigned)t > 10; t++) a++;
}
// The condition changes the counter.
static void in_condition() {
  int k; unsigned v;
  k = 5; while (k--) a++;
  k = 5; while (--k) a++;
  k = -5; while (k++) a++;
  k = -5; while (++k) a++;
  k = 5; while (k-- > 0) a++;
  k = 5; while (--k > 0) a++;
  k = 0; while (k++ < 5) a++;
  k = 0; while (++k < 5) a++;
  k = 5; while (0 < k--) a++;
  k = 5; while (k-- >= 0) a++;
  k = 5; while (k-- && a) a++;
  k = 5; while (a && k--) a++;
  k = 5; do a++; while (k--);
  k = 5; do a++; while (--k);
  k = 0; do a++; while (k++ < 5);
  k = 0; do a++; while (++k < 5);
  v = 5; while (v--) a++;
  v = 5; while (--v) a++;
  v = 0; while (v++ < 5) a++;
  v = any(); while (v--) a++;
  k = any(); while (k--) a++;
  k = any(); while (--k) a++;
  k = any() & 15; while (k--) a++;
  k = any() & 15; while (--k > 0) a++;
  k = any() & 15; while (--k) a++;
  k = 3; do { a++; } while (!k--);
}
// What a body or a condition does to the proof.
static void bodies() {
  int k, m;
  k = 0; while (k < 10) k++;
  k = 0; while (k < 10) { a++; k += 2; }
  k = 0; while (k < 10) { { a++; { k++; } } }
  k = 0; while (k < 10) { if (k++) a++; }
  k = 0; while (k < 10) { switch (k++) { case 1: a++; } }
  k = 0; while (k < 10) { for (m = 0; m < 3; m++) a++; k++; }
  k = 0; while (k < 10) { here: k++; }
  k = 0; while (k < 10) { k++; if (a) continue; a++; }
  for (k = 0; k < 10; k++) { if (a) continue; a++; }
  k = 0; while (k < 10) { for (m = 0; m < 3; m++) { if (a) continue; a++; } k++; }
  k = 0; while (k < 10) { do { if (a) continue; a++; } while (0); k++; }
  k = 0; while (k < 10) { if (a) break; k++; }
  k = 0; while (k < 10) { if (a) goto beyond; a++; beyond: k++; }
  k = 0; while (k < 10) { k++; back: a++; if (a < 3) goto back; }
  k = 0; m = 0; fewer: k++; m += 2; if (k < 10) if (m < 12) goto fewer;
  k = 0; m = 0; more: k++; m += 2; if (k < 4) if (m < 40) goto more;
  k = 0; m = 0; same: k++; m++; if (k < 4) if (m < 4) goto same;
  k = 0; while (k < 10) { if (a) goto out; k++; }
  out:
  k = 0; while (k < 10 && a) k++;
  k = 0; while (a && k < 10) k++;
  k = 0; m = 0; while (k < 10 && m < 5) { k++; m++; }
  k = 0; m = 0; while (k < 5 && m < 10) { k++; m++; }
  k = 0; while (k < 10 && table[k]) k++;
  k = 0; while (k < 10) { int inner = 3; k++; a += inner; }
  k = 0; while (k < 10) { static int kept = 3; k++; a += kept; }
  do a++; while (0);
  do { a++; if (a > 3) continue; a++; } while (0);
  for (;;) { a++; break; }
  for (;;) { if (a) break; else break; }
  for (;;) { if (a) break; if (i) return; break; }
  while (0) a++;
  for (k = 0; 0; k++) a++;
  k = 0; do { k++; } while (k < 10);
  k = 0; do { a++; } while (k++ < 10);
  k = 20; do { k++; } while (k < 10);
  k = any(); do { k++; } while (k < 10);
}
// Counters and limits in memory.
static void memory() {
  int k;
  for (i = 0; i < 10; i++) a++;
  for (i = 0; i < 10; i++) changes_table();
  for (i = 0; i < 10; i++) table[any() & 7] = 1;
  for (R[5] = 0; R[5] < 10; R[5]++) a++;
  for (R[5] = 0; R[5] < 10; R[5]++) R[6] = 1;
  for (R_i[3] = 0; R_i[3] < 10; R_i[3]++) R[8] = 1;
  for (both.i = 0; both.i < 10; both.i++) a++;
  for (both.b[0] = 0; both.b[0] < 10; both.b[0]++) both.b[1] = 1;
  for (record.count = 0; record.count < 10; record.count++) a++;
  for (table[2] = 0; table[2] < 10; table[2]++) a++;
  for (table[2] = 0; table[2] < 10; table[2]++) table[3] = 1;
  for (k = 0; k < limit; k++) a++;
  for (k = 0; k < limit; k++) changes();
  for (k = 0; k < (limit & 15); k++) a++;
  for (k = 0; k < (limit & 15) + 2; k++) a++;
  for (k = 0; k < table[1]; k++) a++;
  for (k = 0; k < table[1]; k++) table[2] = 1;
  for (k = 0; k < (table[limit & 7] & 7); k++) a++;
  for (k = 0; k < seven; k++) a++;
  for (k = 0; k < few[1]; k++) a++;
  for (k = 0; k < R[3]; k++) a++;
  for (k = 0; k <= R[3]; k++) a++;
  for (k = 0; k < X[3]; k++) Y[3] = 1;
  for (u = 0; u < R[3]; u++) a++;
  for (c = 0; c < R[3]; c++) a++;
  for (s = 0; s < R_c[3]; s++) a++;
  for (k = 0; k < (a ? 3 : 5); k++) u++;
  for (k = 0; k < -limit; k++) a++;
  limit = 5; for (k = 0; k < limit; k++) a++;
  if (limit > 0 && limit < 20) for (k = 0; k < limit; k++) a++;
  if (limit < 20) { for (k = 0; k <= limit; k++) a++; }
  if (limit <= 20) for (k = 0; k < limit; k++) for (n = 0; n < limit; n++) a++;
}
// The value of the counter in the body, and after the loop.
static void values() {
  int k;
  for (k = 0; k < 8; k++) table[k] = k;
  for (k = 0; k <= 8; k++) table[k] = k;
  for (k = 7; k >= 0; k--) table[k] = k;
  for (k = 0; k < 8; k += 3) table[k] = k;
  for (k = 0; k < 8; k++) { }
  table[k - 1] = 1;
  table[k] = 1;
  for (k = 0; k < 8; k++) { if (a) break; }
  table[k] = 1;
  for (k = 0; k < 8; k++) { if (a) break; }
  if (k < 8) table[k] = 1;
  k = 0; while (k < 8) { table[k] = 1; k++; }
  k = 0; while (k < 8) { k++; table[k] = 1; }
  k = 0; while (k < 7) { k++; table[k] = 1; }
  k = 0; do { table[k] = 1; k++; } while (k < 8);
  k = 8; while (k--) table[k] = 1;
  k = 8; while (k-- > 0) table[k] = 1;
  k = 8; while (--k >= 0) table[k] = 1;
  k = -1; while (++k < 8) table[k] = 1;
  for (i = 0; i < 8; i++) table[i] = 1;
  table[i] = 1;
  for (k = 0; k < limit; k++) table[k] = 1;
  for (k = 0; k < 8 && k < limit; k++) table[k] = 1;
  for (k = 0; k < limit && k < 8; k++) table[k] = 1;
  for (c = 0; c < 8; c++) table[c] = 1;
  for (u = 8; u > 0; u--) table[u - 1] = 1;
  for (k = 0; k < 4; k++) for (n = 0; n < 2; n++) table[k + k + n] = 1;
  for (k = 0; k < 4; k++) for (n = 0; n < 2; n++) table[k * 2 + 1] = 1;
}
// Where the limit is in memory, and may be forced.
static void believed() {
  int k;
  limit = 5; for (k = 0; k < limit; k++) { n = k < 5; table[k] = 1; } n = k <= 5; n = k < 5; n = k >= 5;
  if (limit > 0 && limit < 8) { for (k = 0; k < limit; k++) { table[k] = 1; n = k < 7; } n = k < 8; n = k < 7; }
  if (limit > 0 && limit < 8) { for (k = limit; k > 0; k--) table[k - 1] = 1; n = k >= 0; }
  limit = 3; k = 0; do { table[k] = 1; k++; n = k < 4; } while (k < limit); n = k <= 3;
  for (k = 0; k < seven; k++) table[k] = 1; n = k <= 7;
  limit = 6; for (i = 0; i < limit; i++) table[i] = 1; n = i < 7;
  for (k = 0; k < 8; k++) { if (table[k]) break; n = k; } n = k < 9; if (k < 8) table[k] = 2;
  for (k = 3; k < 8; k += 2) { n = k > 2; table[k] = 1; } n = k > 7; n = k < 10;
  for (k = 7; k >= 0; k -= 3) { n = k < 8; table[k] = 1; } n = k < 0; n = k > -4;
}
// Counted by an annotation, and too many.
static void bounded() {
  int k;
  for (k = 0; k < 100; k++) for (j = 0; j < 100; j++) a++;
  for (k = 0; k < 1000; k++) for (j = 0; j < 1000; j++) a++;
}
void init() { plc1_time = 1; plc2_time = 1; }
void plc1() { relations(); steps(); types(); in_condition(); bodies(); memory(); values(); believed(); bounded(); }
void plc2() { }
