/* What stands round an Arduino Uno in simavr: an MPU-6050, two encoders, a battery behind a divider, a button.
   `what` of an input: 0 gyro [steps], 1 battery [steps of ten bits], 2 and 3 turns of the encoders [edges], 4 button,
   5 the sensor's condition, 6 its identity, 7 its power (0 and 1: it comes back without its settings), 8 to 12 pins:
   A and B of the left encoder, of the right, the button's, 13 and 14 the accelerometer forward and up [steps]. */
#include <simavr/avr_adc.h>
#include <simavr/avr_ioport.h>
#include <simavr/avr_twi.h>
#include <simavr/avr_uart.h>
#include <simavr/sim_cycle_timers.h>
#include <simavr/sim_io.h>

#define MPU 0x68
#define EDGE 1000 /* cycles from one edge of an encoder to its next, whichever channel has it */
enum { PRESENT, ABSENT, HUNG };

static struct {
    avr_t *avr;
    avr_irq_t *bus;
    avr_io_t *twi;
    int32_t input[15], gone[2];
    uint8_t registers[128], at, selected, written;
    avr_cycle_count_t edge;
    char sent[65536];
    uint32_t length;
} board;

static void set_pin(int pin, int level)
{
    const char port = pin < 8 ? 'D' : pin < 14 ? 'B' : 'C';
    const int bit = pin < 8 ? pin : pin < 14 ? pin - 8 : pin - 14;
    avr_raise_irq(avr_io_getirq(board.avr, AVR_IOCTL_IOPORT_GETIRQ(port), bit), level);
}

/* A button wins over the chip's pull-up, which every write to its port would otherwise raise again. */
static void press(int pin, int down)
{
    avr_ioport_external_t held = {.name = pin < 8 ? 'D' : pin < 14 ? 'B' : 'C'};
    held.mask = 1 << (pin < 8 ? pin : pin < 14 ? pin - 8 : pin - 14);
    held.value = down ? 0 : held.mask;
    avr_ioctl(board.avr, AVR_IOCTL_IOPORT_SET_EXTERNAL(held.name), &held);
    set_pin(pin, !down);
}

static void power_up(void)
{
    memset(board.registers, 0, sizeof board.registers);
    board.registers[0x6B] = 0x40; /* asleep, as the data sheet has it */
}

static uint8_t answer(uint8_t where)
{
    const int awake = board.registers[0x6B] == 0 && board.registers[0x1B] == 0x08;
    if (where == 0x45 || where == 0x46)
        return !awake ? 0 : where == 0x45 ? board.input[0] >> 8 & 255 : board.input[0] & 255;
    if (where == 0x3B || where == 0x3C || where == 0x3F || where == 0x40) {
        const int32_t steps = board.input[where < 0x3F ? 13 : 14];
        return !awake ? 0 : where & 1 ? steps >> 8 & 255 : steps & 255; /* the high byte at the odd address */
    }
    return where == 0x75 ? board.input[6] : board.registers[where & 127];
}

static void on_bus(struct avr_irq_t *irq, uint32_t value, void *unused)
{
    avr_twi_msg_irq_t m;
    (void)irq, (void)unused;
    m.u.v = value;
    if (m.u.twi.msg & TWI_COND_STOP)
        board.selected = 0;
    if (m.u.twi.msg & TWI_COND_START) {
        board.selected = board.input[5] == PRESENT && m.u.twi.addr >> 1 == MPU ? m.u.twi.addr : 0;
        board.written = 0;
        if (board.selected)
            avr_raise_irq(board.bus + TWI_IRQ_INPUT, avr_twi_irq_msg(TWI_COND_ACK, board.selected, 1));
    }
    if (board.selected && m.u.twi.msg & TWI_COND_WRITE) {
        avr_raise_irq(board.bus + TWI_IRQ_INPUT, avr_twi_irq_msg(TWI_COND_ACK, board.selected, 1));
        if (board.written++)
            board.registers[board.at++ & 127] = m.u.twi.data;
        else
            board.at = m.u.twi.data;
    }
    if (board.selected && m.u.twi.msg & TWI_COND_READ)
        avr_raise_irq(board.bus + TWI_IRQ_INPUT, avr_twi_irq_msg(TWI_COND_READ, board.selected, answer(board.at++)));
}

static void on_serial(struct avr_irq_t *irq, uint32_t value, void *unused)
{
    (void)irq, (void)unused;
    if (board.length < sizeof board.sent)
        board.sent[board.length++] = value;
}

static void make_board(avr_t *avr)
{
    uint32_t quiet = 0;
    board.avr = avr;
    avr->vcc = avr->avcc = avr->aref = 5000;
    for (board.twi = avr->io_port; board.twi && strcmp(board.twi->kind, "twi"); board.twi = board.twi->next)
        ;
    board.bus = avr_io_getirq(avr, AVR_IOCTL_TWI_GETIRQ(0), 0);
    avr_irq_register_notify(board.bus + TWI_IRQ_OUTPUT, on_bus, NULL);
    avr_ioctl(avr, AVR_IOCTL_UART_SET_FLAGS('0'), &quiet);
    avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_UART_GETIRQ('0'), UART_IRQ_OUTPUT), on_serial, NULL);
    board.input[6] = MPU;
    power_up();
}

static void set_input(uint32_t what, int32_t value)
{
    board.input[what] = value;
    if (what == 1) /* [mV], in the middle of a step */
        avr_raise_irq(avr_io_getirq(board.avr, AVR_IOCTL_ADC_GETIRQ, ADC_IRQ_ADC0), (value * 2 + 1) * 5000 / 2046);
    if (what == 4 || what == 12)
        press(board.input[12], board.input[4]);
    if (what == 7)
        power_up();
}

/* Edges that are still to come; both channels of both encoders. */
static int turning(void) { return board.gone[0] != board.input[2] || board.gone[1] != board.input[3]; }

static void turn(void)
{
    if (board.avr->cycle < board.edge)
        return;
    board.edge = board.avr->cycle + EDGE;
    for (int side = 0; side < 2; side++) {
        const int way = (board.gone[side] < board.input[2 + side]) - (board.gone[side] > board.input[2 + side]);
        if (!way)
            continue;
        /* Forwards A and B are 00, 01, 11, 10: B changes between even and odd places, A between odd and even ones. */
        const int32_t from = board.gone[side], to = board.gone[side] = from + way;
        const int b = ((way > 0 ? from : to) & 1) == 0;
        set_pin(board.input[8 + 2 * side + b], (to + b) >> 1 & 1);
    }
}

/* One instruction of the processor, and what the board does meanwhile. A hung bus never answers. */
static int board_run(void)
{
    if (turning())
        turn();
    if (board.input[5] == HUNG)
        for (avr_cycle_timer_slot_p slot = board.avr->cycle_timers.timer; slot; slot = slot->next)
            if (slot->param == board.twi) {
                avr_cycle_timer_cancel(board.avr, slot->timer, slot->param);
                break;
            }
    const int state = avr_run(board.avr);
    return state != cpu_Done && state != cpu_Crashed;
}
