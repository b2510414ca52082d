/*
 * mcodes.h - M functions of channel 0
 *
 * The handler is called in every scan until it sets the code to -1.
 */

void spindle_code(int ch, int state)
{
    if (alarms & ALARM_SPINDLE)
        return;
    start_spindle(state);
    if (state == SPINDLE_STOPPED || spindle_speed == 0 || at_speed_scans >= 2)
        mod_M_code(ch) = -1;
}

void on_m(int ch)
{
    switch (mod_M_code(ch)) {
        case 3:
            spindle_code(ch, SPINDLE_CW);
            break;
        case 4:
            spindle_code(ch, SPINDLE_CCW);
            break;
        case 5:
            spindle_code(ch, SPINDLE_STOPPED);
            break;
        case 6:
            begin_change();
            if (change_state == CHANGE_DONE) {
                change_state = CHANGE_IDLE;
                mod_M_code(ch) = -1;
            }
            break;
        case 8:
            coolant_wanted = 1;
            mod_M_code(ch) = -1;
            break;
        case 2:
        case 30:  /* end of the part program */
            spindle_code(ch, SPINDLE_STOPPED);
            /* falls through: coolant off as with M09 */
        case 9:
            coolant_wanted = 0;
            mod_M_code(ch) = -1;
            break;
        case 19:
            start_spindle(SPINDLE_ORIENT);
            if (ORIENTED)
                mod_M_code(ch) = -1;
            break;
        default:  /* M00, M01 and codes that the machine does not have */
            mod_M_code(ch) = -1;
    }
}

/* The NC starts in the middle of a part program: what the machine is doing must be asked for again. */
void on_modal(int ch)
{
    if (ch == 0 && spindle_state == SPINDLE_ORIENT)
        start_spindle(SPINDLE_STOPPED);
}
