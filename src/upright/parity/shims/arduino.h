/* Stand-ins for what a generated sketch uses of Arduino's core and Wire: pins and sensors are plain variables. */
#ifndef ARDUINO_STAND_IN
#define ARDUINO_STAND_IN
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#define INPUT 0
#define OUTPUT 1
#define INPUT_PULLUP 2
#define LOW 0
#define HIGH 1
#define CHANGE 1
#define A0 14
#define LED_BUILTIN 13
#define F(text) (text)
#define digitalPinToInterrupt(pin) ((pin) - 2)

extern volatile int16_t stub_gyro, stub_battery, stub_pwm[20];
extern volatile uint8_t stub_pin[20], stub_button;
extern volatile uint32_t stub_time;

inline void pinMode(uint8_t, uint8_t) {}
inline void digitalWrite(uint8_t pin, uint8_t value) { stub_pin[pin] = value; }
inline int digitalRead(uint8_t pin) { return pin == 4 ? !stub_button : stub_pin[pin]; }
inline void analogWrite(uint8_t pin, int value) { stub_pwm[pin] = value; }
inline int analogRead(uint8_t) { return stub_battery; }
inline unsigned long micros() { return stub_time; }
inline void attachInterrupt(uint8_t, void (*)(), int) {}
inline void noInterrupts() {}
inline void interrupts() {}

struct SerialStandIn {
    void begin(long) {}
    void print(const char *) {}
    void println(const char *) {}
    int availableForWrite() { return 0; }
};
static SerialStandIn Serial;

struct WireStandIn {
    uint8_t at;
    void begin() {}
    void setClock(long) {}
    void beginTransmission(uint8_t) {}
    void write(uint8_t) {}
    uint8_t endTransmission(bool = true) { return 0; }
    uint8_t requestFrom(uint8_t, uint8_t count) { at = 0; return count; }
    int read() { return at++ ? stub_gyro & 255 : stub_gyro >> 8 & 255; }
};
static WireStandIn Wire;
#endif
