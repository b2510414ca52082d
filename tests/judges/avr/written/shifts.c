// Shifts by variables over every type, of values of both signs, and by compound assignments.
// shows: a int 16, b unsigned 16, c long 32, d unsigned long 32, e unsigned char 16, f char 16
// sets: P[0] 32769, P[1] 65535, X[0] 129
// sets: P[0] 1, P[1] 32767, X[0] 127
int a[16]; unsigned b[16]; long c[32]; unsigned long d[32]; unsigned char e[16]; char f[16];
void init() { plc1_time = 1; plc2_time = 1; }
void plc1()
{
  int n;
  for (n = 0; n < 16; n++) {
    a[n] = (P_i[0] >> n) + (P_i[1] << n);
    b[n] = (P[0] >> n) - (P[1] << n);
    e[n] = X[0] << (n & 7) | X[0] >> (8 - (n & 7));
    f[n] = X_c[0] >> (n & 7) ^ X_c[0] << (n & 3);
    a[n] ^= X_c[0] << n; b[n] ^= X[0] << n;
    a[n] >>= n / 2; b[n] >>= n / 2; e[n] <<= n & 3; f[n] >>= n & 3; e[n] >>= 1; f[n] <<= 1;
  }
  for (n = 0; n < 32; n++) {
    c[n] = (P_l[0] >> n) ^ (P_l[0] << n) ^ (1L << n);
    d[n] = (P_ul[0] >> n) + (P_ul[0] << (31 - n)) + (0xFFFFFFFF >> n);
    c[n] <<= n & 3; d[n] >>= n & 1; c[n] >>= n % 5;
    if (n < 16) { c[n] += 1 << n; d[n] += 1 << n; c[n + 16] -= 1u << n; d[n + 16] |= -1 << n; }
  }
}
void plc2() { }
