"""Virtual bricks: an NXT and a Pybricks hub, down to their bytecode and their lines, with the twin round them."""
