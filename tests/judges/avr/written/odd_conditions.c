// Conditions of every type and shape: pointers, bytes, longs, assignments, double negations, choices as conditions, empty branches.
// shows: l long 50
// sets: X[0] 1, X[1] 128, P[0] 256, P[1] 1
// sets: X[0] 0, X[1] 255, P[0] 65535, P[1] 65535
// sets: X[0] 4, X[1] 0, P[0] 0, P[1] 32768
long l[50]; unsigned char b; int t[3]; struct { unsigned f : 3; int g : 3; unsigned char c; } s;
int even(unsigned v) { if (v & 1) return 0; return 1; }
int sign(long v) { return v < 0 ? -1 : v > 0; }
int grade(int v) { if (v < 0) ; else if (v < 10) return 1; else if (v < 100) { if (v == 50) return 5; } else return 3; return 9; }
int dangling(int a, int c) { int r = 0; if (a) if (c) r = 1; else r = 2; return r; }
int closed(int a, int c) { int r = 0; if (a) { if (c) r = 1; } else r = 2; return r; }
void init() { plc1_time = 1; plc2_time = 1; }
void plc1()
{
  int k = 0, i, j = 3; int *p = X[0] ? t + 1 : t; long q = P_l[0]; unsigned u = P[0]; char c = X[1];
  l[k++] = !X[0]; l[k++] = !!X[1]; l[k++] = !c + !u * 2 + !q * 4; l[k++] = !!!q; l[k++] = !(X[0] - 1); l[k++] = -!X[0]; l[k++] = ~!X[0]; l[k++] = !-X[0]; l[k++] = !p; l[k++] = p == t; l[k++] = p > t; l[k++] = p && *p == 0;
  if (q) l[k] = 1; k++; if (q >> 16) l[k] = 1; else l[k] = 2; k++; if ((char) u) l[k] = 1; else l[k] = 2; k++; if ((unsigned char) (u + 1)) l[k] = 1; else l[k] = 2; k++;
  if (b = X[1] + X[0]) l[k] = b; else l[k] = -1; k++; if ((i = u) < 0) l[k] = i; else l[k] = -i; k++; if (X[0] ? c : u) l[k] = 1; else l[k] = 2; k++; if (X[0] & 1 ? 0 : 1) l[k] = 1; else l[k] = 2; k++; if (c, u) l[k] = 1; else l[k] = 2; k++;
  s.f = X[0] + X[1]; s.g = X[1]; s.c = u; if (s.f) l[k] = s.f; else l[k] = -1; k++; if (s.g < 0) l[k] = s.g; else l[k] = 7; k++; if (s.c == u) l[k] = 1; else l[k] = 2; k++; if (s.f == s.g) l[k] = 1; else l[k] = 2; k++;
  l[k++] = even(u) + even(X[0]) * 2; l[k++] = sign(q) * 9 + sign(c) * 3 + sign(i); l[k++] = grade(X[0]) * 100 + grade(X[1]) * 10 + grade(c); l[k++] = grade(50); l[k++] = dangling(X[0], u) * 100 + dangling(1, 0) * 10 + closed(X[0], u); l[k++] = closed(1, 0);
  while (j--) { if (j == 2) { l[k] -= 7; continue; } l[k] += j; } k++; j = 0;
  //@loop_bound 6
  do if (j < 3) j++; else break; while (j < 5); l[k++] = j; for (i = 0; i < 3; i++) t[i] = i == 1 ? -i : i ? i * 2 : 5; l[k++] = t[0] * 100 + t[1] * 10 + t[2];
  l[k++] = (c == 128) + (c == -128) * 2 + (c == (char) 128) * 4 + (X[1] == 128) * 8 + (X[1] == (char) 128) * 16; l[k++] = (c == 255) + (c == -1) * 2 + ((unsigned char) c == 255) * 4; l[k++] = (u == -1) + (u == 65535) * 2 + (u == ~0) * 4 + ((int) u == -1) * 8 + (q == -1) * 16 + (q == 0xFFFFFFFF) * 32; l[k++] = 0 < X[0] < 1; l[k++] = X[0] == 1 != 0; l[k++] = (X[0] > 0) - (c < 0);
  if (X[0]) { } else { l[k] = 5; } k++; if (!X[0]) ; l[k++] = 6; if (1) if (X[0]) ; else l[k] = 7; k++;
}
void plc2() { }
