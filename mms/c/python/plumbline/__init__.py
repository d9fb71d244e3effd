"""Manufactured solutions of solid mechanics, and verdicts on orders of convergence, for solvers in Python.

    import numpy, plumbline
    plate = plumbline.Solution("swinging-plate", 2, law="neo-hookean", young=17e6, poisson=0.45, density=1100, amplitude=0.05)
    load = plate.body_force(X, t)                 # X: (points, 2) [m]; load: (points, 2) [N/m^3]
    print(plate.error("displacement", X, t, u, weights).l2)
    print(plumbline.fit_order([0.2, 0.1, 0.05, 0.025], errors, declared=2))

All units are SI. Arrays are numpy arrays where numpy is there, else nested lists. What cannot be used is refused with ValueError.
"""
from __future__ import annotations

import ctypes
import math
import os
import pathlib
import typing

try:
    import numpy
except ImportError:  # everything works on lists too
    numpy = None

__all__ = ["Extrapolation", "Fit", "GridFit", "Norms", "Parameter", "Solution", "extrapolate", "field_error", "fit_grids",
           "fit_order", "laws", "meaning", "quantities", "solutions", "version"]

INTERFACE = 1  # of the shared library
quantities = ("displacement", "velocity", "acceleration", "F", "P", "cauchy", "body_force", "body_force_per_mass", "static_load")

_double_p = ctypes.POINTER(ctypes.c_double)


def _load() -> ctypes.CDLL:
    name = f"libplumbline_c.so.{INTERFACE}"
    tried = []
    if os.environ.get("PLUMBLINE_LIBRARY"):
        tried.append(os.environ["PLUMBLINE_LIBRARY"])
    here = pathlib.Path(__file__).resolve()
    for above in here.parents:  # PREFIX/lib/python3/dist-packages/plumbline: the library is in PREFIX/lib or below it
        if above.name == "lib":
            tried += [str(above / name), *map(str, sorted(above.glob(f"*/{name}")))]
            break
    for place in [*tried, name]:
        try:
            library = ctypes.CDLL(place)
        except OSError:
            continue
        if library.plumb_interface() != INTERFACE:
            raise ImportError(f"{place} has interface {library.plumb_interface()}, this module needs {INTERFACE}")
        return library
    raise ImportError(f"{name} was not found; name it with the environment variable PLUMBLINE_LIBRARY")


class _Parameter(ctypes.Structure):
    _fields_ = [("name", ctypes.c_char_p), ("unit", ctypes.c_char_p), ("meaning", ctypes.c_char_p), ("value", ctypes.c_double),
                ("least", ctypes.c_double), ("most", ctypes.c_double)]


class _Norms(ctypes.Structure):
    _fields_ = [("l2", ctypes.c_double), ("linf", ctypes.c_double), ("exact_l2", ctypes.c_double),
                ("relative_l2", ctypes.c_double), ("worst", ctypes.c_size_t)]


class _Fit(ctypes.Structure):
    _fields_ = [("order", ctypes.c_double), ("lower", ctypes.c_double), ("upper", ctypes.c_double),
                ("constant", ctypes.c_double), ("drift", ctypes.c_double), ("levels", ctypes.c_size_t),
                ("verdict", ctypes.c_char_p)]


class _Extrapolation(ctypes.Structure):
    _fields_ = [("behaviour", ctypes.c_char_p), ("order", ctypes.c_double), ("limit", ctypes.c_double),
                ("asymptotic_ratio", ctypes.c_double)]


class _GridFit(ctypes.Structure):
    _fields_ = [("expansion", ctypes.c_char_p), ("weighted", ctypes.c_int), ("order", ctypes.c_double),
                ("limit", ctypes.c_double), ("deviation", ctypes.c_double), ("range", ctypes.c_double),
                ("safety", ctypes.c_double), ("uncertainty", ctypes.c_double)]


_c = _load()
for _name in ("plumb_version", "plumb_message", "plumb_solution_name", "plumb_solution_summary", "plumb_law_name",
              "plumb_meaning"):
    getattr(_c, _name).restype = ctypes.c_char_p
