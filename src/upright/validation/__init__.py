"""What is known of a robot, judged on another log of it."""
