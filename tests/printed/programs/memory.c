// Objects: where they are, what they are called, how they begin, and accesses to them and through pointers.
#include "plc.h"
#include <string.h>
#define LAMP Y[7]
#define START X[3]
#define WORD(k) R_ui[k]
#define DOOR *F_i[12]
struct point { int x, y; };
struct axis { char name; long speed; struct point at[2]; unsigned char flags[3]; } axes[3], one_axis, *axis_pointer;
struct bits { unsigned low : 3; unsigned : 2; int sign : 4; unsigned high : 7; unsigned char small : 1; } flags, fields[2];
union both { int word; unsigned char bytes[2]; struct { char low, high; } parts; } both, several[2];
struct inner { struct { int deep; union { long whole; int halves[2]; } u; } in; } tree;
int zero, one = 1, minus = -1, row[4] = {1, 2, 3}, grid[2][3] = {{1, 2, 3}, {4}}, *pointer, *to_one = &one, *to_row = &row[2];
char letters[] = "abc", padded[6] = "xy", *text = "hello";
const char *const texts[] = {"first", "second", "first"};
long big = 100000L, *long_pointer; float real = 1.5; double wide = -2.25; unsigned char byte = 200; const char fixed[3] = {7, 8, 9};
struct point start = {3, 4}, line[2] = {{1, 2}, {3, 4}}; struct bits set = {5, -3, 100, 1}; union both first = {0x1234};
struct axis full = {'x', 70000L, {{1, 2}, {3, 4}}, {5, 6, 7}};
static int hidden = 9; enum colour { RED, GREEN = 5, BLUE } colour = BLUE;
int a, i, j, n;
static int any() { return R_i[0]; }
static struct point make(int x, int y) { struct point p; p.x = x; p.y = y; return p; }
static struct point same(struct point p) { p.x++; return p; }
static struct point none() { struct point p = {1}; if (a) return p; }
static int sum(struct point p, struct point q) { return p.x + q.y; }
static int *pick(int k) { if (k) return &one; return &row[k]; }
static int *single() { return &row[1]; }
static int *null() { return 0; }
static int read(int *p) { return *p; }
static void write(int *p, int k) { *p = k; p[1] = k; }
static int count(char *p) { int k = 0; /*@loop_bound 9@*/ while (*p++) k++; return k; }
static int changed(int k) { int *p = &k; *p += 2; return k; }

