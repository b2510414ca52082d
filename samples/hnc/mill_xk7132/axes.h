/*
 * axes.h - enabling, limit switches, jog, steps, handwheel, reference
 */

static unsigned char jogging[AXES], homing[AXES];

/* Bits 2a and 2a + 1 of LIMITS are the switches at the positive and the negative end; 0 is pressed. */
void limit_switches()
{
    int a, pressed_ends = 0;

    for (a = 0; a < AXES; a++) {
        unsigned ends = ~LIMITS >> 2 * a & 0x03;

        *axis_ctrl(a) &= ~(AX_LSP | AX_LSN | AX_DISABLE_P | AX_DISABLE_N);
        if (ends & 1)
            *axis_ctrl(a) |= AX_LSP | AX_DISABLE_P;
        if (ends & 2)
            *axis_ctrl(a) |= AX_LSN | AX_DISABLE_N;
        if (ends)
            pressed_ends++;

        if (HOME_SWITCH(a))
            *axis_ctrl(a) |= AX_HOME_SW;
        else
            *axis_ctrl(a) &= ~AX_HOME_SW;
    }
    if (pressed_ends)
        alarms |= ALARM_LIMIT;
    else
        alarms &= ~ALARM_LIMIT;
}

/* -1, 0 or 1: both keys of an axis together are none, and a pressed end lets the axis move away from it only. */
int direction(int a)
{
    int d = 0;

    if (JOG_PLUS(a) && !JOG_MINUS(a))
        d = 1;
    else if (JOG_MINUS(a) && !JOG_PLUS(a))
        d = -1;
    if (d > 0 && *axis_ctrl(a) & AX_LSP)
        d = 0;
    if (d < 0 && *axis_ctrl(a) & AX_LSN)
        d = 0;
    return d;
}

void jog(int a)
{
    int d = direction(a);
    int speed = KEY_RAPID && *axis_stat(a) & AX_COORD_SETUP ? rapid_speed : jog_speed;

    if (d != 0) {
        set_axis_jog(a, (int) ((long) speed * *ch_feedover(0) / 100) * d);
        jogging[a] = 1;
    } else if (jogging[a]) {
        set_axis_stop(a);
        jogging[a] = 0;
    }
}

void step(int a)
{
    if (!get_axis_den(a))
        return;  /* the step before it is still under way */
    if (HIT_PLUS(a) && !(*axis_ctrl(a) & AX_LSP))
        set_axis_step(a, (long) step_width);
    else if (HIT_MINUS(a) && !(*axis_ctrl(a) & AX_LSN))
        set_axis_step(a, -(long) step_width);
}

/* Z first: the other axes wait until it has its reference. */
void reference(int a)
{
    int z_ready = *axis_stat(2) & AX_COORD_SETUP;

    if (homing[a]) {
        if (*axis_stat(a) & AX_HOME_FIN) {
            set_axis_home(a, 0);
            homing[a] = 0;
        }
    } else if (HIT_PLUS(a) && (a == 2 || z_ready)) {
        set_axis_home(a, 1);
        homing[a] = 1;
    }
}

void stop_axes()
{
    int a;

    for (a = 0; a < AXES; a++) {
        if (jogging[a] || homing[a] || !get_axis_den(a))
            set_axis_stop(a);
        jogging[a] = homing[a] = 0;
    }
}

void wheel()
{
    static const int factors[] = {1, 10, 100, 100};
    int a = WHEEL_AXIS;

    if (a < AXES)
        handwheel(0, a, factors[WHEEL_MUL]);
    else
        get_handwheel(0);
}

void axes()
{
    unsigned mode = *ch_ctrl(0) & CH_MODE_MSK;
    int a;

    limit_switches();
    if (!machine_on) {
        stop_axes();
        get_handwheel(0);
        return;
    }
    if (mode == MODE_HANDWHEEL)
        wheel();
    else
        get_handwheel(0);  /* turned in another mode: forget it */

    for (a = 0; a < AXES; a++) {
        switch (mode) {
            case MODE_JOG:
                jog(a);
                break;
            case MODE_STEP:
                step(a);
                break;
            case MODE_REF_RETURN:
                reference(a);
                break;
            default:
                break;
        }
    }
}
