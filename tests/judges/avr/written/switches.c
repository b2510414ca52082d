// Switches over every type: negative cases, cases beyond the type, in loops, in each other, without a break.
// shows: out int 60
// sets: X[0] 255, P[0] 65535
// sets: X[0] 128, P[0] 5
// sets: X[0] 3, P[0] 40000
int out[60];
int of_char(char c) { switch (c) { case -1: return 1; case -128: return 2; case 'A': case 'B': return 3; case 127: return 4; } return 5; }
int of_byte(unsigned char c) { int r = 0; switch (c + 1) { case 256: r++; case 129: r += 10; break; default: r = -1; case 4: r += 100; } return r; }
int of_unsigned(unsigned u) { switch (u) { case 0xFFFF: return 1; case 40000: return 2; case 5: return 3; default: return u > 0x8000 ? 4 : 5; case 0x8000: return 6; } }
int of_int(int i) { switch (i) { case -1: return 1; case 0x9C40 - 0x10000: return 2; case 5: { switch (i * 2) { case 10: i++; break; default: i--; } if (i == 6) break; return 7; } default: return 4; } return i; }
int of_long(long l) { switch (l) { case 65535: return 1; case 70000: return 2; case -1L: return 3; case 0x80000000: return 4; case 5: return 5; } return 6; }
int of_expression(int a, int b) { switch (a > b ? a & 3 : -b & 3) { case 0: if (a) { case 1: a++; break; } else b++; case 2: return a - b; case 3: a = b; } return a + b; }
void init() { plc1_time = 1; plc2_time = 1; }
void plc1()
{
  int i, a = 1, k = 0;
  for (i = -3; i < 4; i++) {
    out[k++] = of_char(X[0] + i); out[k++] = of_byte(X[0] + i); out[k++] = of_unsigned(P[0] + i); out[k++] = of_int(P[0] + i); out[k++] = of_long(P[0] + i * 1L); out[k++] = of_long(P_i[0] + (i == 2 ? 0x7FFF0001 : i));
    out[k++] = of_expression(i, X[0] & 3);
    switch (i) { case -2: continue; case 0: break; case 2: a++; default: out[k] += a; break; }
    if (out[k] > 2) break;
  }
  for (i = 0; i < 6; i++) switch (i % 3) { case 1: if (X[0] & 1) break; out[58]++; continue; case 2: out[58] += 5; default: out[59]++; }
}
void plc2() { }
