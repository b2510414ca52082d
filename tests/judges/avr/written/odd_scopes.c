// Names that hide names, statics in blocks and in functions that both parts call, initialised locals in loops, tags and typedefs.
// shows: l long 60, m long 8
// sets: X[0] 5, X[1] 2
// sets: X[0] 0, X[1] 255
typedef int number; typedef unsigned char byte; typedef struct node { number x; byte t[3]; } node; typedef number row[3]; typedef node pair[2];
long l[60], m[8]; int x = 10; static int s = 1; node gn = { 1, { 2, 3 } }; pair gp = { { 1, { 1 } }, { 2, { 4, 5, 6 } } }; row grid[2] = { { 1, 2 }, { 4 } }; byte text[] = "xyz", more[5] = "xyz"; int flat[2][3] = { 1, 2, 3, 4 };
int count(void) { static int s; static int t = 5; return (s += 2) * 100 + (t -= 1); }
int twice(void) { int r; { static int q = 1; q *= 3; r = q; } { static int q = 7; q++; r += q * 1000; } return r; }
int param(int x) { { int x = 3; x++; } return x++ + x; }
int locals(int n) { int i, r = 0; for (i = 0; i < 4; i++) { int a[3] = { 1 }; byte b = 250; a[1] += i; a[0] += n; b += i; r += a[0] * 100 + a[1] * 10 + a[2] + b; a[2] = 9; } return r; }
number same(node node) { typedef long number; number r = node.x; { struct node { char c; } q; q.c = 300; r += q.c; } return r + sizeof(number); }
int inner(int v) { enum { first = 3, second }; { enum { first = 30 }; v += first; } return v + first + second; }
static int twin(int v) { return v + s; }
int fallen(int v) { int k = v; { int v = k * 2; { int k = v + 1; v = k; } k += v; } return k + v; }
void init() { x = 11; plc1_time = 1; plc2_time = 2; }
void plc1()
{
  int k = 0, i; node n = { 7, { 1, 2, 3 } }; pair p = { { 3, { 1, 2, 3 } } }; row r = { 9, 8 };
  l[k++] = count(); l[k++] = count(); l[k++] = twice(); l[k++] = param(X[0]); l[k++] = locals(X[0]); l[k++] = same(n); l[k++] = inner(X[1]); l[k++] = twin(1); l[k++] = fallen(X[0]); l[k++] = x; { int x = 5; l[k++] = x; x = x * 2; { extern int x; l[k++] = x++; } l[k++] = x; } l[k++] = x;
  l[k++] = gn.x + gn.t[0] + gn.t[1] + gn.t[2]; l[k++] = gp[0].t[0] + gp[0].t[2] + gp[1].t[1] * 10; l[k++] = grid[0][1] + grid[0][2] + grid[1][0] * 10 + grid[1][1]; l[k++] = flat[1][0] + flat[1][2] + flat[0][2]; l[k++] = sizeof text * 100 + sizeof more; l[k++] = more[3] + more[4] + text[3] + text[2]; l[k++] = p[1].x + p[1].t[0] + p[0].t[2]; l[k++] = r[0] + r[2];
  gp[1] = n; gp[0].t[1] = gp[1].t[2] + X[1]; l[k++] = gp[0].t[1]; l[k++] = sizeof(pair) + sizeof(row) * 100; s++;
  for (i = 0; i < 3; i++) { static int i2; int i = i2; i2 += 2; l[k++] = i; }
  { int a = 3, b = a + 1, c[2] = { a, b }; l[k++] = a + b * 10 + c[1] * 100; { int a = 8; c[0] = a; } l[k++] = c[0] + a; }
}
void plc2() { int k = 0; m[k++] = count(); m[k++] = twice(); m[k++] = x; m[k++] = s; m[k++] = locals(1); }
