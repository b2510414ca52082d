// Structs in structs in arrays, unions in them, by value through functions, compared member by member.
// shows: out int 24
// sets: X[0] 1, P[0] 300
// sets: X[0] 2, P[0] 65280
typedef struct { int x, y; } point;
typedef struct { point from, to; unsigned char kind; union { long all; unsigned char b[4]; int half[2]; } data; } segment;
struct machine { segment path[3]; struct { unsigned char busy : 1, error : 2; char axis : 4; } state; point home; } m = {{{{1, 2}, {3, 4}, 5}, {{6}}}, {1, 2, -3}, {7, 8}}, copy;
int out[24];
point plus(point a, point b) { a.x += b.x; a.y -= b.y; return a; }
point scaled(point a, int by) { point r; r.x = a.x * by; r.y = a.y / by; return r; }
segment moved(segment s, point by) { s.from = plus(s.from, by); s.to = plus(s.to, plus(by, by)); s.data.b[s.kind & 3]++; return s; }
int same(point a, point b) { return a.x == b.x && a.y == b.y; }
void init() { plc1_time = 1; plc2_time = 1; }
void plc1()
{
  int i = 0, k = X[0];
  segment *s = &m.path[k];
  copy = m;
  m.path[0] = moved(m.path[k], m.home); s->data.half[1] = P_i[0]; s->data.b[0] -= k; s->kind = s->data.b[3]; m.path[k].to = scaled(s->from = plus(m.home, m.path[0].to), k + 1);
  m.state.busy = ~m.state.busy; m.state.error += 2; m.state.axis = m.state.axis * 2 - k; m.home = k > 1 ? scaled(m.home, 3) : plus(m.home, s->to);
  out[i++] = m.path[0].from.x; out[i++] = m.path[0].from.y; out[i++] = m.path[0].to.x; out[i++] = m.path[0].to.y; out[i++] = m.path[0].kind; out[i++] = m.path[0].data.b[1];
  out[i++] = s->from.x; out[i++] = s->from.y; out[i++] = s->to.x; out[i++] = s->to.y; out[i++] = s->kind; out[i++] = s->data.all >> 12; out[i++] = m.state.busy * 100 + m.state.error * 10; out[i++] = m.state.axis;
  out[i++] = m.home.x; out[i++] = m.home.y; out[i++] = same(m.home, copy.home); out[i++] = same(plus(s->from, s->to), scaled(s->to, 2)); out[i++] = plus(scaled(m.home, 2), copy.home).y; out[i++] = moved(*s, m.home).data.b[1];
  out[i++] = copy.state.axis - m.state.axis; out[i++] = (k & 1 ? m : copy).path[1].to.x; out[i++] = sizeof(segment); copy.path[2] = copy.path[1] = *s; out[i++] = copy.path[2].from.x ^ copy.path[1].to.y;
}
void plc2() { }
