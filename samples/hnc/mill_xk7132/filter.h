/*
 * filter.h - two equal samples in a row make a level; its rising edge lasts for one scan
 */

static unsigned char previous[INPUTS];
static unsigned char scans_read;  /* 2 when levels count: one scan alone says nothing */

void read_inputs()
{
    int g;

    if (scans_read < 2)
        scans_read++;
    for (g = 0; g < INPUTS; g++) {
        unsigned char steady_on = X[g] & previous[g];
        unsigned char steady_off = ~X[g] & ~previous[g];
        unsigned char level = (sample[g] | steady_on) & ~steady_off;

        pressed[g] = level & ~sample[g];
        sample[g] = level;
        previous[g] = X[g];
    }
}
