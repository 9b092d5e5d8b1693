"""One definition, many machines: what traces equations and controllers, represents them, and prints them."""
