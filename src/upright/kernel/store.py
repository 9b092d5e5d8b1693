"""Compiled functions kept on disk as machine code, so that only the first run on a machine needs the compiler.

The key is a hash of the sources, of the versions of Python, Numba and LLVM, and of the processor, so that nothing stale
is ever loaded; each file begins with a checksum of the rest and of its name, so that a damaged one is made anew.
Loading needs LLVM's linker alone, not Numba, whose import takes longer than everything else together. Files stand in
`UPRIGHT_CACHE`, or in the user's cache folder; where neither can be written, every process compiles. Nothing
is kept under a Numba whose version is not one of `NUMBA`: what it makes of a function is not all public.
"""

from __future__ import annotations

import ctypes
import gc
import hashlib
import os
import sys
import tempfile
from contextlib import suppress
from functools import cache
from importlib import import_module
from importlib.metadata import version
from pathlib import Path
from threading import Lock
from typing import Any

from upright.atomic import write_bytes
from upright.errors import UprightError

llvm: Any = import_module("llvmlite.binding")

SOURCES = (
    "compiled/counter.py", "compiled/generated.py", "compiled/generated_motion.py", "compiled/jit.py",
    "compiled/lane_math.py", "compiled/random.py", "kernel/block.py", "kernel/period.py", "kernel/rows.py",
    "kernel/run.py", "kernel/store.py", "compiled/electronics.py", "robots/kit.py",
)  # fmt: skip
"""What decides about compiled functions; the last two about the rows of a sensor's numbers."""
ALSO = (
    "calibration/coefficients.py", "calibration/curves.py", "calibration/descent.py", "calibration/kept.py",
    "calibration/motion.py", "calibration/parameters.py", "calibration/predictor.py", "calibration/ringing.py",
    "compiled/print_python.py", "compiled/printer.py", "compiled/tracer.py", "diagnose/propagation.py",
    "physics/electronics.py", "robots/robot.py", "robots/uncertainty.py",
)  # fmt: skip
"""What else decides about functions that Numba itself compiles and calls."""

NUMBA = ((0, 61), (0, 69))
"""The first version of Numba under which functions are kept, and the first one that nobody tried, as in pyproject."""

_CHECKSUM = hashlib.sha256().digest_size  # bytes before the code of a file
_engines: list[Any] = []  # what they loaded lives as long as they do
_lock = Lock()


def address_of(module: str, function: str, arguments: tuple[str, ...]) -> int:
    """Address of `function` of `upright.<module>`, compiled for `arguments`: Numba's names of types, "*T" for a
    pointer to T. It returns nothing."""
    with _lock:
        return _address_of(module, function, arguments)


def functions_of(text: str, *names: str) -> tuple[int, ...]:
    """Addresses of the functions `names` of a module in LLVM's own language."""
    with _lock:
        return _functions_of(text, names)


@cache
def _functions_of(text: str, names: tuple[str, ...]) -> tuple[int, ...]:
    path = path_of(names[0], text)
    code = kept(path)
    if code is None:
        code = _machine().emit_object(llvm.parse_assembly(text))
        keep(path, code)
    engine = _engine(code)
    return tuple(engine.get_function_address(name) for name in names)


def call(address: int, arguments: list[Any]) -> None:
    """Calls it with addresses and whole numbers, other threads running on."""
    _prototype(len(arguments))(address)(*arguments)


@cache
def _prototype(count: int) -> Any:
    return ctypes.CFUNCTYPE(None, *[ctypes.c_int64] * count)


@cache
def _address_of(module: str, function: str, arguments: tuple[str, ...]) -> int:
    if not known_numba():
        return _by_numba(module, function, arguments)
    path = path_of(function, repr((module, arguments)))
    code = kept(path)
    if code is None:
        code = _compiled(module, function, arguments)
        keep(path, code)
    return _engine(code).get_function_address(function)


@cache
def _stamp(sources: tuple[str, ...]) -> str:
    """All that decides what the compiler makes."""
    here = Path(__file__).parents[1]
    texts = [(here / name).read_bytes() for name in sources]
    tools = [version("numba"), version("llvmlite"), sys.version, sys.platform]
    machine = [llvm.get_host_cpu_name(), llvm.get_host_cpu_features().flatten()]
    return hashlib.sha256(b"\0".join([*texts, *(part.encode() for part in tools + machine)])).hexdigest()


def folder() -> Path:
    """Where compiled functions are kept: among temporary files for a user without a home folder."""
    chosen = os.environ.get("UPRIGHT_CACHE")
    if chosen:
        return Path(chosen)
    home = {"win32": os.environ.get("LOCALAPPDATA"), "darwin": "~/Library/Caches"}.get(sys.platform)
    place = os.path.expanduser(home or os.environ.get("XDG_CACHE_HOME") or "~/.cache")
    return Path(tempfile.gettempdir() if place.startswith("~") else place) / "upright"


def path_of(function: str, key: str, also: tuple[str, ...] = ()) -> Path:
    """Where the code of a function is kept that `key`, the `SOURCES`, and those that it `also` has decide."""
    stamp = f"{_stamp(SOURCES + also)} {key}"
    return folder() / f"{function}-{hashlib.sha256(stamp.encode()).hexdigest()[:24]}.o"


