"""The lines to real bricks: an NXT over USB or Bluetooth, a Pybricks hub over Bluetooth."""