for _name in ("plumb_solution_count", "plumb_solution_parameter_count", "plumb_law_count", "plumb_law_parameter_count",
              "plumb_components"):
    getattr(_c, _name).restype = ctypes.c_size_t
_size, _double, _text, _pointer = ctypes.c_size_t, ctypes.c_double, ctypes.c_char_p, ctypes.c_void_p
_c.plumb_meaning.argtypes = [_text]
for _name in ("plumb_solution_name", "plumb_solution_summary", "plumb_law_name", "plumb_solution_parameter_count",
              "plumb_law_parameter_count"):
    getattr(_c, _name).argtypes = [_size]
_c.plumb_solution_exists_in.argtypes = [_size, ctypes.c_int]
_c.plumb_solution_parameter.argtypes = _c.plumb_law_parameter.argtypes = [_size, _size, ctypes.POINTER(_Parameter)]
_c.plumb_new.argtypes = [_text, ctypes.c_int, ctypes.POINTER(_pointer)]
_c.plumb_free.argtypes = [_pointer]
_c.plumb_free.restype = None
_c.plumb_set.argtypes = _c.plumb_set_law_parameter.argtypes = [_pointer, _text, _double]
_c.plumb_set_law.argtypes = [_pointer, _text, _double, _double, _double]
_c.plumb_set_plane_stress.argtypes = _c.plumb_set_increments.argtypes = [_pointer, ctypes.c_int]
_c.plumb_period.argtypes = [_pointer, _double_p]
_c.plumb_box.argtypes = [_pointer, _double_p, _double_p]
_c.plumb_contains.argtypes = [_pointer, _size, _double_p, ctypes.POINTER(ctypes.c_int)]
_c.plumb_components.argtypes = [_pointer, ctypes.c_int]
_c.plumb_evaluate.argtypes = [_pointer, ctypes.c_int, _size, _double_p, _double, _double_p]
_c.plumb_traction.argtypes = [_pointer, _size, _double_p, _double_p, _double, _double_p]
_c.plumb_error.argtypes = [_pointer, ctypes.c_int, _size, _double_p, _double, _double_p, _double_p, ctypes.POINTER(_Norms)]
_c.plumb_field_error.argtypes = [_size, _size, _double_p, _double_p, _double_p, ctypes.POINTER(_Norms)]
_c.plumb_fit_order.argtypes = [_size, _double_p, _double_p, _double, _double_p, ctypes.POINTER(_Fit), _double_p]
_c.plumb_extrapolate.argtypes = [_size, _double_p, _double_p, _double, _double_p, ctypes.POINTER(_Extrapolation), _double_p,
                                 _double_p]
_c.plumb_fit_grids.argtypes = [_size, _double_p, _double_p, ctypes.POINTER(_GridFit), _double_p]


def _must(status: int) -> None:
    if status == 0:
        return
    text = _c.plumb_message().decode()
    raise ValueError(text) if status == 2 else RuntimeError(text)


def _shape_of(values) -> tuple[int, ...]:
    if numpy is not None:
        return numpy.shape(values)
    shape = []
    while isinstance(values, (list, tuple)):
        shape.append(len(values))
        values = values[0] if len(values) > 0 else None
    return tuple(shape)


def _flat(values) -> list:
    return [number for part in values for number in _flat(part)] if isinstance(values, (list, tuple)) else [values]


def _in(values, count: int, what: str):
    """The numbers for C, and what keeps them alive."""
    if numpy is not None:
        kept = numpy.ascontiguousarray(values, dtype=numpy.float64)
        size, pointer = kept.size, kept.ctypes.data_as(_double_p)
    else:
        numbers = _flat(values)
        kept = (ctypes.c_double * len(numbers))(*numbers)
        size, pointer = len(numbers), ctypes.cast(kept, _double_p)
    if size != count:
        raise ValueError(f"{what}: {size} numbers, {count} are needed")
    return pointer, kept