def kept(path: Path) -> bytes | None:
    """The code in that file; None where there is none, or where it is not what was written."""
    try:
        entry = path.read_bytes()
    except OSError:
        return None
    checksum = entry[:_CHECKSUM]
    code = entry[_CHECKSUM:]
    return code if _checksum(path, code) == checksum else None


def _checksum(path: Path, code: bytes) -> bytes:
    return hashlib.sha256(path.name.encode() + code).digest()


def keep(path: Path, code: bytes) -> None:
    """Keep it there, where that can be; whole or not at all, so that another process never reads half a file."""
    with suppress(OSError, UprightError):
        path.parent.mkdir(parents=True, exist_ok=True)
        write_bytes(path, _checksum(path, code) + code, at_once=True)


def _compiled(module: str, function: str, arguments: tuple[str, ...]) -> bytes:
    """Machine code of an object file whose one entry has the name of the function and takes nothing but `arguments`."""
    numba, python, kinds = _asked(module, function, arguments)
    level = numba.config.OPT
    collects = gc.isenabled()
    options = {"error_model": "numpy", "no_cpython_wrapper": True, "no_cfunc_wrapper": True}
    # No other thread compiles meanwhile, at a level of optimisation that is not its own.
    with import_module("numba.core.compiler_lock").global_compiler_lock:
        try:
            # Numba optimises every function, and again in each one that calls it: here that is done once, for all.
            numba.config.OPT = type(level)(0)
            gc.disable()  # what a compiler makes is kept until it is done: a tenth of its time would be spent to see it
            made: Any = numba.njit(numba.types.void(*kinds), **options)(python)
        finally:
            numba.config.OPT = level
            if collects:
                gc.enable()
    (result,), (text,) = made.overloads.values(), made.inspect_llvm().values()
    final = llvm.parse_assembly(text)
    inner = result.fndesc.llvm_func_name
    final.link_in(llvm.parse_assembly(_entrance(function, inner, [_LLVM.get(a, "ptr") for a in arguments])))
    for part in final.functions:
        if not part.is_declaration and part.name != function:
            part.linkage = "internal"
    machine = _machine()
    return machine.emit_object(_optimised(final, machine))


def _asked(module: str, function: str, arguments: tuple[str, ...]) -> tuple[Any, Any, list[Any]]:
    """Numba, the function, and the types of its arguments as Numba has them."""
    numba: Any = import_module("numba")
    types = numba.types
    kinds = [types.CPointer(getattr(types, a[1:])) if a[0] == "*" else getattr(types, a) for a in arguments]
    return numba, getattr(import_module(f"upright.{module}"), function), kinds


def _by_numba(module: str, function: str, arguments: tuple[str, ...]) -> int:
    """The address of what Numba makes by itself, for this process alone."""
    numba, python, kinds = _asked(module, function, arguments)
    made: Any = numba.cfunc(numba.types.void(*kinds), error_model="numpy")(python)
    _engines.append(made)
    return made.address


@cache
def known_numba() -> bool:
    """Whether functions can be kept: parts of Numba that are used here are not public. Says so once where not."""
    present = version("numba")
    known = NUMBA[0] <= tuple(int(part) for part in present.split(".")[:2]) < NUMBA[1]
    if not known:
        sys.stderr.write(f"upright: numba {present} was never tried: every process compiles anew, which takes longer\n")
    return known


def _optimised(module: Any, machine: Any) -> Any:
    """At level 3, with loops as vectors. Unrolled, a loop over 64 robots is no quicker, and takes twice as long to
    compile."""
    tuning = llvm.create_pipeline_tuning_options(speed_level=3)
    tuning.loop_vectorization = True
    tuning.slp_vectorization = False
    tuning.loop_unrolling = tuning.loop_interleaving = False
    tuning.inlining_threshold = 0
    builder = llvm.create_pass_builder(machine, tuning)
    passes = builder.getModulePassManager()
    passes.add_global_dead_code_eliminate_pass()
    passes.run(module, builder)
    return module


_LLVM = {"int64": "i64", "uint64": "i64", "float64": "double"}


def _entrance(name: str, inner: str, kinds: list[str]) -> str:
    """A function that calls Numba's with room for its result and for an exception, of which there are none. Nor is
    there any memory to be freed, though Numba asks."""
    head = ", ".join(f"{kind} %a{i}" for i, kind in enumerate(kinds))
    return f"""
        declare i32 @"{inner}"(ptr, ptr, {", ".join(kinds)})
        define void @NRT_MemInfo_call_dtor(ptr %memory) {{ ret void }}
        define void @{name}({head}) {{
            %result = alloca ptr
            %exception = alloca ptr
            %status = call i32 @"{inner}"(ptr %result, ptr %exception, {head})
            ret void
        }}"""


def _engine(code: bytes) -> Any:
    engine = llvm.create_mcjit_compiler(llvm.parse_assembly(""), _machine())
    engine.add_object_file(llvm.ObjectFileRef.from_data(code))
    engine.finalize_object()
    _engines.append(engine)
    return engine


def _machine() -> Any:
    """A target machine of our own: Numba keeps for good the level of optimisation at which it first makes its own."""
    if not _engines:
        llvm.initialize_native_target()
        llvm.initialize_native_asmprinter()
    has = llvm.get_host_cpu_features()
    widest = ",-prefer-256-bit" if has.get("avx512f") else ""
    host = {"cpu": llvm.get_host_cpu_name(), "features": has.flatten() + widest}
    return llvm.Target.from_default_triple().create_target_machine(opt=3, jit=True, **host)
