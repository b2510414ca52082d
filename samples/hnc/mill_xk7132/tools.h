/*
 * tools.h - umbrella magazine with 12 pockets: T selects, M06 changes
 *
 * The magazine moves to the spindle, takes the tool, turns to the pocket of the wanted one and moves back. The NC has
 * brought Z to the height of the change and does the strokes between the steps itself.
 */

enum { CHANGE_IDLE, CHANGE_ORIENT, CHANGE_OUT, CHANGE_OPEN, CHANGE_RISE, CHANGE_TURN, CHANGE_CLOSE, CHANGE_BACK,
       CHANGE_DONE };

static unsigned char change_state;
static unsigned change_scans;
static int target_pocket;

/* The pocket of a tool, 1..12, or 0. */
int pocket_of(int tool)
{
    int p;

    for (p = 0; p < POCKETS; p++)
        if (*cutter_in_mag(p) == tool)
            return p + 1;
    return 0;
}

void on_t(int ch)
{
    int tool = mod_T_code(ch);

    if (tool != tool_in_spindle && pocket_of(tool) == 0) {
        alarms |= ALARM_TOOL;
        return;  /* stays busy until reset withdraws the request */
    }
    wanted_tool = tool;
    mod_T_code(ch) = -1;
}

void begin_change()
{
    if (change_state != CHANGE_IDLE)
        return;
    change_scans = 0;
    if (wanted_tool == tool_in_spindle) {
        change_state = CHANGE_DONE;
        return;
    }
    target_pocket = pocket_of(wanted_tool);
    change_state = CHANGE_ORIENT;
}

void next_step(int state)
{
    change_state = state;
    change_scans = 0;
}

/* Turns the shorter way round: pockets ahead in the positive direction. */
int positive_turn()
{
    int ahead = (target_pocket - pocket_in_front + POCKETS) % POCKETS;

    return ahead <= POCKETS / 2;
}

void count_pockets()
{
    if (!HIT_POCKET)
        return;
    if (Y[3] & 0x01)
        pocket_in_front = pocket_in_front % POCKETS + 1;
    else if (Y[3] & 0x02)
        pocket_in_front = pocket_in_front > 1 ? pocket_in_front - 1 : POCKETS;
}

void stop_magazine()
{
    Y_MAG_OUT(0);
    Y_MAG_BACK(0);
    Y_MAG_CW(0);
    Y_MAG_CCW(0);
}

void tool_change()
{
    int turning = 0;

    count_pockets();
    if (change_state == CHANGE_IDLE) {
        Y_UNCLAMP(KEY_UNCLAMP && spindle_state == SPINDLE_STOPPED && machine_on);
        return;
    }
    if (change_state < CHANGE_DONE && ++change_scans > step_limit && step_limit != 0)
        alarms |= ALARM_CHANGE;
    if (alarms & ALARM_CHANGE || !machine_on) {
        stop_magazine();
        return;
    }

    switch (change_state) {
        case CHANGE_ORIENT:
            start_spindle(SPINDLE_ORIENT);
            if (!ORIENTED)
                break;
            next_step(CHANGE_OUT);
            /* falls through: the magazine moves in the same scan */
        case CHANGE_OUT:
            Y_MAG_BACK(0);
            Y_MAG_OUT(1);
            if (MAG_FRONT)
                next_step(CHANGE_OPEN);
            break;
        case CHANGE_OPEN:
            Y_UNCLAMP(1);
            if (UNCLAMPED)
                next_step(CHANGE_RISE);
            break;
        case CHANGE_RISE:  /* the spindle leaves the tool: 20 scans */
            if (change_scans < 20)
                break;
            if (tool_in_spindle != 0)
                *cutter_in_mag(pocket_in_front - 1) = tool_in_spindle;
            tool_in_spindle = 0;
            next_step(CHANGE_TURN);
            break;
        case CHANGE_TURN:
            turning = pocket_in_front != target_pocket;
            Y_MAG_CW(turning && positive_turn());
            Y_MAG_CCW(turning && !positive_turn());
            if (turning)
                break;
            tool_in_spindle = *cutter_in_mag(target_pocket - 1);
            *cutter_in_mag(target_pocket - 1) = 0;
            next_step(CHANGE_CLOSE);
            break;
        case CHANGE_CLOSE:
            Y_UNCLAMP(0);
            if (CLAMPED)
                next_step(CHANGE_BACK);
            break;
        case CHANGE_BACK:
            Y_MAG_OUT(0);
            Y_MAG_BACK(1);
            if (!MAG_HOME)
                break;
            Y_MAG_BACK(0);
            start_spindle(SPINDLE_STOPPED);
            next_step(CHANGE_DONE);
            break;
        default:  /* CHANGE_DONE: M06 ends it */
            break;
    }
}
