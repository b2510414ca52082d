#pragma once
extern "C" int rtapi_app_main(void);
extern "C" void rtapi_app_exit(void);
