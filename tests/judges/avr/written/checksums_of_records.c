// Records packed from bytes and unpacked again, checksums that run over them, little and big ends.
// shows: bytes unsigned char 16, out long 16
// sets: R[0] 1, R[1] 2, R[2] 131, R[3] 4, R[4] 255, R[5] 128
// sets: R[0] 255, R[1] 255, R[2] 255, R[3] 127, R[4] 0, R[5] 1
typedef struct { unsigned char kind; int x; unsigned long id; char tail[2]; } record;
record r, s;
unsigned char bytes[16];
long out[16];
unsigned long big(unsigned char *p) { return (unsigned long) p[0] << 24 | (unsigned long) p[1] << 16 | p[2] << 8 | p[3]; }
unsigned long wrong(unsigned char *p) { return p[3] << 8 | p[2] | p[1] * 256 * 256 | p[0] << 8 * 1L; }
void put(unsigned char *p, unsigned long v) { int i; for (i = 3; i >= 0; i--) { p[i] = v; v >>= 8; } }
unsigned sum(unsigned char *p, int n) { unsigned s = 0; while (n-- > 0) s = (s << 1 | s >> 15) + *p++; return s; }
unsigned char lrc(unsigned char *p, unsigned char n) { char c = 0; for (; n > 0; n--, p++) c += *p; return -c; }
void init() { plc1_time = 1; plc2_time = 1; }
void plc1()
{
  int k = 0;
  r.kind = R[5]; r.x = R_i[1]; r.id = big(&R[0]); r.tail[0] = R[2]; r.tail[1] = r.tail[0]++ + 1; s = r; s.x = -s.x; s.id = ~s.id;
  put(bytes, r.id); put(&bytes[5], s.x); put(bytes + 10, s.kind * s.kind);
  out[k++] = big(R); out[k++] = big(&R[2]) >> 1; out[k++] = wrong(R + 1); out[k++] = sum((unsigned char *) &r, sizeof r); out[k++] = sum((unsigned char *) &s, sizeof(record)); out[k++] = lrc(R, 6); out[k++] = lrc(bytes, 16);
  out[k++] = r.tail[1] - s.tail[1]; out[k++] = *(unsigned *) &bytes[1]; out[k++] = *(long *) (bytes + 6); out[k++] = ((record *) &R[0])->x; out[k++] = ((record *) R)->id % 1000; out[k++] = (r.id > s.id) + (r.x > s.x) * 2 + (r.tail[0] > s.kind) * 4;
}
void plc2() { }
