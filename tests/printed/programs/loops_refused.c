// Loops that are not proved to end, and why: a loop in a line.
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
  for (k = 0; !(!(k < 10) || 0); k++) a++;
  for (k = 0; k <= 32767; k++) a++;
  for (k = 0; k >= -32768; k--) a++;
}
static void steps() {
  int k, m = 3;
  for (k = 10; k > 0; k = 3 - k) a++;
  for (k = 0; k < 10; k = m + 3) a++;
  for (k = 0; k < 10; k = k + m) a++;
  for (k = 0; k < 10; k += m) a++;
  for (k = 1; k < 10; k *= 2) a++;
  for (k = 0; k < 10; k += 0) a++;
  for (k = 0; k < 10; k = k) a++;
  for (k = 0; k < 10; k += 1.5) a++;
  for (k = 0; k != 10; k += 3) a++;
  for (k = 32000; k < 32766; k += 3) a++;
  for (k = 0; k < 10; k--) a++;
  for (k = 0; k < 10; k = (char)k + 2) a++;
  for (k = 0; k < 10; a ? k++ : 0) a--;
  for (k = 0; k < 10; a && k++) a--;
  for (k = 0; k < 10; a || k++) a--;
}
static void types() {
  unsigned char b; char t; unsigned v; long q; unsigned long x;
  for (b = 0; b < 256; b++) a++;
  for (b = 0; b <= 255; b++) a++;
  for (b = 10; b >= 0; b--) a++;
  for (b = 10; b != 1; b -= 2) a++;
  for (t = 0; t < 128; t++) a++;
  for (v = 0; v <= 65535u; v++) a++;
  for (x = 10; x >= 0; x--) a++;
  for (v = 0; (char)v < 10; v++) a++;
  for (b = 0; (float)b < 10; b++) a++;
  for (f = 0; f < 10; f++) a++;
}
// The condition changes the counter.
static void in_condition() {
  int k; unsigned v;
  k = 5; while (k-- > 0) k--;
}
// What a body or a condition does to the proof.
static void bodies() {
  int k, m;
  k = 0; while (k < 10) { if (a) k++; }
  k = 0; while (k < 10) { if (a && k++) a++; }
  k = 0; while (k < 10) { switch (a) { case 1: k++; } }
  k = 0; while (k < 10) { for (k++; a < 0; ) break; }
  k = 0; while (k < 10) { for (m = 0; m < 3; m++) k++; }
  k = 0; while (k < 10) { for (m = 0; m < 3; k++) m++; }
  k = 0; while (k < 10) { k++; k++; }
  k = 0; while (k < 10) { k++; if (a) k = 0; }
  k = 0; while (k < 10) { if (a) continue; k++; }
  k = 0; while (k < 10) { if (a) goto over; k++; over: a++; }
  k = 0; while (k < 10) { again: k++; if (a) goto again; }
  k = 0; while (k < 10 || a) k++;
  do { a++; if (a > 3) break; } while (1);
  for (;;) { a++; if (a > 3) break; }
  while (1) { a++; if (a) return; }
  while (a) { }
  k = 0; do { if (a) continue; k++; } while (k < 10);
}
// Counters and limits in memory.
static void memory() {
  int k;
  for (i = 0; i < 10; i++) changes();
  for (i = 0; i < 10; i++) *pointer = 1;
  for (R[5] = 0; R[5] < 10; R[5]++) R[any()] = 1;
}
static void more() {
  int k;
  for (R_i[3] = 0; R_i[3] < 10; R_i[3]++) R[6] = 1;
  for (both.i = 0; both.i < 10; both.i++) both.b[0] = 1;
  for (record.field = 0; record.field < 5; record.field++) a++;
  for (record.small = 0; record.small < 5; record.small++) a++;
  for (k = 0; k < limit; k++) limit = 5;
  for (k = 0; k < limit + 1; k++) limit--;
  for (k = 0; k < any(); k++) a++;
  for (k = 0; k < table[1]; k++) table[1] = 1;
  for (k = 0; k < table[any() & 7]; k++) table[1] = 1;
  for (k = 0; k < table[any() & 7]; k++) a++;
  for (k = 0; k < (table[limit & 7] & 7); k++) table[3] = 2;
  for (k = 0; k < (table[limit & 7] & 7); k++) changes_table();
  for (k = 0; k < few[any() & 1]; k++) a++;
  for (k = 0; k < Y[3]; k++) Y[3] = 1;
  for (c = 0; c <= R[3]; c++) a++;
  for (l = 0; l < R_ul[3]; l++) a++;
  for (w = 0; w < R_ul[3]; w++) a++;
  for (k = 0; k < (k & 3) + 5; k++) a++;
  for (k = 0; k < 5000; k++) for (j = 0; j < 5000; j++) a++;
  for (k = 0; k < 100; k++) for (j = 0; j < 100; j++) for (n = 0; n < 2000; n++) a++;
}
static void jumps() {
  int k = 0;
  k = 0; back2: if (k >= 10) goto out2; n++; k++; goto back2; out2:
  k = 0; back3: n++; goto back3;
  k = 0; back4: if (a) k++; if (k < 10) goto back4;
  k = 0; back5: k++; k++; if (k < 10) goto back5;
  k = 0; back6: if (a) goto over6; k++; over6: if (k < 10) goto back6;
  k = 0; back7: k++; if (k < 10 || a) goto back7;
  k = 0; back8: k++; if (a) goto back8; if (k < 10) goto back8;
  k = 0; back9: k++; while (a < 3) { a++; if (k < 10) goto back9; }
  k = 0; back10: k++; switch (a) { case 1: if (k < 10) goto back10; }
  k = 0; if (a) goto beside; back11: k++; beside: if (k < 10) goto back11;
  for (; a > b; ) n++;
  for (pointer = table; pointer < table + 4; pointer++) n += *pointer;
}
// The value of the counter in the body, and after the loop.
static void values() {
  int k;
}
// Counted by an annotation, and too many.
static void bounded() {
  int k;
}
void init() { plc1_time = 1; plc2_time = 1; }
void plc1() { relations(); steps(); types(); in_condition(); bodies(); memory(); values(); bounded(); more(); jumps(); }
void plc2() { }
