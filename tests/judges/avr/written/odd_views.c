// Bytes of registers read as wider words and back, reversed, overlapping, unaligned, in one expression with their own change.
// shows: l long 40
// sets: X[0] 5, X[1] 200, P[0] 65535, P[1] 4660
// sets: X[0] 0, X[1] 255, P[0] 32769, P[1] 255
long l[40];
unsigned turn(unsigned v) { return v << 8 | v >> 8; }
void init() { plc1_time = 1; plc2_time = 1; }
void plc1()
{
  int k = 0, i; unsigned char *p; unsigned *w; int *q;
  R_ui[0] = P[0]; R_ui[1] = P[1]; l[k++] = R_l[0]; R_ui[0] = R[0] << 8 | R[1]; l[k++] = R_i[0]; R[0] = R_ui[0] >> 8; l[k++] = R_ui[0]; R_l[0] = R_l[0] << 8 | R[0]; l[k++] = R_ul[0]; R_l[0] = R_l[0] >> 4; l[k++] = R_l[0]; R_c[3] -= 1; l[k++] = R_l[0]; R_i[1] = -R_i[1]; l[k++] = R_l[0]; R_uc[1] = R_c[3]; l[k++] = R_i[0]; l[k++] = R_c[0] + R_uc[0] + R[0]; R_l[0] += R_c[1]; l[k++] = R_l[0]; R_ui[0] ^= R_ui[1]; R_ui[1] ^= R_ui[0]; R_ui[0] ^= R_ui[1]; l[k++] = R_l[0];
  for (i = 0; i < 12; i++) R[10 + i] = X[0] + i * 37; for (i = 0; i < 8; i++) R[11 + i] = R[10 + i]; l[k++] = R[18]; for (i = 7; i >= 0; i--) R[13 + i] = R[11 + i] + 1; l[k++] = R_l[4]; l[k++] = R_i[6] * R_ui[7];
  p = &R[30]; w = (unsigned *) (p + 1); *w = P[0]; w[1] = turn(*w); l[k++] = R[30] + R[31] * 2 + R[32] * 3 + R[33] * 5 + R[34] * 7; *(long *) (p + 2) = -70000; l[k++] = R_ui[16]; l[k++] = *w; q = (int *) (R + 33); l[k++] = *q; *q++ -= 5; l[k++] = R_l[8]; *q = *(q - 1); l[k++] = R_l[8]; R_i[R[0] & 3] = -1; l[k++] = R_ui[R_c[0] & 3];
  R_ul[10] = 0; R[40 + (X[0] & 3)] = X[1]; l[k++] = R_ul[10]; R_ui[20] += 300; R[40] += 10; l[k++] = R_ul[10]; R_c[43] = R_ul[10] > 1000 ? -1 : 1; l[k++] = R_l[10]; Y[3] = R_i[20]; Y_i[2] = Y_c[3]; l[k++] = Y_ui[2]; Y_l[2] = Y_ul[0] / 3; l[k++] = Y_i[4];
  R[50] = X[1]; R[51] = R[50]++ ; l[k++] = R_i[25]; R[50] = -R[51]; R_i[25] |= 0x8001; l[k++] = R_i[25] >> 1; l[k++] = R_ui[25] >> 1; l[k++] = (R_c[50] & 0xF0) + (R[51] & ~0x0F); R_l[13] = (long) R_i[25] * R_ui[25]; l[k++] = R_l[13]; 
}
void plc2() { }
