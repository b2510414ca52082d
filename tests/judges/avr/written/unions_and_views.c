// The same bytes as char, int and long: through a union, through pointers, and in the views of the register areas.
// shows: out unsigned 16, l long 8
// sets: R[0] 1, R[1] 128, R[2] 255, R[3] 127, R[4] 200
// sets: R[0] 255, R[1] 255, R[2] 0, R[3] 128, R[4] 77
union mixed { unsigned char b[4]; int i[2]; unsigned long u; long l; struct { char lo, hi; unsigned w; } s; };
union mixed m, n[2];
unsigned out[16];
long l[8];
unsigned word_at(unsigned char *p) { return p[0] | p[1] << 8; }
long long_at(int *p) { return *p + ((long) p[1] << 16); }
void init() { plc1_time = 1; plc2_time = 1; }
void plc1()
{
  int i;
  for (i = 0; i < 4; i++) m.b[i] = R[i];
  out[0] = m.i[0]; out[1] = m.i[1]; l[0] = m.l; l[1] = m.u >> 8; out[2] = m.s.lo; out[3] = m.s.hi; out[4] = m.s.w;
  m.s.w++; l[2] = m.l; m.i[0] = -m.i[0]; l[3] = m.l; m.l /= 3; out[5] = m.b[3];
  n[0] = m; n[1] = n[0]; n[1].b[2] ^= 0x55; out[6] = n[1].s.w - n[0].s.w;
  out[7] = word_at(R); out[8] = word_at(&R[1]); out[9] = word_at(R + 3); l[4] = long_at(R_i);
  l[5] = *(long *) &R[1]; out[10] = *(unsigned *) (R + 1); *(int *) &R[21] = -2; *(long *) &R[25] = 0x12345678;
  R_c[30] = R_i[0]; R_i[16] = R_c[1]; R_ul[9] = R_l[0] >> 3; R_ui[20] = R_ul[0] >> 3; l[6] = R_c[2] + R_uc[2]; l[7] = R_ui[0] + R_i[0];
  R[44] += 200; R_ui[22] += 65000; R_l[12] -= 70000; R_c[52]--; R[53]--;
}
void plc2() { }
