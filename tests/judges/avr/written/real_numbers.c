// Real numbers in float: conversions, comparisons, one operation at a time.
// shows: out long 20
// sets: P[0] 7, P[1] 65535, X[0] 3
// sets: P[0] 32768, P[1] 250, X[0] 200
long out[20];
float f, g, t[3] = {1.5f, -0.25f};
float half(float x) { return x * 0.5f; }
void init() { plc1_time = 1; plc2_time = 1; }
void plc1()
{
  int i = 0;
  f = P_i[0]; g = P[1]; out[i++] = f; out[i++] = (int) half(f); f *= 0.25f; out[i++] = f; out[i++] = f < g; out[i++] = f == -f; out[i++] = !f; out[i++] = f && g;
  t[2] = g; t[2] += t[0]; out[i++] = t[2]; t[2] = -t[2]; out[i++] = (long) t[2]; t[2] /= 2; out[i++] = t[2]; out[i++] = f > t[1] ? 1 : 2; out[i++] = (char) t[1];
  f = 3; f = f / 2; out[i++] = f * 2; f++; out[i++] = f > 2.25f; g = X_c[0]; out[i++] = g--; out[i++] = g; out[i++] = sizeof f + sizeof(f + 1 > 2);
  f = 16777216; f += 1; out[i++] = f; f = X[0] ? 0.5f : 1; out[i++] = f * 4; out[i++] = (f = 7 / 2) == 3.0f;
}
void plc2() { }
