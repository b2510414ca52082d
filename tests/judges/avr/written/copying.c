// memcpy, memset, memcmp and memmove on arrays and registers, rotations, abs of the edge values.
// shows: a unsigned char 12, w int 6, out int 16, l long 4
// sets: R[0] 200, R[1] 1, R[2] 128, R[3] 7, P[0] 32768, P[1] 33000
// sets: R[0] 1, R[1] 255, R[2] 2, R[3] 0, P[0] 65535, P[1] 17
#include <stdlib.h>
#include <string.h>
unsigned char a[12];
int w[6], out[16];
long l[4];
void init() { plc1_time = 1; plc2_time = 1; }
void plc1()
{
  int i = 0;
  memset(a, 0x1FF, 5); memset(a + 5, X[0] + 7, 3); memcpy(&a[2], R, 4); memcpy(w, &R[1], 4); memmove(a + 1, a, 6); memmove(&w[1], &w[0], sizeof w - sizeof *w);
  memcpy(&R[20], a, sizeof a); memset(&R[40], -1, 3); memcpy(&R_i[25], w + 1, 2 * sizeof(int));
  out[i++] = memcmp(a, a + 1, 3) > 0; out[i++] = memcmp(R, a, 0) == 0; out[i++] = memcmp(&R[0], &R[3], 1) < 0; out[i++] = memcmp(a, &R[20], 12);
  out[i++] = abs(P_i[0]); out[i++] = abs(R_c[0]); out[i++] = abs(-w[2]); out[i++] = _rotl(P[0], 3); out[i++] = _rotr(P[1], 5); out[i++] = max(P_i[0], P_i[1]); out[i++] = min(P[0], P[1]);
  out[i++] = max(R_c[0], R[1]); out[i++] = min(-1, 1u) == 1;
  l[0] = labs(P_l[0]); l[1] = _lrotl(P_ul[0], 9); l[2] = _lrotr(P_ul[0], 17); l[3] = max(P_l[0], P[0]) - min(w[0], P_l[0]);
}
void plc2() { }
