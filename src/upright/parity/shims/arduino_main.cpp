/* Runs a sketch whenever a number is written into `go`: 1 is setup, 2 and 3 are one period of loop. */
#include "Arduino.h"

volatile unsigned char go = 1;
volatile int16_t stub_gyro, stub_battery, stub_pwm[20];
volatile uint8_t stub_pin[20], stub_button;
volatile uint32_t stub_time;

#include "balance.ino"

int main(void)
{
    for (;;) {
        if (go == 1)
            setup();
        else {
            stub_time += UPRIGHT_PERIOD_US;
            loop();
        }
        go = 0;
        while (!go)
            ;
    }
}
