// Unions in structures, arrays and parameters; each member after each other; copied, chosen and returned as a whole.
// shows: l long 50
// sets: X[0] 5, X[1] 2, P[0] 65535, P[1] 4660
// sets: X[0] 250, X[1] 0, P[0] 33000, P[1] 1
union u { unsigned char b[4]; int i[2]; unsigned w; long q; struct { char c; unsigned m; unsigned char e; } s; };
struct box { unsigned char kind; union u v; int tail; };
union u a, b, t[3]; struct box x[2]; long l[50];
union u make(long v) { union u r; r.q = v; return r; }
long turned(union u v) { unsigned char c = v.b[0]; v.b[0] = v.b[3]; v.b[3] = c; return v.q; }
int of(struct box *p) { switch (p->kind) { case 0: return p->v.b[1]; case 1: return p->v.i[1]; case 2: return p->v.s.m; } return p->tail; }
void init() { plc1_time = 1; plc2_time = 1; }
void plc1()
{
  int k = 0, i; union u *p; union u first = { { 1, 2, 3 } };
  a.q = P_l[0]; l[k++] = a.w; l[k++] = a.i[1]; l[k++] = a.b[0]; l[k++] = a.b[3]; l[k++] = a.s.c; l[k++] = a.s.m; l[k++] = a.s.e; a.s.m += 300; l[k++] = a.q; a.b[2]--; l[k++] = a.q; a.i[0] = -a.i[0]; l[k++] = a.q; a.s.c >>= 2; l[k++] = a.w; a.w *= 3; l[k++] = a.q;
  b = a; b.s.e ^= 0xFF; l[k++] = turned(b); l[k++] = b.q; l[k++] = turned(make(P_l[0])); l[k++] = make(-2).b[3]; l[k++] = make(P[1]).s.m; l[k++] = first.q; l[k++] = sizeof(union u) * 100 + sizeof(struct box) * 10 + sizeof a.s;
  for (i = 0; i < 3; i++) t[i].q = 0x01020304L * (i + 1); t[X[1]] = t[1]; t[0].b[X[1]] = t[2].b[3]; l[k++] = t[0].q; l[k++] = t[2].q; p = t; p++; p->i[0] = p[1].i[1]; p[-1].w = p->w; l[k++] = t[1].q; l[k++] = t[0].q; *p = X[0] > 100 ? a : b; l[k++] = t[1].q; l[k++] = (X[0] ? t[0] : a).i[1];
  for (i = 0; i < 2; i++) { x[i].kind = i + X[1] / 2; x[i].v = t[i]; x[i].tail = -i; } l[k++] = of(x); l[k++] = of(&x[1]); x[1] = x[0]; x[1].kind = 3; l[k++] = of(x + 1); x[1].v.s.m = x[0].v.s.e; l[k++] = x[1].v.q; l[k++] = *(long *) &x[1].v.b[0]; ((unsigned char *) &x[1])[1] = 77; l[k++] = x[1].v.b[0];
}
void plc2() { }
