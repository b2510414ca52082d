// The words of the NC: masks with bit 15, halves and bytes of a word, long ways in two words.
// shows: out long 24
// sets: F[0] 32769, F[1] 65535, F[2] 1, F[5] 65000, F[10] 16384, F[11] 7, F[12] 65535
// sets: F[0] 49152, F[1] 0, F[2] 32768, F[5] 12, F[10] 65535, F[11] 1, F[12] 2
long out[24];
void init() { plc1_time = 1; plc2_time = 1; }
void plc1()
{
  int i = 0, a;
  unsigned *p;
  out[i++] = (*F_ui[0] & 0x8000) != 0; out[i++] = *F_ui[0] & 0x8000; out[i++] = *F_i[0] & 0x8000; out[i++] = *F_i[0] >> 15; out[i++] = *F_ui[0] >> 15;
  out[i++] = *F_l[1]; out[i++] = *F_ul[11] / 3; out[i++] = *F_uc[5]; out[i++] = F_uc[5][1]; out[i++] = *F_c[5]; out[i++] = F_ui[10][1] + F_ui[10][2];
  for (a = 0; a < 2; a++) { *G_l[10 * a + 1] += *F_l[10 * a + 1] / 2; *G_ui[10 * a] |= 0x8000; *G_ui[a * 10] ^= *F_ui[a * 10] << 1; *G_i[10 * a + 3] = -*F_i[5] * (a + 1); }
  *G_ui[0] &= ~0x0040; *G_uc[4] = 200; G_uc[4][1]--; *G_c[5] -= 1;
  p = G_ui[6]; *p++ = *F_i[0]; *p = *F_ui[1] + 1; p[1] |= 0x55; --*p; *(p + 2) = p[0] == 0xFFFF;
  out[i++] = *G_l[1]; out[i++] = *G_ui[0]; out[i++] = *G_i[4]; out[i++] = *G_i[3] < 0 ? -*G_i[3] : *G_i[3]; out[i++] = p - G_ui[6]; out[i++] = *G_l[1] < *G_ul[1];
  out[i++] = -*F_ui[5]; out[i++] = ~*F_i[5]; out[i++] = !*F_l[1]; out[i++] = *F_ui[0] * *F_ui[0]; out[i++] = (long) *F_i[5] * *F_i[0];
}
void plc2() { }
