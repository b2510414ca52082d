/*
 * spindle.h - speed, directions, orientation
 *
 * Handlers of M03, M04, M05, M19 are in mcodes.h; keys act in the manual modes only.
 */

#define DAC_FULL 4095

static unsigned char at_speed_scans;

int speed_percent()
{
    return 50 + 10 * SPEED_SWITCH;
}

void start_spindle(int state)
{
    if (spindle_state != state)
        at_speed_scans = 0;
    spindle_state = state;
}

void spindle_keys()
{
    int mode = *ch_ctrl(0) & CH_MODE_MSK;

    if (mode == MODE_AUTO)
        return;
    if (HIT_SPINDLE && CLAMPED && machine_on)
        start_spindle(SPINDLE_CW);
    if (HIT_SP_STOP)
        start_spindle(SPINDLE_STOPPED);
}

void spindle()
{
    long dac = 0;

    spindle_keys();
    if (!machine_on || !CLAMPED && spindle_state != SPINDLE_ORIENT)
        start_spindle(SPINDLE_STOPPED);

    switch (spindle_state) {
        case SPINDLE_CW:
        case SPINDLE_CCW:
            if (top_speed > 0)
                dac = (long) spindle_speed * speed_percent() / 100 * DAC_FULL / top_speed;
            if (dac > DAC_FULL)
                dac = DAC_FULL;
            if (SP_AT_SPEED && at_speed_scans < 100)
                at_speed_scans++;
            break;
        default:
            at_speed_scans = 0;
    }
    SPINDLE_DAC = (unsigned) dac;
    *ch_spdl_speed(0) = dac > 0 ? spindle_speed : 0;

    Y_SP_CW(spindle_state == SPINDLE_CW);
    Y_SP_CCW(spindle_state == SPINDLE_CCW);
    Y_ORIENT(spindle_state == SPINDLE_ORIENT);
}

/* S word: rev/min, limited by the parameter; a negative one is a fault of the part program and counts as 0. */
void on_s(int ch)
{
    spindle_speed = limited(mod_S_code(ch), 0, top_speed);
    mod_S_code(ch) = -1;
}
