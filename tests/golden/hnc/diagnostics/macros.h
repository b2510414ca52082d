#define LIGHT(n) \
    Y[0] = nothing + n;
