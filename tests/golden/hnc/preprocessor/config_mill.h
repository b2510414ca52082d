#define TOOLS 7
