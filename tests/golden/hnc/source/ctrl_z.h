#define NINE 9
#error not read