def _room(count: int):
    kept = numpy.empty(count) if numpy is not None else (ctypes.c_double * count)()
    return (kept.ctypes.data_as(_double_p) if numpy is not None else ctypes.cast(kept, _double_p)), kept


def _shaped(kept, shape: tuple[int, ...]):
    """The numbers that C wrote, in that shape."""
    if numpy is not None:
        return kept.reshape(shape)
    flat = list(kept)
    for size in reversed(shape[1:]):
        flat = [flat[k:k + size] for k in range(0, len(flat), size)]
    return flat


class Parameter(typing.NamedTuple):
    """One parameter of a solution or of a law."""
    name: str
    unit: str  #: "" for pure numbers
    meaning: str
    value: float  #: default; NaN: there is none
    least: float
    most: float


class Norms(typing.NamedTuple):
    """Norms of an error."""
    l2: float  #: [unit * m^(d/2)] with volumes as weights
    linf: float
    exact_l2: float
    relative_l2: float  #: NaN where the exact field is zero
    worst: int  #: the point of linf


class Fit(typing.NamedTuple):
    """An order of convergence. NaN stands for what is not determined; the verdict says why."""
    order: float
    lower: float  #: ends of the 95 % interval
    upper: float
    constant: float
    drift: float  #: change of the local slope over the levels
    levels: int  #: that were fitted
    verdict: str
    pairwise: list[float]  #: from coarse to fine

    def __str__(self) -> str:
        return f"order {self.order:.3f} [{self.lower:.3f}, {self.upper:.3f}] from {self.levels} levels: {self.verdict}"


class Extrapolation(typing.NamedTuple):
    """Richardson extrapolation. The numbers are NaN unless the behaviour is "monotone"."""
    behaviour: str
    order: float
    limit: float
    asymptotic_ratio: float
    gci: list[float]  #: relative to the finer value, finest pair first
    gci_absolute: list[float]


class GridFit(typing.NamedTuple):
    """Least-squares fit of noisy values (Eca and Hoekstra 2014)."""
    expansion: str
    weighted: bool
    order: float
    limit: float
    deviation: float
    range: float
    safety: float
    uncertainty: float  #: of the finest grid
    uncertainties: list[float]  #: fine to coarse


def version() -> str:
    """Gives the version of the library."""
    return _c.plumb_version().decode()


def meaning(verdict: str) -> str:
    """Explains a verdict in a sentence or two; "" for an unknown word."""
    return _c.plumb_meaning(verdict.encode()).decode()


def _parameters(count, get, k: int) -> list[Parameter]:
    found = []
    for n in range(count(k)):
        p = _Parameter()
        _must(get(k, n, ctypes.byref(p)))
        found.append(Parameter(p.name.decode(), p.unit.decode(), p.meaning.decode(), p.value, p.least, p.most))
    return found


def solutions() -> dict[str, list[Parameter]]:
    """Gives the catalogue of solutions with their parameters."""
    return {_c.plumb_solution_name(k).decode(): _parameters(_c.plumb_solution_parameter_count, _c.plumb_solution_parameter, k)
            for k in range(_c.plumb_solution_count())}


def laws() -> dict[str, list[Parameter]]:
    """Gives the catalogue of material laws with the parameters of their own."""
    return {_c.plumb_law_name(k).decode(): _parameters(_c.plumb_law_parameter_count, _c.plumb_law_parameter, k)
            for k in range(_c.plumb_law_count())}


