/*
 * panel.h - operating modes, keys of the part program, overrides, lamps
 */

static unsigned char single_block, dry_run, coolant_wanted;

/* The mode goes to the NC only while no axis is moved by hand: a change in between would leave it running. */
void select_mode()
{
    unsigned mode = MODE_SWITCH;
    int a;

    if (mode == (*ch_ctrl(0) & CH_MODE_MSK))
        return;
    if (mode > MODE_REF_RETURN)
        return;
    for (a = 0; a < AXES; a++) {
        if (!get_axis_den(a)) {
            set_axis_stop(a);
            return;
        }
    }
    *ch_ctrl(0) = *ch_ctrl(0) & ~CH_MODE_MSK | mode;
}

void mode_lamps()
{
    unsigned mode = *ch_ctrl(0) & CH_MODE_MSK;
    unsigned char lamps = 0;
    int a;

    if (mode != 0)
        lamps = 1 << (mode - 1);
    for (a = 0; a < AXES; a++)
        if (*axis_stat(a) & AX_COORD_SETUP)
            lamps |= 0x20 << a;
    Y[1] = lamps;
}

void program_keys()
{
    int automatic = (*ch_ctrl(0) & CH_MODE_MSK) == MODE_AUTO;

    if (HIT_SINGLE)
        single_block = !single_block;
    if (HIT_DRY && !(*ch_stat(0) & CH_CYCLE_LAMP))
        dry_run = !dry_run;

    if (single_block)
        *ch_ctrl(0) |= CH_SGL_BLK;
    else
        *ch_ctrl(0) &= ~CH_SGL_BLK;
    if (dry_run)
        *ch_ctrl(0) |= CH_DRY_RUN;
    else
        *ch_ctrl(0) &= ~CH_DRY_RUN;

    if (KEY_START && automatic && machine_on && alarms == 0 && DOOR_CLOSED)
        *ch_ctrl(0) |= CH_CYCLE_SW;
    else
        *ch_ctrl(0) &= ~CH_CYCLE_SW;

    if (KEY_HOLD || alarms & ALARM_STOPS)
        *ch_ctrl(0) |= CH_FEEDHOLD_SW;
    else
        *ch_ctrl(0) &= ~CH_FEEDHOLD_SW;

    /* M00, and M01 when single block is on: stop as with the key; the next start goes on. */
    if (mod_m00_m01(0) & CH_M00 || mod_m00_m01(0) & CH_M01 && single_block) {
        *ch_ctrl(0) |= CH_FEEDHOLD_SW;
        *ch_ctrl(0) &= ~CH_CYCLE_SW;
    }
    if (mod_m00_m01(0) & (CH_M00 | CH_M01))
        mod_m00_m01(0) &= ~(CH_M00 | CH_M01);
}

void overrides()
{
    *ch_feedover(0) = FEED_SWITCH * 10;
    *ch_rapidover(0) = FEED_SWITCH > 10 ? 100 : FEED_SWITCH * 10;
}

void panel_lamps()
{
    put_y(0, 0, *ch_stat(0) & CH_CYCLE_LAMP);
    put_y(0, 1, *ch_stat(0) & CH_FEEDHOLD_LAMP);
    put_y(0, 2, single_block);
    put_y(0, 3, dry_run);
    put_y(0, 4, coolant_on);
    put_y(0, 5, spindle_state == SPINDLE_CW || spindle_state == SPINDLE_CCW);
    put_y(0, 6, alarms != 0);
}
