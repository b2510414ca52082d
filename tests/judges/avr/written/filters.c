// Edges and debounced inputs as the manual makes them: four samples in registers, masks, and the falling edge.
// shows: rise unsigned 1, fall unsigned 1, held unsigned char 8
// sets: X[0] 1, X[1] 129
// sets: X[0] 1, X[1] 1
// sets: X[0] 0, X[1] 129 cycles 2
// sets: X[0] 3, X[1] 255 cycles 3
// sets: X[0] 0, X[1] 0 cycles 2
#define x(g, b) (X[g] & 1 << (b))
#define g(g, b) (R[10 + (g)] & (1 << (b)))
unsigned rise, fall;
unsigned char held[8];
void sample(void)
{
  int i;
  for (i = 0; i < 2; i++) { R[30 + i] = R[20 + i]; R[20 + i] = R[10 + i]; R[10 + i] = X[i]; }
}
void init() { plc1_time = 1; plc2_time = 1; }
void plc1()
{
  unsigned char b, i;
  for (i = 0; i < 2; i++) {
    rise |= (X[i] & R[10 + i] & ~R[20 + i] & ~R[30 + i]) << 8 * i;
    fall |= (~X[i] & ~R[10 + i] & R[20 + i]) << i * 8;
  }
  for (b = 0; b < 8; b++) {
    if (x(1, b) && g(1, b)) { if (held[b] < 255) ++held[b]; }
    else if (!x(1, b)) held[b] = held[b] > 1 ? held[b] - 2 : 0;
    if (held[b] >= 2) Y[1] |= 1 << b; else Y[1] &= ~(1 << b);
  }
  if (R[30] & 0x01 != 0x01) Y[0]++; else Y[0] ^= 0xFF;
  if (!(X[0] & 1) == 0) Y[2] = ~X[1]; else if (~X[1] < 0) Y[3]--;
  sample();
}
void plc2() { }
