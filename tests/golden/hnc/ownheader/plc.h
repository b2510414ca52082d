#define LOCAL 77
extern unsigned char Y[];
