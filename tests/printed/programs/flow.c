// Statements: branches, switches, jumps in every direction, returns, and what is short-circuited.
#include "plc.h"
int a, b, c, n;
unsigned u;
long l;
char s;
static int any() { return R_i[0]; }
static int other(int k) { if (k) { return 3; } return any(); }
// What a function gives, and where it ends.
static int both_ways(int k) { if (k > 3) { a++; return 1; } else { b++; return 2; } }
static int early(int k) { if (k > 3) return 1; if (k > 2) return 2; a++; if (k > 1) { b++; return 3; } return 4; }
static int sometimes(int k) { if (k) return 5; a++; }
static int bare(int k) { if (k) return; return 5; }
static int bare_first(int k) { if (k > 3) return 7; if (k) return; return 5; }
static void nothing(int k) { if (k) return; a++; if (b) { a--; return; } b++; }
static int other_way(int k) { if (k) { a++; } else { return 1; } }
static int one_way(int k) { if (k) return 1; else { a++; } }
static int from_last_loop(int k) { int j; for (j = 0; j < 3; j++) { if (R[j]) { return j; } else n++; } }
static int from_last_switch(int k) { switch (k) { case 1: if (a) return 3; else n++; break; default: n--; } }
static int in_both_loops(int k) { int j; for (j = 0; j < 3; j++) { if (R[j]) { n++; continue; } else { if (a) return j; n--; } } return 7; }
static long wide(char k) { return k; }
static unsigned char narrow(long k) { return k; }
static float real(int k) { if (k) return 1; return 2.5; }
static int from_loop() { int k; for (k = 0; k < 5; k++) { if (R[k]) return k; } return -1; }
static int from_switch(int k) { switch (k) { case 1: return 10; case 2: a++; break; case 3: a--; return 30; default: return 0; } return 20; }
static int nested(int k) { if (k) { if (a) { return 1; } else if (b) { n++; return 2; } n--; } else return 4; return 3; }
int entry_value(unused, k) int k; { return k; }
static int in_order(int p, int q, int k) { return p - q + k; }

