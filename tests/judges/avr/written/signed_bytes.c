// Bytes as counters and differences, where signs come and go.
// shows: out int 32, l long 8, c char 8, u unsigned char 8
// sets: X[0] 127, X[1] 128, X[2] 255, X[3] 1
// sets: X[0] 200, X[1] 100, X[2] 0, X[3] 129
int out[32];
long l[8];
char c[8];
unsigned char u[8];
void init() { plc1_time = 1; plc2_time = 1; }
void plc1()
{
  int i = 0;
  char a = X[0], b = X[1];
  unsigned char p = X[0], q = X[1];
  signed char s = X_c[2];
  out[i++] = a + b; out[i++] = p + q; out[i++] = a - q; out[i++] = p - b;
  out[i++] = a * b; out[i++] = p * q; out[i++] = a < b; out[i++] = p < q;
  out[i++] = a == p; out[i++] = b == q; out[i++] = ~a == ~p; out[i++] = (char) q == b;
  out[i++] = (unsigned char) b == q; out[i++] = -a; out[i++] = -p; out[i++] = !b;
  out[i++] = a >> 1; out[i++] = p >> 1; out[i++] = b << 1; out[i++] = q << 1;
  out[i++] = a & 0xFF; out[i++] = a & 0xFFFF; out[i++] = a | 0x100; out[i++] = s ^ 0x80;
  out[i++] = a / 3; out[i++] = b % 7; out[i++] = p / -3; out[i++] = q % -7;
  out[i++] = (a + b) / 2; out[i++] = (p + q) >> 1; out[i++] = (char) (a + b); out[i++] = (unsigned char) (a - q);
  l[0] = a + b; l[1] = (unsigned) b; l[2] = (unsigned char) b; l[3] = (unsigned long) b; l[4] = (unsigned) (long) b;
  l[5] = b * 300L; l[6] = b * 300; l[7] = b * 300u;
  c[0] = a += b; c[1] = a++; c[2] = --b; c[3] = s -= 200; c[4] = s <<= 1; c[5] = s >>= 1; c[6] = q >> 1; c[7] = (p -= 200) < 0;
  u[0] = p *= q; u[1] = p++; u[2] = ++q; u[3] = q ^= -1; u[4] = p |= a; u[5] = p /= 3; u[6] = p %= 5; u[7] = -p;
}
void plc2() { }
