// Pointers to arrays, into the middle, backwards, over other types, chosen at run time, and sizes of what they point to.
// shows: l long 60
// sets: X[0] 2, X[1] 1, P[0] 40000, P[1] 513
// sets: X[0] 0, X[1] 3, P[0] 255, P[1] 65535
int m[4][3]; unsigned char bytes[16]; long l[60]; int one[6], two[6]; unsigned words[8]; const char text[] = "ab\0cd";
static const int table[] = { 5, -4, 3, -2, 1 };
int total(int (*p)[3], int n) { int i, j, s = 0; for (i = 0; i < 4; i++) if (i < n) for (j = 0; j < 3; j++) s = s * 2 + p[i][j]; return s; }
int row(int *p) { return p[0] + 10 * p[1] + 100 * p[2]; }
void fill(int p[], int n) { int *q = p, i; for (i = 6; i--; q++) *q = n += 7; }
unsigned reversed(unsigned char *p) { return p[0] << 8 | p[1]; }
void swap(int *p, int *q) { int t = *p; *p = *q; *q = t; }
void add(long *p, char *q) { *p += *q; *q = *p; *p -= *q; }
int *chosen(int which, int at) { return which ? one + at : &two[at]; }
int length(const char *s) { const char *p = s; int i = 0; while (i++ < 5 && *p) p++; return p - s; }
void init() { plc1_time = 1; plc2_time = 1; }
void plc1()
{
  int k = 0, i, j; int (*p)[3] = m; int *q; int *r; unsigned char *b; char *c; unsigned *w; long *g; const int *t;
  for (i = 0; i < 4; i++) for (j = 0; j < 3; j++) m[i][j] = i * j + X[0] - i;
  l[k++] = total(m, 4); l[k++] = total(m + 1, 2); l[k++] = p[1][2]; l[k++] = (*p)[1]; l[k++] = *(*(p + 2) + 1); l[k++] = **p; l[k++] = *p[3]; l[k++] = (*(p + X[1]))[X[0]]; p++; l[k++] = p[0][0] - p[-1][2]; l[k++] = p - m; l[k++] = sizeof *p + sizeof **p + sizeof m[0];
  l[k++] = row(m[2]); l[k++] = row(&m[X[1]][0]); l[k++] = row(*p); q = *m; l[k++] = q[7]; l[k++] = *(q + 3 * X[1] + X[0] / 2);
  fill(one, 1); fill(two, 100); swap(&one[X[0]], &two[X[1]]); swap(one + 5, one + 5); swap(one, one + 1); l[k++] = one[0]; l[k++] = one[1]; l[k++] = one[X[0]]; l[k++] = two[X[1]]; l[k++] = one[5];
  q = chosen(X[0], 3); *q -= 5; q[-1] = 9; *chosen(!X[0], X[1]) *= 2; l[k++] = one[2] + one[3]; l[k++] = two[2] + two[3]; l[k++] = two[X[1]] + one[X[1]]; r = X[1] > 1 ? one : two; l[k++] = q == r + 3; l[k++] = r[4];
  q = one; r = two + 5; for (i = 0; i < 3; i++) *q++ = *r--; l[k++] = one[0] + one[1] * 2 + one[2] * 3; l[k++] = q - one; l[k++] = r - two; *q = *r++ + *q; l[k++] = *q;
  words[3] = P[0]; b = (unsigned char *) &words[3]; l[k++] = reversed(b); c = (char *) b; l[k++] = *c; l[k++] = c[1]; b[1] ^= b[0]; l[k++] = words[3]; l[k++] = *(int *) b;
  g = (long *) &words[2]; *g = -2; l[k++] = words[2]; l[k++] = words[3]; g = (long *) (b - 1); *g = 0x12345678; l[k++] = words[2]; l[k++] = words[3]; l[k++] = words[4];
  w = (unsigned *) &bytes[X[0] + 1]; *w = P[1]; w[1] = ~*w; l[k++] = bytes[X[0] + 1]; l[k++] = bytes[X[0] + 2]; l[k++] = bytes[X[0] + 3] + bytes[X[0] + 4]; add((long *) (bytes + 8), (char *) bytes + 8); l[k++] = bytes[8];
  t = table + 4; l[k++] = t[-4] + *t + t[-X[1]] * 2; l[k++] = X[1][table]; l[k++] = &table[4] - t--; l[k++] = t > table; l[k++] = *t; l[k++] = length(text) * 10 + length(text + 3); l[k++] = sizeof text + sizeof "xyz" + sizeof t; l[k++] = "hello"[X[1]]; l[k++] = *("hello" + X[0]);
  q = (int *) 0; l[k++] = q == 0; l[k++] = !q + (q ? 1 : 2); 
}
void plc2() { }
