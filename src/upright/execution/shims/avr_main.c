/* Steps a balancing program whenever a number is written into `go`: 1 starts it anew, 2 calibrates, 3 is a period. */
#include "balance.h"

volatile unsigned char go = 1;
upright_input readings;
upright_output results;
static upright_state memory;

int main(void)
{
    for (;;) {
        if (go == 1)
            upright_reset(&memory);
        else if (go == 2)
            upright_calibrate(&memory, &readings, &results);
        else {
            upright_command(&memory, &readings, &results);
            upright_update(&memory, &readings, &results);
        }
        go = 0;
        while (!go)
            ;
    }
}
