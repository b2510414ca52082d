/*
 * machine.h - power, alarms, coolant, lubrication
 */

/* Emergency stop acts on the raw input, at once and without the filter. */
void power()
{
    if (!ESTOP_OK) {
        alarms |= ALARM_ESTOP;
        *ch_ctrl(0) |= CH_ESTOP;
        *sys_ctrl() |= SYS_ESTOP;
    } else {
        *ch_ctrl(0) &= ~CH_ESTOP;
        *sys_ctrl() &= ~SYS_ESTOP;
    }

    if (HIT_RESET) {
        alarms &= ALARM_LIMIT;
        change_state = CHANGE_IDLE;
        stop_magazine();
        *ch_ctrl(0) |= CH_RESET;
    } else {
        *ch_ctrl(0) &= ~CH_RESET;
    }

    machine_on = ESTOP_OK && !(alarms & ALARM_ESTOP);
    Y_ENABLE(machine_on);
}

void watch()
{
    static unsigned char drive_scans;

    if (scans_read < 2)
        return;
    /* Drives need a second after they are enabled: 60 scans. */
    if (!machine_on || DRIVES_OK && SP_READY)
        drive_scans = 0;
    else if (drive_scans < 60)
        drive_scans++;
    if (drive_scans == 60) {
        if (!DRIVES_OK)
            alarms |= ALARM_DRIVES;
        if (!SP_READY)
            alarms |= ALARM_SPINDLE;
    }
    if (!AIR_OK)
        alarms |= ALARM_AIR;
    if (!OIL_OK)
        alarms |= ALARM_OIL;
    if (!COOLANT_OK)
        alarms |= ALARM_COOLANT;
}

void coolant()
{
    if (HIT_COOLANT)
        coolant_wanted = !coolant_wanted;
    coolant_on = coolant_wanted && machine_on && !(alarms & ALARM_COOLANT);
    Y_COOLANT(coolant_on);
}

/* In the slow part: seconds from scans of 32 ms (31.25 of them, so 125 scans are four seconds). */
void lubrication()
{
    static unsigned char quarter;
    static unsigned seconds;
    static unsigned char pumping = 1;
    unsigned limit;

    if (!machine_on) {
        Y_LUBE(0);
        clr_y(0, 7);
        return;
    }
    quarter += 4;
    if (quarter >= 125) {
        quarter -= 125;
        seconds++;
    }
    limit = pumping ? lube_on_s : lube_off_s;
    if (limit != 0 && seconds >= limit) {
        seconds = 0;
        pumping = !pumping;
    }
    Y_LUBE(pumping && !(alarms & ALARM_OIL));
    put_y(0, 7, pumping || alarms & ALARM_OIL);
}

/* Half a second on, half a second off, while there is an alarm. */
void buzzer()
{
    static unsigned char scans;

    scans = alarms ? (scans + 1) % 32 : 0;
    Y_BUZZER(scans >= 1 && scans <= 16);
}
