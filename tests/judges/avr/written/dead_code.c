// Code that is never reached with labels, loops and cases in it; returns in front of everything.
// shows: o int 20
// sets: X[0] 0
// sets: X[0] 1
// sets: X[0] 4
int o[20];
static int first(int v) { int i; if (v) return 1; goto end; for (i = 0; i < 3; i++) v += i; dead: v = 9; if (v < 0) goto dead2; goto end; dead2: v = 10; goto dead3; dead3: ; end: return v + 2; }
static int second(int v) { switch (v) { return 5; case 0: return 6; v = 3; case 1: v = 4; break; v = 5; l: case 4: v += 10; if (v < 0) goto l2; break; default: break; l2: v++; } return v; while (v) v--; return 8; }
static int third(int v) { for (;;) { if (v) break; return 3; v++; } while (1) { if (v > 3) return v; break; } do { v += 2; break; v += 4; } while (v < 100); return v; }
static void fourth(int v) { if (v) { o[10]++; return; o[11]++; } else { return; } o[12]++; }
static int fifth(int v) { { return v + 1; { v++; } } lab: return 0; }
static int sixth(int v) { if (0) { x: v += 5; goto y; } if (v == 4) goto x; v++; y: while (0) { v += 100; } for (; 0; ) v += 1000; if (1) { if (v > 50) goto z; } else { z: v -= 3; } return v; }
void init() { plc1_time = 1; plc2_time = 1; }
void plc1() { int k = 0, v = X[0]; o[k++] = first(v); o[k++] = second(v); o[k++] = third(v); fourth(v); o[k++] = fifth(v); o[k++] = sixth(v); if (!v) return; o[k++] = 7; if (v > 2) { return; } o[k++] = 8; }
void plc2() { return; }
