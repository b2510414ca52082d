// Functions of the control: numbers of axes and wheels that are known, bounded and neither; handlers.
#include "plc.h"
#include <dos.h>
int n, a, done;
long l;
static int any() { return R_i[0]; }
void on_m(int ch) { mod_M_code(ch) = -1; n = ch; }
void on_s(int ch) { if (R[ch]) mod_S_code(ch) = -1; }
void on_t(int ch) { mod_T_code(ch) = -1; }
void other_m(int ch) { mod_M_code(ch) = a; }
static void axes() {
  set_axis_home(0, 1); set_axis_home(15, 0); set_axis_home(a, a); set_axis_home(a & 15, any()); set_axis_home(a & 31, 1); set_axis_home(any(), any());
  set_axis_jog(3, 100); set_axis_jog(a & 7, -100); set_axis_jog(a, n); set_axis_step(3, 100000L); set_axis_step(a, l); set_axis_step(a & 15, n);
  set_axis_move(1, 5L, 10); set_axis_move(a, l, n); set_axis_moveto(2, 70000L, 7); set_axis_moveto(a & 15, n, n); set_axis_stop(4); set_axis_stop(a); set_axis_stop(X[3] & 15); set_axis_stop(X[3]);
  l = get_axis_pos(5); l = get_axis_pos(a); n = get_axis_pos(a & 15); n = get_axis_den(6); done = get_axis_den(a) && get_axis_den(1); if (get_axis_den(a & 3)) n++; n = get_axis_den(2) == 1;
}
static void wheels() {
  handwheel(0, 1, 10); handwheel(3, 15, 1); handwheel(a, n, 1); handwheel(a & 3, n & 15, any()); handwheel(a & 3, n, 1); handwheel(a, 2, 1);
  n = get_handwheel(0); n = get_handwheel(3); n = get_handwheel(a); n = get_handwheel(a & 3); n += get_handwheel(X[1] & 1); n = get_handwheel(any() & 7);
}
static void sections() { disable(); a++; enable(); if (n) { disable(); n--; enable(); } }
void init() {
  plc1_time = 4; plc2_time = 20;
  set_mst_func(0, 'M', on_m); set_mst_func(1, 'M', &other_m); set_mst_func(0, 'S', on_s); set_mst_func(3, 'T', on_t); set_mst_func(2, 'M', on_m); set_mst_func(2, 'M', 0);
}
void plc1() { axes(); wheels(); sections(); on_m(1); }
void plc2() { n = get_handwheel(1); }