class Solution:
    """A manufactured solution with a material law: exact fields and the loads that make them a solution.

    `parameters` are those of the solution. Without a law it has its own elastic constants and is neo-Hookean; with one, all
    three of young [Pa], poisson and density [kg/m^3] are needed, and `law_parameters` are the law's own. Positions X have the
    shape (points, dimension) [m, reference configuration]; vectors come back in that shape, tensors as (points, d, d).
    """

    def __init__(self, name: str, dimension: int = 2, *, law: str | None = None, young: float = math.nan,
                 poisson: float = math.nan, density: float = math.nan, law_parameters: dict[str, float] | None = None,
                 plane_stress: bool = False, increments: int | None = None, **parameters: float) -> None:
        self._handle = _pointer()
        _must(_c.plumb_new(name.encode(), dimension, ctypes.byref(self._handle)))
        self.name, self.dimension = name, dimension
        for key, value in parameters.items():
            _must(_c.plumb_set(self._handle, key.encode(), value))
        if law is not None:
            _must(_c.plumb_set_law(self._handle, law.encode(), young, poisson, density))
        elif not all(map(math.isnan, (young, poisson, density))):
            raise ValueError("elastic constants without a law: name it, law=\"neo-hookean\" for example")
        for key, value in (law_parameters or {}).items():
            _must(_c.plumb_set_law_parameter(self._handle, key.encode(), value))
        if plane_stress:
            _must(_c.plumb_set_plane_stress(self._handle, 1))
        if increments is not None:
            _must(_c.plumb_set_increments(self._handle, increments))

    def __del__(self) -> None:
        if getattr(self, "_handle", None):
            _c.plumb_free(self._handle)

    def __repr__(self) -> str:
        return f"plumbline.Solution({self.name!r}, {self.dimension})"

    @property
    def period(self) -> float:
        """The characteristic time [s]."""
        value = ctypes.c_double()
        _must(_c.plumb_period(self._handle, ctypes.byref(value)))
        return value.value

    @property
    def box(self) -> tuple[list[float], list[float]]:
        """The box around the domain: lowest corner and edge lengths [m]."""
        origin, size = (ctypes.c_double * self.dimension)(), (ctypes.c_double * self.dimension)()
        _must(_c.plumb_box(self._handle, origin, size))
        return list(origin), list(size)

    def _points(self, X) -> int:
        shape = _shape_of(X)
        if len(shape) != 2 or shape[1] != self.dimension:
            raise ValueError(f"positions have the shape {shape}, (points, {self.dimension}) is needed")
        return shape[0]

    def contains(self, X) -> list[bool]:
        """Says of every point whether it lies in the domain."""
        count = self._points(X)
        inside, (positions, kept) = (ctypes.c_int * count)(), _in(X, count * self.dimension, "X")
        _must(_c.plumb_contains(self._handle, count, positions, inside))
        return [bool(value) for value in inside]

    def evaluate(self, quantity: str, X, t: float):
        """Evaluates one of plumbline.quantities at positions X and time t [s]."""
        number, count = _number_of(quantity), self._points(X)
        components = _c.plumb_components(self._handle, number)
        (positions, kept), (room, values) = _in(X, count * self.dimension, "X"), _room(count * components)
        _must(_c.plumb_evaluate(self._handle, number, count, positions, t, room))
        d = self.dimension
        return _shaped(values, (count, d) if components == d else (count, d, d))

    def displacement(self, X, t: float):
        """u [m]."""
        return self.evaluate("displacement", X, t)

    def velocity(self, X, t: float):
        """u_t [m/s]."""
        return self.evaluate("velocity", X, t)

    def acceleration(self, X, t: float):
        """u_tt [m/s^2]."""
        return self.evaluate("acceleration", X, t)

    def F(self, X, t: float):
        """Deformation gradient I + Grad u."""
        return self.evaluate("F", X, t)

    def P(self, X, t: float):
        """First Piola-Kirchhoff stress [Pa]."""
        return self.evaluate("P", X, t)

    def cauchy(self, X, t: float):
        """Cauchy stress P F^T/J [Pa]."""
        return self.evaluate("cauchy", X, t)

    def body_force(self, X, t: float):
        """rho u_tt - Div P per reference volume [N/m^3]: the load that makes u the solution."""
        return self.evaluate("body_force", X, t)

    def static_load(self, X, t: float):
        """-Div P per reference volume [N/m^3]: the load of the equilibrium at that time."""
        return self.evaluate("static_load", X, t)

    def traction(self, X, N, t: float):
        """P N per reference area [Pa] for outward unit normals N, one per point."""
        count = self._points(X)
        (positions, kept), (normals, also) = _in(X, count * self.dimension, "X"), _in(N, count * self.dimension, "N")
        room, values = _room(count * self.dimension)
        _must(_c.plumb_traction(self._handle, count, positions, normals, t, room))
        return _shaped(values, (count, self.dimension))

    def error(self, quantity: str, X, t: float, values, weights=None) -> Norms:
        """Norms of values minus the solution. Weights are volumes [m^d]; without them l2 is a root mean square."""
        number, count = _number_of(quantity), self._points(X)
        components = _c.plumb_components(self._handle, number)
        (positions, kept), (given, also) = _in(X, count * self.dimension, "X"), _in(values, count * components, "values")
        volumes, too = (None, None) if weights is None else _in(weights, count, "weights")
        norms = _Norms()
        _must(_c.plumb_error(self._handle, number, count, positions, t, given, volumes, ctypes.byref(norms)))
        return Norms(norms.l2, norms.linf, norms.exact_l2, norms.relative_l2, norms.worst)


