// Long straight code with shared results: the same values computed again after what they depend on has changed.
// shows: out long 40
// sets: X[0] 12, X[1] 250, P[0] 65000
// sets: X[0] 255, X[1] 3, P[0] 7
long out[40];
int v; unsigned char b; int t[4];
static void change(int *p) { ++*p; v -= *p; b++; }
static int read(void) { return v * 2 + b; }
void init() { plc1_time = 1; plc2_time = 1; }
void plc1()
{
  int k = 0, x, y; unsigned char i = X[1] & 3; int *p = &t[i];
  v = X[0] * X[1]; b = v; x = v + b; out[k++] = x; v++; y = v + b; out[k++] = y - x; change(&t[1]); out[k++] = v + b; out[k++] = read(); b += X[0]; out[k++] = read() - (v + b);
  t[i] = 5; *p += t[i]; out[k++] = t[i]; t[1] = 9; out[k++] = *p; *p = t[2] - 1; out[k++] = t[i] + t[2]; t[t[1] & 3]++; out[k++] = *p + t[1]; change(p); out[k++] = t[i] * *p;
  x = y = v; y++; out[k++] = x - y; x = x + (y = 5) * 2; out[k++] = x; x = -x; out[k++] = x < 0 ? -x : x; x ^= y; y ^= x; x ^= y; out[k++] = y;
  R[0] = X[0]; x = R_i[0]; R[1] = X[1]; y = R_i[0]; out[k++] = x != y; R_i[0]++; out[k++] = R[0] + R[1]; R_l[0] -= 256; out[k++] = R[1]; R[i]++; out[k++] = R_ul[0]; out[k++] = *(int *) &R[i] + R[i];
  if (x > 100) x = 100; if (x < -100) x = -100; out[k++] = x * x; out[k++] = x * x * x; y = x & 15; out[k++] = y * y * y; out[k++] = (y << 12) / 4096; out[k++] = y + 250 > 255; b = y + 250; out[k++] = b > 255 - y; out[k++] = b;
  for (i = 0; i < 3; i++) { x = t[i]; t[i + 1] += x; t[i] = t[i + 1] - x; if (x == t[i]) continue; b ^= x; } out[k++] = b; out[k++] = t[0] + t[1] * 2 + t[2] * 3 + t[3];
}
void plc2() { }
