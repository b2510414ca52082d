/*
 * io.h - 输入输出点表
 * 三坐标数控铣床，斗笠式刀库 12 个刀位。所有输入均为高电平有效，行程开关为常闭。
 */

/* ---- 位操作宏 ---- */
#define in(g,b)    (X[g] & (1<<(b)))             /* 原始输入 */
#define on(g,b)    (sample[g] & (1<<(b)))        /* 滤波后的输入 */
#define hit(g,b)   (pressed[g] & (1<<(b)))       /* 滤波后的上升沿，只保持一个扫描周期 */
#define set_y(g,b) (Y[g] |= (1<<(b)))
#define clr_y(g,b) (Y[g] &= ~(1<<(b)))
#define put_y(g,b,c) if (c) set_y(g,b); else clr_y(g,b)

/* ---- X0: 操作面板按键 ---- */
#define KEY_START    on(0,0)    /* 循环启动 */
#define KEY_HOLD     on(0,1)    /* 进给保持 */
#define HIT_SINGLE   hit(0,2)   /* 单段 */
#define HIT_DRY      hit(0,3)   /* 空运行 */
#define HIT_RESET    hit(0,4)   /* 复位、清除报警 */
#define HIT_COOLANT  hit(0,5)   /* 冷却 开/关 */
#define HIT_SPINDLE  hit(0,6)   /* 主轴正转 */
#define HIT_SP_STOP  hit(0,7)   /* 主轴停止 */

/* ---- X1: 点动按键，低六位依次为 +X -X +Y -Y +Z -Z ---- */
#define JOG_PLUS(a)  on(1,2*(a))
#define JOG_MINUS(a) on(1,2*(a)+1)
#define HIT_PLUS(a)  hit(1,2*(a))
#define HIT_MINUS(a) hit(1,2*(a)+1)
#define KEY_RAPID    on(1,6)    /* 快移 */
#define KEY_UNCLAMP  on(1,7)    /* 手动松刀 */

/* ---- X2: 方式开关与手轮 ---- */
#define MODE_SWITCH  (sample[2] & 0x07)          /* 0 无, 1 自动, 2 点动, 3 步进, 4 手轮, 5 回零 */
#define WHEEL_AXIS   (sample[2] >> 3 & 0x03)     /* 手轮轴选择 */
#define WHEEL_MUL    (sample[2] >> 6 & 0x03)     /* 手轮倍率 x1 x10 x100 */

/* ---- X3: 修调开关 ---- */
#define FEED_SWITCH  (X[3] & 0x0F)               /* 进给修调，每档 10% */
#define SPEED_SWITCH (X[3] >> 4 & 0x07)          /* 主轴修调 50% .. 120% */

/* ---- X4: 机床状态 ---- */
#define ESTOP_OK     in(4,0)    /* 急停按钮未按下 */
#define DRIVES_OK    on(4,1)    /* 伺服就绪 */
#define SP_READY     on(4,2)    /* 主轴驱动就绪 */
#define SP_AT_SPEED  on(4,3)    /* 主轴速度到达 */
#define AIR_OK       on(4,4)    /* 气压正常 */
#define OIL_OK       on(4,5)    /* 润滑油位正常 */
#define COOLANT_OK   on(4,6)    /* 冷却电机未过载 */
#define DOOR_CLOSED  on(4,7)    /* 防护门关闭 */

/* ---- X5: 行程开关（常闭），X6: 回零开关 ---- */
#define LIMITS       X[5]
#define HOME_SWITCH(a) in(6,a)

/* ---- X7: 刀库 ---- */
#define MAG_FRONT    on(7,0)    /* 刀库在主轴侧 */
#define MAG_HOME     on(7,1)    /* 刀库在原位 */
#define CLAMPED      on(7,2)    /* 刀具夹紧 */
#define UNCLAMPED    on(7,3)    /* 刀具松开 */
#define HIT_POCKET   hit(7,4)   /* 刀位计数脉冲 */
#define ORIENTED     on(7,6)    /* 主轴定向到位 */

#define INPUTS 8                /* 使用的输入组数 */

/* ---- Y0: 指示灯 ---- */
#define LAMP_CYCLE   0,0
#define LAMP_HOLD    0,1
#define LAMP_SINGLE  0,2
#define LAMP_DRY     0,3
#define LAMP_COOLANT 0,4
#define LAMP_SPINDLE 0,5
#define LAMP_ALARM   0,6
#define LAMP_LUBE    0,7

/* Y1: 低五位方式灯，高三位回零灯；Y2、Y3: 执行元件；Y4、Y5: 主轴模拟量 0..4095 */
#define Y_ENABLE(c)   put_y(2,0,c)   /* 伺服使能 */
#define Y_SP_CW(c)    put_y(2,1,c)   /* 主轴正转 */
#define Y_SP_CCW(c)   put_y(2,2,c)   /* 主轴反转 */
#define Y_ORIENT(c)   put_y(2,3,c)   /* 主轴定向 */
#define Y_COOLANT(c)  put_y(2,4,c)   /* 冷却泵 */
#define Y_LUBE(c)     put_y(2,5,c)   /* 润滑泵 */
#define Y_MAG_OUT(c)  put_y(2,6,c)   /* 刀库向主轴 */
#define Y_MAG_BACK(c) put_y(2,7,c)   /* 刀库回原位 */
#define Y_MAG_CW(c)   put_y(3,0,c)   /* 刀盘正转 */
#define Y_MAG_CCW(c)  put_y(3,1,c)   /* 刀盘反转 */
#define Y_UNCLAMP(c)  put_y(3,2,c)   /* 松刀阀 */
#define Y_BUZZER(c)   put_y(3,4,c)   /* 蜂鸣器 */
#define SPINDLE_DAC   Y_ui[4/2]