def _number_of(quantity: str) -> int:
    if quantity not in quantities:
        raise ValueError(f"there is no quantity {quantity!r}; there are {', '.join(quantities)}")
    return quantities.index(quantity)


def field_error(values, exact=None, weights=None) -> Norms:
    """Norms of the difference of two fields of the shape (points, ...); exact=None stands for zero."""
    shape = _shape_of(values)
    components = math.prod(shape[1:])
    given, kept = _in(values, shape[0] * components, "values")
    right, also = (None, None) if exact is None else _in(exact, shape[0] * components, "exact")
    volumes, too = (None, None) if weights is None else _in(weights, shape[0], "weights")
    norms = _Norms()
    _must(_c.plumb_field_error(shape[0], components, given, right, volumes, ctypes.byref(norms)))
    return Norms(norms.l2, norms.linf, norms.exact_l2, norms.relative_l2, norms.worst)


def _declared(order: float | None):
    return None if order is None else ctypes.byref(ctypes.c_double(order))


def fit_order(spacings, errors, declared: float | None = None, round_off: float = 0) -> Fit:
    """Fits error = C h^p with a 95 % interval and judges p against a declared order, if there is one."""
    count = len(spacings)
    (h, kept), (e, also) = _in(spacings, count, "spacings"), _in(errors, count, "errors")
    fit, pairwise = _Fit(), (ctypes.c_double * max(1, count - 1))()
    _must(_c.plumb_fit_order(count, h, e, round_off, _declared(declared), ctypes.byref(fit), pairwise))
    return Fit(fit.order, fit.lower, fit.upper, fit.constant, fit.drift, fit.levels, fit.verdict.decode(),
               list(pairwise)[:max(0, count - 1)])


def extrapolate(spacings, values, declared: float | None = None, safety: float = 1.25) -> Extrapolation:
    """Extrapolates values on three grids or more to spacing 0, with the grid convergence index of every pair."""
    count = len(spacings)
    (h, kept), (v, also) = _in(spacings, count, "spacings"), _in(values, count, "values")
    found, relative, absolute = _Extrapolation(), (ctypes.c_double * max(1, count))(), (ctypes.c_double * max(1, count))()
    _must(_c.plumb_extrapolate(count, h, v, safety, _declared(declared), ctypes.byref(found), relative, absolute))
    return Extrapolation(found.behaviour.decode(), found.order, found.limit, found.asymptotic_ratio,
                         list(relative)[:count - 1], list(absolute)[:count - 1])


def fit_grids(spacings, values) -> GridFit:
    """Grid convergence index by least squares over four grids or more, for noisy values."""
    count = len(spacings)
    (h, kept), (v, also) = _in(spacings, count, "spacings"), _in(values, count, "values")
    found, all_of_them = _GridFit(), (ctypes.c_double * max(1, count))()
    _must(_c.plumb_fit_grids(count, h, v, ctypes.byref(found), all_of_them))
    return GridFit(found.expansion.decode(), bool(found.weighted), found.order, found.limit, found.deviation, found.range,
                   found.safety, found.uncertainty, list(all_of_them)[:count])
