// Structures as values: alias of source and target, results' members, chains, parameters that are changed, elements of themselves.
// shows: l long 60
// sets: X[0] 2, X[1] 1, P[0] 40000
// sets: X[0] 0, X[1] 3, P[0] 17
struct in { char c; unsigned char b; };
struct pt { int x; struct in n[2]; unsigned y; long z; };
struct pt a, b, v[4];
long l[60];
struct pt make(int x, unsigned y) { struct pt p; p.x = x; p.y = y; p.z = (long) x * y; p.n[0].c = x; p.n[0].b = y; p.n[1].c = y; p.n[1].b = x; return p; }
struct pt swap(struct pt p) { int t = p.x; p.x = p.y; p.y = t; p.n[0] = p.n[1]; p.n[1].c++; return p; }
int touch(struct pt p, struct pt *q) { p.x += 100; q->x += 1000; p.y = q->y; return p.x + p.n[1].c; }
struct in inner(struct pt *p, int i) { return p->n[i]; }
long sum(struct pt p) { return p.x + p.y + p.z + p.n[0].c + p.n[0].b + p.n[1].c + p.n[1].b; }
struct in pick(struct in f, struct in g, int which) { return which ? f : g; }
void init() { plc1_time = 1; plc2_time = 1; }
void plc1()
{
  int k = 0, i; struct pt *p; struct in e; struct pt t;
  a = make(X[0] - 5, P[0]); b = make(-3, X[1]); l[k++] = sum(a); l[k++] = sum(b);
  t = a; a = b; b = t; l[k++] = sum(a); l[k++] = sum(b);
  a = swap(a); l[k++] = sum(a); b = swap(swap(b)); l[k++] = sum(b);
  for (i = 0; i < 4; i++) v[i] = make(i * 3, P[0] + i);
  v[X[0]] = v[X[1]]; v[3] = v[2] = v[1]; l[k++] = sum(v[0]); l[k++] = sum(v[2]); l[k++] = sum(v[3]);
  p = &v[X[1]]; *p = *p; l[k++] = sum(*p); *p = swap(*p); l[k++] = sum(*p); l[k++] = touch(*p, p); l[k++] = p->x;
  l[k++] = make(7, 9).y; l[k++] = make(-7, 9).n[1].c; l[k++] = swap(make(1, 2)).x * 10 + swap(make(1, 2)).y;
  e = inner(&b, X[0] & 1); l[k++] = e.c; l[k++] = e.b; l[k++] = inner(&v[1], 1).b;
  v[0].n[0] = v[0].n[1]; v[1].n[X[1] & 1] = pick(v[2].n[0], a.n[1], X[0]); l[k++] = v[0].n[0].c; l[k++] = v[1].n[0].b; l[k++] = v[1].n[1].c;
  a = X[0] ? v[1] : v[2]; l[k++] = sum(a); l[k++] = (X[0] ? a : b).x; l[k++] = (X[1] > 1 ? v[3] : make(5, 6)).z;
  a = (b.x++, b); l[k++] = sum(a); l[k++] = (a = v[3]).x; l[k++] = (t = v[X[0]], t.y++, t).y;
  { struct pt local = { 1, { { -1, 255 }, { 2 } }, 65535, -1 }; static struct pt kept = { 5, { { 1 } } }; kept.x += local.x; kept.n[1] = local.n[0]; l[k++] = sum(local); l[k++] = sum(kept); kept = local; kept.x = kept.x * 7; l[k++] = kept.x; }
  { struct pt many[3]; many[0] = a; many[1] = b; many[2] = many[X[0] & 1]; p = many + 1; p[1].n[0].c -= 200; p[-1].x = p[0].x - p[1].x; l[k++] = sum(many[0]); l[k++] = sum(many[2]); l[k++] = sizeof many; l[k++] = p - many; }
  l[k++] = sizeof(struct pt) + sizeof a.n + sizeof(make(1, 2).z) + sizeof v / sizeof *v;
  p = v; p++->x = 77; l[k++] = v[0].x; l[k++] = p - v; (++p)->y += 2; l[k++] = v[2].y; l[k++] = (*p--).n[1].b; l[k++] = (&p[1])->x + p[1].z;
}
void plc2() { }
