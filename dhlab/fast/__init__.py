"""Forward kinematics, frames and Jacobian, fast: the paths that ``Arm`` takes by itself.

``dhlab.kinematics`` says what the numbers are; the modules here give them sooner, and differ from
them by rounding alone (a few 1e-16 of the arm's reach; docs/benchmarks/accuracy.md). Read
``walk.py`` first, the way along the chain, then whoever walks it: ``one.py`` (floats), ``many.py``
(numpy), ``kernel_many.py`` and ``kernel_one.py`` (numba). ``paths.py`` chooses.

===============  ===============================================================================
``plain.py``     the product of link matrices, applied to an arm: the definition
``chain.py``     an arm's constants; both conventions as one chain
``walk.py``      the order of the moves; runs of parallel axes
``one.py``       one pose in floats
``straight.py``  the same as the program of one arm
``many.py``      from a few dozen poses to millions, in numpy
``kernel_*.py``  one pose, many, and what both share, as numba compiles them
``compiled.py``  when numba is loaded, and what it is given
``inputs.py``    whether q and out are what they should be
``paths.py``     which path a question takes
===============  ===============================================================================
"""