static void branches() {
  if (a) n++;
  if (a) n++; else n--;
  if (a) { } else n--;
  if (a) n++; else { }
  if (a) { } 
  if (a) if (b) n++; else n--;
  if (a) { if (b) n++; } else n--;
  if (a) n = 1; else if (b) n = 2; else if (c) n = 3; else n = 4;
  if (a > 3) n = 1; else if (a > 2) { n = 2; } else { if (a > 1) n = 3; n++; }
  if (1) n++; else n--;
  if (0) n++; else n--;
  if (a && b) n++;
  if (a || b) n++;
  if (a && any()) n++;
  if (a || any()) n++;
  if (any() && a) n++;
  if (any() || a) n++;
  if (a && any() && b) n++;
  if (a && b && any()) n++;
  if (a || b || any() || c) n++;
  if (a && (b || any())) n++;
  if (!(a && any())) n++;
  if (a ? any() : b) n++;
  if (a ? b : c) n++;
  if (a = b) n++;
  if ((a = any()) > 3) n++;
  if (a++) n++;
  if (a, b) n++;
  n = a && any(); n = a || any(); n = (a && any()) + 1; n = a ? any() : 3; n = a ? 3 : any(); n = a ? any() : other(b); l = a ? any() : 3; s = a ? 1 : any();
  n = in_order(a++, a++, a); n = in_order(any(), b, other(2)); n = a + any() * other(any()); n = a ? b++ : c--; l = a ? l : b; n = (a, any());
  ;
  { { n++; } { } }
}
static void switches() {
  switch (a) { case 1: n++; break; case 2: n--; break; }
  switch (a) { case 1: n++; break; default: n--; }
  switch (a) { default: n++; break; case 3: n--; }
  switch (a) { case 1: case 2: case 3: n++; break; case 4: n--; }
  switch (a) { case 1: n++; /* falls through */ case 2: n--; break; default: n = 0; }
  switch (a) { case 1: n++; case 2: n--; }
  switch (a) { case 1: ; case 2: n--; }
  switch (a) { case 1: { } case 2: n--; }
  switch (a) { case 1: { n++; break; } case 2: { n--; } break; default: { } }
  switch (a) { case -1: n++; break; case -32768: n--; break; case 32767: n = 0; }
  switch (u) { case 65535u: n++; break; case 0: n--; }
  switch (l) { case 100000L: n++; break; case -1L: n--; break; case 5: n = 5; }
  switch (s) { case 'A': n++; break; case -1: n--; }
  switch (a & 3) { case 0: n++; break; case 1: n--; break; case 2: n = 2; break; case 3: n = 3; }
  switch (any()) { case 1: n++; }
  switch (a > b) { case 0: n++; break; case 1: n--; }
  switch (a) { n = 7; case 1: n++; }
  switch (a) { int k; case 1: k = 3; n = k; }
  switch (a) { default: n++; }
  switch (a) { }
  switch (a) case 1: n++;
  switch (a) { case 1: n++; break; /* at the end of the last group */ }
  switch (a) { case 1: if (b) break; n++; break; case 2: if (b) { n--; break; } else n = 2; }
  switch (a) { case 1: switch (b) { case 1: n++; break; default: n--; } break; case 2: n = 2; }
  switch (a) { case 1: if (b) { case 2: n++; } n--; break; case 3: n = 3; }
  switch (a) { case 1: if (b) { n = 1; default: n++; } n--; }
  switch (a) { case 1: { case 2: n++; } break; { case 3: n--; } }
  for (b = 0; b < 5; b++) switch (b) { case 1: continue; case 2: break; default: n++; }
  for (b = 0; b < 5; b++) { switch (b) { case 1: n++; continue; case 2: n--; break; case 3: if (a) continue; n = 3; } c++; }
  switch (a) { case 1: n = a; break; case 5: case 7: n = a; l = a; break; default: n = a; }
  switch (a) { case 1: return; case 2: n++; break; default: return; }
  n--;
}
static void jumps() {
  int k = 0, j;
  if (a) goto one; n++; one: n--;
  if (a) goto two; if (b) goto two; n++; two: ;
  if (a) { n++; goto three; } n--; three: n++;
  for (k = 0; k < 5; k++) { if (R[k]) goto found; } n = -1; found: n++;
  for (k = 0; k < 5; k++) for (j = 0; j < 5; j++) { if (R[k]) goto deep; if (R[j]) goto next; n++; next: ; } deep: n++;
  if (a) { if (b) goto inside; n++; inside: n--; }
  if (a) goto into; if (b) { n++; into: n--; }
  if (a) goto otherwise; if (b) n++; else { n = 2; otherwise: n--; }
  switch (a) { case 1: goto label; case 2: n++; label: n--; break; case 3: n = 3; }
  switch (a) { case 1: if (b) goto last; n++; break; case 2: n--; break; last: case 3: n = 3; }
  switch (a) { case 1: goto third; case 2: n++; break; case 3: third: n--; }
  goto over; n++; over: n--;
  goto live; { n++; live: n--; }
  if (a) goto end; n++;
  k = 0; back: n++; k++; if (k < 10) goto back;
  k = 0; back3: n++; if (++k < 10) goto back3;
  k = 10; back4: if (a) { n++; } k--; if (k > 0) { n--; goto back4; }
  k = 0; back5: k++; if (a) goto skip5; n++; skip5: if (k < 10) goto back5;
  k = 0; back6: n++; if (k < 10 && a) { k++; goto back6; }
  k = 0; back7: k++; if (k < 10) { if (a) goto back7; n++; }
  k = 0; back8: k++; if (k >= 10) n++; else goto back8;
  k = 0; back9: k++; switch (a) { case 1: n++; } if (!(k >= 10)) goto back9;
  for (j = 0; j < 3; j++) { k = 0; again: k++; n++; if (k < 10) goto again; }
  if (a) { k = 0; inner: k++; if (k < 3) goto inner; n++; }
  /*@loop_bound 20@*/ bounded: n++; if (any()) goto bounded;
  if (b) goto entered; k = 5; entered2: k--; n++; entered: n--; if (k > 0) goto entered2;
  /*@loop_bound 5@*/ outer: n++; /*@loop_bound 6@*/ nested_label: n--; if (any()) goto nested_label; if (any()) goto outer;
  /*@loop_bound 4@*/ while (any()) { n++; if (a) break; if (b) continue; n--; }
  /*@loop_bound 4@*/ do { n++; if (a) continue; n--; } while (any());
  /*@loop_bound 4@*/ for (k = 0; any(); k++) { n++; if (a) goto end; }
  /*@loop_bound 4@*/ for (;;) { n++; if (any()) break; }
  end: n = 0;
}
// What is known at a label, and what is not any more.
static void rounds() {
  int k;
  k = 0; /*@loop_bound 5@*/ first: n = k < 1; /*@loop_bound 6@*/ second: n++; if (a) goto first; k = 5; if (b) goto second;
  k = 0; goto below; /*@loop_bound 4@*/ above: n = k < 1; k = 3; below: n = k < 1; if (any()) goto above;
  k = 0; /*@loop_bound 3@*/ around: n = k < 1; for (c = 0; c < 3; c++) k = c; if (any()) goto around;
  k = 0; /*@loop_bound 3@*/ choice: n++; if (a) { k = 9; goto choice; } n = k < 9;
  k = 0; if (a) { /*@loop_bound 3@*/ within: n++; } n = k; if (any()) goto within;
  for (c = 0; c < 3; c++) { if (a) goto entry; n++; /*@loop_bound 3@*/ again2: n--; entry: if (any()) goto again2; }
}
static void dead() {
  int k;
  if (a) { return; n++; } 
  for (k = 0; k < 5; k++) { break; n++; }
  for (k = 0; k < 5; k++) { continue; n++; }
  for (k = 0; k < 5; k++) { n++; if (a) { continue; } else { break; } n--; }
  while (0) { n++; here: n--; }
  do { n++; if (a) break; n--; } while (0);
  switch (a) { case 1: break; n++; case 2: n--; return; n++; }
  goto past; { n++; } while (1) { n++; } past:
  if (a) goto distant; else goto distant; n++; distant:
  n++; return; n--;
}
static void scopes() {
  int k = 1; static int kept = 5; static char bytes[3] = "ab"; const int fixed = 4; register int fast = 3;
  { int k = 2; n = k; { static int kept = 6; n = kept++; } }
  { int k; n = a; k = n; }
  { int first = a, second = first + 1; n = second; }
  for (k = 0; k < 2; k++) { int each = k; n += each; { int inside; inside = each; n -= inside; } }
  n = k + kept + fixed + fast + bytes[1];
  { int unset; n = unset; if (a) unset = 3; n = unset; }
  { int maybe; if (a) maybe = 1; else maybe = 2; n = maybe; }
}
void init() { plc1_time = 1; plc2_time = 1; }
void plc1() {
  branches(); switches(); jumps(); rounds(); bare(a); n = bare_first(b) + other_way(a) + one_way(b) + from_last_loop(a) + from_last_switch(b) + in_both_loops(a); dead(); scopes(); both_ways(a); early(a); sometimes(a); nothing(a); wide(s); narrow(l); real(a); from_loop(); from_switch(a);
  nested(a); entry_value(a, b); n = both_ways(any()) + early(3) * sometimes(1); l = wide(narrow(l)); n = real(n);
}
void plc2() { if (a) return; n++; }
