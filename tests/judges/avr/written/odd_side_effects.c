// Effects inside expressions: comma, chains of assignments, conditions that assign, choices by choices, what is left out by && and ||.
// shows: l long 60, n int 12
// sets: X[0] 5, X[1] 2, P[0] 65535
// sets: X[0] 0, X[1] 255, P[0] 300
long l[60]; int n[12]; unsigned char b, b2; char c; unsigned u; int g;
int hit(int v) { n[v & 7]++; return v; }
int bump(int *p) { return ++*p; }
int set(unsigned char *p, int v) { *p = v; return *p; }
void init() { plc1_time = 1; plc2_time = 1; }
void plc1()
{
  int k = 0, i, j, t[4]; long q; unsigned char y;
  l[k++] = b = 300; l[k++] = c = b = P[0]; l[k++] = u = c = 200; l[k++] = q = u = c; l[k++] = b = c = u = 1000; l[k++] = (b = X[0]) - 6; l[k++] = b += c -= 100; l[k++] = c; l[k++] = b *= 3; l[k++] = b -= 200; l[k++] = c = -b; l[k++] = b >>= 1; l[k++] = c >>= 1; l[k++] = c <<= 5; l[k++] = b /= -3; l[k++] = c /= 3u; l[k++] = b %= -7; l[k++] = u += -1; l[k++] = u -= 40000L; l[k++] = u *= -1L; l[k++] = u >>= 3; l[k++] = u ^= -1; l[k++] = b |= -256; l[k++] = b &= ~1; l[k++] = ++b; l[k++] = b++; l[k++] = c--; l[k++] = ++c;
  i = (hit(1), hit(2), 3); l[k++] = i; i = hit(0) && hit(3) || hit(4) && !hit(5); l[k++] = i; i = hit(X[0]) ? hit(1) ? hit(2) : hit(3) : hit(4) ? hit(5) : hit(6); l[k++] = i; l[k++] = hit(1) || hit(7); l[k++] = !(hit(X[0]) && hit(7)) + 1;
  if ((i = X[0] - 5) == 0) hit(3); else hit(6); if ((b = X[1] + 1)) hit(2); if (!(j = i)) hit(7); l[k++] = i + j;
  i = 3; j = bump(&i) + 10; l[k++] = i * 100 + j; t[0] = t[1] = t[2] = t[3] = i; t[i -= 2] = 50; t[i > 1 ? i = 0 : 3] += 7; l[k++] = t[0] + t[1] * 2 + t[2] * 3 + t[3] * 5; l[k++] = i;
  y = 250; y += set(&b, 10); l[k++] = y; l[k++] = set(&y, 511) + set(&y, -1); l[k++] = (y++, y += 2, y); l[k++] = (i = 5, j = i++ * 2, i + j); 
  //@loop_bound 20
  for (i = 0, j = 20; i < j ? 1 : 0; i += 3, j--) hit(i); l[k++] = i * 100 + j;
  g = 0; l[k++] = (g = 5) && (g += X[0]) > 5 || (g = -1); l[k++] = g; l[k++] = X[0] == 5 == 1; l[k++] = 3 > 2 > 1; l[k++] = -X[0] < X[1] == X[0] > X[1]; l[k++] = X[0] & 4 == 4; l[k++] = X[0] ^ X[1] | X[0] & 3; l[k++] = !X[0] + ~X[1] - -X[0]; l[k++] = X[0] << 2 + 1 >> 1; l[k++] = X[1] - X[0] - 1 % 3 * 2;
}
void plc2() { }
