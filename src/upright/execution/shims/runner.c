/* An AVR in simavr, driven over stdin and stdout:
     W address length bytes    write into its memory
     R address length          read from it
     G address                 run until the byte there is zero; answers the cycles that took
   and for a sketch, whose loop begins a period by changing the four bytes at `due`:
     A due loop count          where `due`, the code of `loop` and the core's count of timer overflows are
     I what value              an input of the board
     P leap                    run a period: until `loop` returns after a change of `due`; answers when it began, and the
                               cycles that took; with `leap` the core's clock leaps over the wait for it
     T cycles                  run for so long; answers the time then
     S                         answers what came over the serial port: its length, its bytes
   Numbers are 32 bits, cycles 64, all in this machine's order. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include <simavr/sim_avr.h>
#include <simavr/sim_elf.h>
#include "board.h"

#define LONGEST 16000000ull /* cycles: a second */
#define TCNT0 0x46
#define OVERFLOW 1024 /* [us] from one overflow of the core's timer to the next */

static uint32_t due, loop, overflows;

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

static uint32_t word(avr_t *avr, uint32_t at)
{
    uint32_t value;
    memcpy(&value, avr->data + at, sizeof value);
    return value;
}

static void leap(avr_t *avr)
{
    const uint32_t now = ((word(avr, overflows) << 8) + avr->data[TCNT0]) * 4;
    const int32_t rest = word(avr, due) - now;
    if (rest > 2 * OVERFLOW) {
        const uint32_t count = word(avr, overflows) + rest / OVERFLOW - 1;
        memcpy(avr->data + overflows, &count, sizeof count);
    }
}

static void period(avr_t *avr, int leaping, uint64_t *began, uint64_t *took)
{
    const uint64_t start = avr->cycle;
    const uint32_t before = word(avr, due);
    *began = *took = UINT64_MAX;
    while (turning())
        if (!board_run())
            return;
    if (leaping)
        leap(avr);
    while (word(avr, due) == before)
        if (!board_run() || avr->cycle - start > LONGEST)
            return;
    *began = avr->cycle;
    while (avr->pc != loop)
        if (!board_run() || avr->cycle - start > LONGEST)
            return;
    *took = avr->cycle - *began;
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
    make_board(avr);
    for (;;) {
        const int what = getchar();
        if (what == EOF)
            return 0;
        uint64_t cycles[2] = {0, 0};
        if (what == 'A') {
            due = number(), loop = number(), overflows = number();
        } else if (what == 'I') {
            const uint32_t input = number();
            set_input(input, number());
        } else if (what == 'P') {
            period(avr, number(), &cycles[0], &cycles[1]);
            fwrite(cycles, sizeof *cycles, 2, answers);
        } else if (what == 'T') {
            const uint64_t end = avr->cycle + number();
            while (avr->cycle < end && board_run())
                ;
            cycles[0] = avr->cycle;
            fwrite(cycles, sizeof *cycles, 1, answers);
        } else if (what == 'S') {
            fwrite(&board.length, sizeof board.length, 1, answers);
            fwrite(board.sent, 1, board.length, answers);
        } else if (what == 'G') {
            cycles[0] = run(avr, number());
            fwrite(cycles, sizeof *cycles, 1, answers);
        } else {
            const uint32_t address = number(), length = number();
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
