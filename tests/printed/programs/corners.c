// What the other programs have nowhere: real constants as conditions, values known only when they are lowered, pointers as
// the result of several expressions, labels in front of labels, and loops whose end is never come to.
#include "plc.h"
#include <stdlib.h>
#include <string.h>
int a, b, c, n;
unsigned u;
unsigned char d;
long l;
float f;
int table[8], *p, *q;
static int any() { return R_i[0]; }

static void real_conditions() {
  if (1.0) n++; else n--;
  if (0.5) n++; else n--;
  if (0.0) n++; else n--;
  n = 1.0 && a; n = 0.5 || a; n = !1.0; n = !0.5; n = 1.0 ? a : b; n = 0.0 ? a : b; n = 1.0f && 0.25;
  if (f) n++;
  if (!f) n++;
}
static void known_late() {
  int k = 5;
  if ((a++, 5)) n++;
  if ((a++, 0)) n++;
  n = !(a++, 7); n = !(a++, 0); n = (a++, 3) && b; n = (a++, 0) || b; n = (a++, 1) ? a : b;
  if (k) n++; else n--;
  n = k && a; n = !k; k = 0; n = !k; n = k || a;
}
// What && and || give is 0 or 1, and so is what ! gives.
static void truths_as_limits() {
  int k;
  for (k = 0; k < !a; k++) n++;
  for (k = 0; k < (a && b); k++) n++;
  for (k = 0; k < (a || b); k++) n++;
  for (k = 0; k <= (a || b); k++) n++;
  for (k = 3; k > !b; k--) n++;
  for (k = 0; k < -(a && b) + 4; k++) n++;
  for (k = 0; k < (a ? 3 : 5); k++) n++;
  for (k = 0; k < (a > 3 ? a & 7 : 2); k++) n++;
  for (d = 0; d < (a || b) + 2; d++) n++;
  if ((a && b) < 2) n++;
  if ((a || b) > 1) n++;
  if (!a < 2) n++;
}
static void pointers() {
  int *r = table, *s = &table[3];
  r = (n++, s); n = *(n++, r); n = *(any(), r + 1); n = (any(), s)[2];
  r = a ? (n++, s) : table; *(n++, r) = 4; *(n++, r) += 4; (*(n++, r))++;
  p = q = table; p = (q = &table[2]) + 1; n = *(p = table); n = *(p += 2); n = *(q -= 1);
  if ((n++, p)) n++; if (p && *p) n++; n = (n++, p) == q; n = (n++, p) != 0;
  r = (int *)(void *)s; n = *r; r = 0; if (r) n++; if (r == 0) n--;
  r++; --s; n = s - table; n = s > table; n = &table[a & 7] - s;
}
static void initialisers() {
  const char *names[2] = {"ab", "c"};
  const char *none[3] = {"x"};
  char grid[2][3] = {"ab", {1, 2}};
  char rows[2][2][2] = {{"a"}, {{1}, "b"}};
  struct { int x; char text[4]; unsigned low : 3; unsigned high : 5; } record = {any(), "abc", 5, 17};
  int given[4] = {any(), 2, any()};
  n = names[a & 1][0] + none[0][0] + grid[a & 1][1] + rows[1][1][0];
  n = record.x + record.text[2] + record.low + record.high + given[b & 3];
}
static void memory() {
  char t[6]; int w[3];
  memset(t, 0, sizeof t); memset(t + 4, a, 2); memset(&t[6], 1, 0); memcpy(t, w, 6); memcpy(&w[1], t + 2, 4);
  memset(t, 1, a & 7); memcpy(t + (a & 3), w, b & 3); n = t[a & 3] + w[1];
}
static void labels() {
  int k;
  k = 0; one: two: n++; k++; if (k < 10) goto two;
  k = 0; three: four: n++; if (++k < 10) goto three;
  switch (a) { case 1: k = 0; five: n++; if (++k < 5) goto five; break; case 2: case 3: six: n--; }
  switch (a) { case 1: seven: k = n; case 2: eight: n--; break; default: n = 0; }
  k = 0; nine: { n++; { k++; if (k < 4) goto nine; } }
  k = 0; ten: if (k >= 10) goto end; n++; if (k < 7) { k++; goto ten; } end: n--;
  k = 0; again: if (++k < 10) { if (a) goto again; n++; }
  if (a) goto six2; else if (b) goto six2; n++; six2: ;
}
static void ends() {
  int k;
  /*@loop_bound 2@*/ do { n++; break; } while (a);
  /*@loop_bound 2@*/ do { n++; if (a) break; else break; n--; } while (a);
  if (c) { /*@loop_bound 2@*/ do { n++; return; } while (b); }
  while (a) { n++; break; }
  for (k = 0; k < a; k += b) { n++; if (c) break; else return; }
  /*@loop_bound 2@*/ do { n++; switch (a) { case 1: return; default: return; } } while (b);
}
static int result_in_do() { /*@loop_bound 2@*/ do { n++; return 3; } while (a); }
static int result_in_switch_of_switch() {
  switch (a) { case 1: switch (b) { case 1: return 1; default: return 2; } case 2: return 3; default: return 4; }
}
static void nested_switches() {
  switch (a) { case 1: if (b) { switch (c) { case 7: n++; break; default: n--; } case 2: n--; } n = 4; }
  switch (a) { case 1: { switch (b) { case 1: n++; case 2: break; } case 3: n--; break; } case 4: n = 4; }
  switch (a) { case 1: switch (b) { case 1: switch (c) { case 1: n++; break; } break; } break; case 2: n = 2; }
}
static void steps() {
  int k;
  for (k = 0; k < 9; k = 1 + k) n++;
  for (k = 0; k < 9; k = k + 2) n++;
  for (k = 9; k > 0; k = k - 2) n++;
  for (k = 9; k > 0; k = -2 + k) n++;
  /*@loop_bound 4@*/ for (k = 0; any(); k = abs(k)) n++;
  /*@loop_bound 4@*/ for (k = 0; any(); k = k * k) n++;
  /*@loop_bound 4@*/ for (k = 0; any(); k = any()) n++;
  /*@loop_bound 4@*/ for (k = 0; any(); k += k) n++;
}
static void comments() {
  n++;
  /* at the end of a function */
}
static void comments_in_blocks() {
  if (a) {
    n++;
    /* at the end of a block */
  } else {
    /* alone in a block */
  }
  switch (a) {
    case 1:
      n++;
      break;
      /* at the end of the last group, behind its break */
  }
  switch (a) {
    case 2:
      n++;
    default:
      n--;
      /* at the end of the last group */
  }
  switch (a)
    case 3:
      n++;
      /* behind a switch without braces */
  switch (a)
    case 4: {
      n--;
      /* at the end of a block of a switch */
    }
  /* in front of a loop */ for (n = 0; n < 3; n++) { break; /* behind a jump */ }
}
void init() { plc1_time = 1; plc2_time = 1; a = any(); b = any(); c = any(); f = a; l = u = a; }
void plc1() {
  real_conditions(); known_late(); truths_as_limits(); pointers(); initialisers(); memory(); labels(); ends(); n = result_in_do();
  n = result_in_switch_of_switch(); nested_switches(); steps(); comments(); comments_in_blocks();
}
void plc2() { }