static void areas() {
  X[0]; n = X[3] + X_c[4] + X_ui[5] + X_i[6] + X_ul[7] + X_l[8]; Y[1] = 1; Y_c[2] = 2; Y_ui[3] = 3; Y_i[4] = 4; Y_ul[5] = 5; R[6] = 6; R_ui[7] = 7; R_ul[8] = 8;
  P[1]; n = P_uc[3] + P_i[4] + P_ul[2]; B[1] = n; B_uc[3] = 1; B_l[2] = 5; *F_uc[1]; n = *F_i[2] + *F_ui[3] + *F_ul[4] + *F_l[5]; *G_c[1] = 1; *G_i[2] = 2; *G_ul[3] = 3; F[4];
  LAMP = START; WORD(9) = DOOR; n = WORD(3); R[i] = 1; n = R_ui[i]; n = X[i & 7]; R[i + 1] = 2; R[i - 1] = 3; R[2 * i] = 4; R_ul[i] = 5; *G_i[i] = 6; n = *F_uc[i & 7]; n = P[i & 3]; B[i] = 7;
  if (i >= 0 && i < 100) { R[i] = 1; R[i + 1] = 1; R[i + 700] = 1; R[767 - i] = 1; R_ui[i] = 1; n = X[i]; }
  mod_M_code(0); n = mod_S_code(1); ch_ctrl(0); 
}
static void objects() {
  zero = one + minus + row[1] + grid[1][2] + letters[2] + padded[4] + byte + fixed[1] + hidden + colour; big++; real += wide;
  row[0] = 1; row[3] = 2; row[i] = 3; row[i & 3] = 4; row[(i & 3) + 1] = 5; row[i + 1] = 6; row[i - 1] = 7; row[3 - i] = 8; row[i] += 2; row[i]++; n = row[i++]; n = row[++i];
  grid[0][0] = 1; grid[1][i] = 2; grid[i][1] = 3; grid[i][j] = 4; grid[i & 1][j & 1] = 5; grid[i][j] += 6; n = grid[i][j]; n = *grid[1]; n = (*(grid + 1))[2]; n = sizeof(grid) + sizeof row[0];
  letters[i] = 'z'; n = letters[i & 1]; n = fixed[i]; n = texts[1][2]; n = texts[i][0]; n = text[3]; n = text[i]; n = "literal"[2]; n = "literal"[i];
  axes[0].name = 'a'; axes[1].speed = 5; axes[2].at[1].y = 6; axes[i].speed = 7; axes[i].at[j].x = 8; axes[1].at[j].y = 9; axes[i].flags[2] = 1; axes[i].flags[j] = 2; n = axes[i].at[1].x; one_axis.flags[i] = 3;
  both.word = 5; n = both.bytes[1]; both.parts.high = 3; several[1].parts.low = 4; several[i].word = 5; n = several[i].bytes[j]; tree.in.deep = 1; tree.in.u.whole = 2; tree.in.u.halves[1] = 3; tree.in.u.halves[i] = 4;
}
static void bounded() {
  int k = (any() & 1) - 1, m = any() & 1, q = 2 - (any() & 3);
  n = grid[k][m]; n = grid[k + 1][m]; n = grid[m][k + 1]; n = grid[m][k]; n = grid[q][m]; n = axes[k].at[m].x; n = axes[m].at[k + 1].y; n = axes[m + 1].flags[q]; row[q + 1] = 1; row[q] = 2; n = *(row + m + k); pointer = &row[m]; n = pointer[k]; n = pointer[k + 1]; pointer = &row[q]; n = *pointer;
}
static void bit_fields() {
  flags.low = 3; flags.sign = -2; flags.high = a; flags.small = 1; n = flags.low; n = flags.sign; n = flags.high; n = flags.small; flags.low++; --flags.sign; flags.high += 3; flags.low |= 4; n = flags.sign++; n = (flags.low = 9); n = ++flags.low;
  fields[1].low = 2; fields[i].sign = 3; fields[i].high++; n = fields[i].small; n = fields[i & 1].low; if (flags.small) n++; if (flags.sign < 0) n--; flags.low = flags.high; fields[0] = flags; n = set.sign;
}
static void records() {
  struct point p, q = {1, 2}, r[2] = {{1}, {2, 3}}; struct axis s = {'a'}; struct point copied = start; union both u = {7}; int local[5] = {1, 2}; char name[4] = "ab"; long large[20] = {1}; struct bits b = {1, 2};
  p = q; p = start; start = p; r[1] = r[0]; r[i] = p; p = r[i]; axes[1] = axes[0]; axes[i] = one_axis; one_axis = axes[i]; s = axes[0]; axes[1].at[0] = p; both = several[1]; tree = tree;
  p = make(1, 2); n = make(3, 4).y; p = same(q); p = same(make(1, 2)); p = none(); n = sum(p, q); n = sum(make(1, 2), make(3, 4)); n = sum(p, make(a++, 5)); p = a ? q : start; p = a ? make(1, 2) : q; p = (a++, q); r[any() & 1] = make(1, 2); *&p = q;
  n = local[i] + name[i & 3] + large[i] + b.sign + u.bytes[1] + copied.x + s.speed; local[4] = 1; large[19] = 2; same(p); n = (p = q).y;
}
static void pointers() {
  int local, *p, *q = &local, *unset; char *s = letters; struct axis *x = axes; struct point *y; unsigned char *bytes; long *longs = &big;
  p = &one; n = *p; *p = 5; p = &row[1]; n = *p; n = p[1]; p[1] = 2; *p++ = 3; n = *p++; n = *++p; n = *p--; p += 2; p -= 1; p = p + 1; p = 1 + p; p = p - 1; n = p[i]; p[i] = 4; n = *(p + i); n = *(p - i); (*p)++; *p += 3;
  p = row; p = row + 2; p = &row[i]; n = *p; p = grid[1]; p = &grid[i][1]; n = p[1]; p = a ? &one : row; n = *p; *p = 7; p = any() ? pick(1) : q; n = *p; p = pick(a); n = *p; n = *pick(a); n = *single(); n = read(&one); n = read(row); n = read(p); write(&row[1], 5); write(p, 6); n = changed(a);
  *q = 3; n = local; p = q; if (p) n++; if (!p) n++; if (p == 0) n++; if (p != 0) n++; if (p == q) n++; if (p != q) n++; if (p == &one) n++; if (&row[1] == &row[2]) n++; p = null(); p = 0; n = p == 0;
  n = &row[3] - &row[1]; p = &row[3]; q = &row[i]; n = p - q; n = p < q; n = p > q; n = p <= q; n = p >= q; n = p == q; n = row == q;
  s = "constant"; n = *s; n = s[i]; n = texts[i][1]; s = text; n = count(s); n = count("word"); text = letters; text = padded + 1; n = *text; n = *text++; s = a ? "yes" : "no"; n = *s;
  x = &axes[1]; n = x->speed; x->at[1].y = 3; x++; x->flags[i] = 4; x = &axes[i]; n = x->name; y = &x->at[1]; n = y->x; y = &start; y->y++; *y = line[1]; line[0] = *y; x = &one_axis; (*x).speed = 5; axis_pointer = axes; axis_pointer->speed++;
  bytes = (unsigned char *)&both; n = bytes[1]; bytes = &R[5]; *bytes = 1; bytes[i] = 2; bytes = (unsigned char *)row; n = bytes[3]; *longs = 5; longs = (long *)&R[8]; *longs = 6; pointer = (int *)&R[10]; *pointer = 7; long_pointer = &big; n = *long_pointer; n = *to_one + *to_row; to_row++; *to_row = 1;
}
static int o1, o2, o3, o4, o5, o6, o7, o8, o9, o10, o11, o12, o13, o14, o15, o16, *several_objects = &o1;
static void nulls() {
  int *z = 0, *y; if (a) z = row; n = *z; *z = 3; z = 0; n = z == 0; y = 0; if (a) y = &row[i & 3]; n = y[1]; if (y) n = *y;
}
static void choices() {
  switch (a) { case 1: several_objects = &o2; break; case 2: several_objects = &o3; break; case 3: several_objects = &o4; break; case 4: several_objects = &o5; break; default: several_objects = &o6; }
  n = *several_objects; *several_objects = 5; several_objects[i] = 6; memset(several_objects, 1, 2); n = several_objects == &o3; n = several_objects != 0; n = read(several_objects);
}
static void copies() {
  char here[10], there[10]; struct axis s;
  memset(here, 0, 10); memset(here, 'x', 3); memset(&here[2], a, 4); memset(row, 0, sizeof row); memset(here, 1, 20); memset(here + i, 2, j); memset(&s, 0, sizeof s); memset(here, 0, 0); memset((void *)&R[10], 0xFF, 20);
  memcpy(here, there, 10); memcpy(here, letters, i); memcpy(&here[i], there, 3); memcpy(&s, &axes[1], sizeof s); memmove(here, &here[1], 5); memmove(here + i, here, j); n = memcmp(here, there, 10); n = memcmp(here, "abc", i); memcpy(a ? here : there, letters, 3); n = *(char *)memset(here, 5, 2);
}
void init() { plc1_time = 1; plc2_time = 1; one = 2; }
void plc1() { areas(); objects(); bounded(); bit_fields(); records(); pointers(); nulls(); choices(); copies(); }
void plc2() { X[100]; Y[5] = X[99]; }
