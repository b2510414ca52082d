// What is refused of pointers, and that nothing follows from it.
#include "plc.h"
#include <string.h>
int o0, o1, o2, o3, o4, o5, o6, o7, o8, o9, o10, o11, o12, o13, o14, o15, o16, o17, n, a, table[4];
int *many, *never, *nobody; struct point { int x, y; } dot, *dots;
static int *local() { int k = 1; return &k; }
static int *parameter(int k) { return &k; }
void take_m(int ch) { n = ch; }
static void take(int *p) { n = *p; }
void init() { plc1_time = 1; plc2_time = 1; }
void plc1()
{
  int k;
  switch (a) { case 0: many = &o0; break; case 1: many = &o1; break; case 2: many = &o2; break; case 3: many = &o3; break; case 4: many = &o4; break; case 5: many = &o5; break; case 6: many = &o6; break; case 7: many = &o7; break; case 8: many = &o8; break; case 9: many = &o9; break; case 10: many = &o10; break; case 11: many = &o11; break; case 12: many = &o12; break; case 13: many = &o13; break; case 14: many = &o14; break; case 15: many = &o15; break; case 16: many = &o16; break; case 17: many = &o17; break; }
  n = *many;
  *many = 1;
  memset(many, 0, 2);
  memcpy(table, many, 2);
  n = *never;
  never[1] = 2;
  memset(nobody, 0, 2);
  n = *local();
  n = *parameter(1);
  nobody = &k;
  n = table[4];
  table[-1] = 1;
  n = X[128];
  n = P[100];
  take(0);
  n = dots->x;
  n = &table[1] < &o1;
  n = &table[1] - &o1;
  n = 5 / 0;
  n = 5 % 0;
  n = a << 16;
  n = a >> -1;
  if (X[0]) set_mst_func(0, 'M', take_m);
  set_axis_home(16, 1);
  set_axis_stop(-1);
  n = get_handwheel(4);
  handwheel(0, 16, 1);
  handwheel(4, 0, 1);
  if (table) n++;
  if (&o1) n++;
}
void plc2() { }
