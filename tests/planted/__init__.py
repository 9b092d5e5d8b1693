"""What tests and benchmarks plant: faults in logs, robots that fall, robots of other simulators, and abuse."""
