/*
 * state.h - parameters, alarms and the variables that several groups share
 *
 * User parameters (P), set on the control:
 *   P[0] jog speed      P[1] rapid speed     P[2] step width in micrometres
 *   P[4] highest speed of the spindle, rev/min       P[5] longest time of a tool change step, scans of 16 ms
 *   P[8] lubrication on, seconds                     P[9] lubrication pause, seconds
 * Retentive (B): B[0] number of pockets, B[1]..B[12] tools in the pockets, B[90] tool in the spindle, B[91] pocket in
 * front of the spindle.
 */

#define AXES 3
#define POCKETS 12

#define jog_speed   P_i[0]
#define rapid_speed P_i[1]
#define step_width  P_i[2]
#define top_speed   P_i[4]
#define step_limit  P[5]
#define lube_on_s   P[8]
#define lube_off_s  P[9]

#define tool_in_spindle B_i[90]
#define pocket_in_front B_i[91]

/* Alarms of the machine: bit n - 1 of the word raises alarm n. */
#define ALARM_ESTOP   0x0001  /* emergency stop pressed */
#define ALARM_DRIVES  0x0002  /* servo drives not ready */
#define ALARM_AIR     0x0004  /* air pressure too low */
#define ALARM_OIL     0x0008  /* lubrication oil used up */
#define ALARM_COOLANT 0x0010  /* coolant motor overloaded */
#define ALARM_TOOL    0x0020  /* no such tool */
#define ALARM_CHANGE  0x0040  /* a step of the tool change took too long */
#define ALARM_SPINDLE 0x0080  /* spindle drive not ready */
#define ALARM_LIMIT   0x0100  /* an axis stands on its limit switch */

/* These stop the machine; the others only prevent a start. */
#define ALARM_STOPS (ALARM_ESTOP | ALARM_DRIVES | ALARM_SPINDLE)

#define alarms (*sys_ext_alm())

enum { SPINDLE_STOPPED, SPINDLE_CW, SPINDLE_CCW, SPINDLE_ORIENT };

unsigned char sample[INPUTS], pressed[INPUTS];

static unsigned char machine_on, coolant_on;
static unsigned char spindle_state;
static int spindle_speed;
static int wanted_tool;

int limited(int value, int low, int high)
{
    if (value < low)
        return low;
    if (value > high)
        return high;
    return value;
}
