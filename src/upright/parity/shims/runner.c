/* An AVR in simavr, driven over stdin and stdout:
     W address length bytes    write into its memory
     R address length          read from it
     G address                 run until the byte there is zero; answers the cycles that took
   Numbers are 32 bits, cycles 64, all in this machine's order. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include <simavr/sim_avr.h>
#include <simavr/sim_elf.h>

#define LONGEST 16000000ull /* cycles: a second */

static uint32_t number(void)
{
    uint32_t n;
    if (fread(&n, sizeof n, 1, stdin) != 1)
        exit(0);
    return n;
}

static uint64_t run(avr_t *avr, uint32_t flag)
{
    const uint64_t start = avr->cycle;
    while (avr->data[flag] && avr->cycle - start < LONGEST) {
        const int state = avr_run(avr);
        if (state == cpu_Done || state == cpu_Crashed)
            return UINT64_MAX;
    }
    return avr->data[flag] ? UINT64_MAX : avr->cycle - start;
}

int main(int argc, char **argv)
{
    FILE *answers = fdopen(dup(1), "wb");
    elf_firmware_t firmware;
    dup2(2, 1); /* simavr talks on stdout */
    avr_t *avr = avr_make_mcu_by_name("atmega328p");
    memset(&firmware, 0, sizeof firmware);
    if (argc != 2 || !avr || elf_read_firmware(argv[1], &firmware))
        return 1;
    avr_init(avr);
    avr->frequency = 16000000;
    avr->log = 0;
    firmware.frequency = 16000000;
    avr_load_firmware(avr, &firmware);
    for (;;) {
        const int what = getchar();
        if (what == EOF)
            return 0;
        const uint32_t address = number();
        if (what == 'G') {
            const uint64_t cycles = run(avr, address);
            fwrite(&cycles, sizeof cycles, 1, answers);
        } else {
            const uint32_t length = number();
            if (address + length > avr->ramend + 1u)
                return 1;
            if (what == 'W' && fread(avr->data + address, 1, length, stdin) != length)
                return 1;
            if (what == 'R')
                fwrite(avr->data + address, 1, length, answers);
        }
        fflush(answers);
    }
}
