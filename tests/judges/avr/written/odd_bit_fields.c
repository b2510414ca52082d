// Bit-fields in expressions: promotion, narrow stores' values, fields as counters, indices, selectors, in unions and arrays.
// shows: l long 70
// sets: X[0] 5, X[1] 2, P[0] 65535
// sets: X[0] 250, X[1] 0, P[0] 33000
struct s { unsigned a : 1; int b : 2; unsigned c : 7; int d : 9; unsigned char e : 3; char f : 5; unsigned g : 15; int h : 16; unsigned : 4; unsigned i : 12; };
struct s v[3], one; long l[70]; int t[8];
int of(struct s p) { p.c += 100; return p.c; }
int back(struct s *p) { return p->d = p->g; }
void init() { plc1_time = 1; plc2_time = 1; }
void plc1()
{
  int k = 0, n; struct s *p = &v[X[1]]; struct s z;
  l[k++] = one.a = X[0]; l[k++] = one.b = X[0]; l[k++] = one.c = P[0]; l[k++] = one.d = P[0]; l[k++] = one.e = X[0]; l[k++] = one.f = X[0]; l[k++] = one.g = P[0]; l[k++] = one.h = P[0]; l[k++] = one.i = P[0];
  l[k++] = one.a - 2; l[k++] = one.c - 200 < 0; l[k++] = one.g - 32767 - 1 < 0; l[k++] = one.i << 4; l[k++] = one.g << 1; l[k++] = one.h >> 4; l[k++] = ~one.e; l[k++] = -one.i; l[k++] = one.g * 2; l[k++] = one.c * one.i; l[k++] = one.b < one.a; l[k++] = one.h > one.g;
  l[k++] = one.a + one.b + one.c + one.d + one.e + one.f; *p = one; l[k++] = p->b++; l[k++] = p->b; l[k++] = --p->b; l[k++] = p->d += 255; l[k++] = p->d -= 300; l[k++] = p->e *= 3; l[k++] = p->f <<= 2; l[k++] = p->g >>= 3; l[k++] = p->i |= 0xF000; l[k++] = p->i ^= 0xFFF; l[k++] = p->a ^= 1; l[k++] = p->h /= 3; l[k++] = p->h %= 7; l[k++] = p->c += p->d; l[k++] = p->c -= 200;
  l[k++] = of(*p); l[k++] = p->c; l[k++] = back(p); l[k++] = p->d; l[k++] = p->a ? p->d : p->i; l[k++] = p->a && p->b || !p->e; l[k++] = (p->e, p->f);
  one.e = 0;
  //@loop_bound 7
  for (n = 0; one.e < 6; one.e++) n += t[one.e] = one.e * 3; l[k++] = n; l[k++] = t[one.e - 1];
  switch (one.b) { case -2: n = 1; break; case -1: n = 2; break; case 0: n = 3; break; case 1: n = 4; } l[k++] = n;
  switch (one.e) { case 6: n = 66; break; default: n = 0; } l[k++] = n;
  z = v[X[1]]; z.a = z.b = z.c = z.d = -1; l[k++] = z.a; l[k++] = z.b; l[k++] = z.c; l[k++] = z.d; l[k++] = v[X[1]].c; z.e = z.f = z.g; l[k++] = z.e; l[k++] = z.f;
  { struct s init = { 1, -1, 127, -256, 7, -16, 32767, -1, 4095 }; static struct s st = { 1, 1, 1 }; l[k++] = init.b + init.c + init.d + init.e + init.f; l[k++] = init.g + init.h; l[k++] = init.i; st.c += 50; l[k++] = st.c; l[k++] = st.d; }
  l[k++] = (one.g + 1u) > 0; l[k++] = (one.h + 0u) / 2;
}
void plc2() { }
