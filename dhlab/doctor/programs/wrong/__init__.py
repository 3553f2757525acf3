"""Wrong versions of the programs that a course asks for: what each mistake makes of a right one."""
