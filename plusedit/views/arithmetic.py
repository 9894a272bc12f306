"""Sums typed into number fields: "2*3+1", "sqrt(2)/2", "1,5". Nothing else is evaluated.

And numbers written: with a hyphen, as programs read them, where they are edited or copied; with a
true minus sign where they are only read.
"""

import ast
import math
import operator
from collections.abc import Callable, Iterator
from itertools import chain

LONGEST = 200  # characters; what is longer was pasted by mistake
MINUS = "\N{MINUS SIGN}"
WHOLE = 1e5  # numbers up to there are rather written as whole ones than with an exponent


def _power(base: float, exponent: float) -> float:
    try:
        return math.pow(base, exponent)
    except ValueError:
        raise ValueError(f"{base:g}^{exponent:g} is not a real number") from None


def _root(square: float) -> float:
    if square < 0.0:
        raise ValueError("a negative number has no real root")
    return math.sqrt(square)


BINARY: dict[type[ast.operator], Callable[[float, float], float]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.Pow: _power,
}
NAMES = {"pi": math.pi, "tau": math.tau, "e": math.e}
FUNCTIONS: dict[str, Callable[[float], float]] = {
    "sqrt": _root,
    "abs": abs,
    "sin": lambda degrees: math.sin(math.radians(degrees)),
    "cos": lambda degrees: math.cos(math.radians(degrees)),
    "tan": lambda degrees: math.tan(math.radians(degrees)),
}


def calculated(text: str) -> float:
    """The finite number that `text` comes to; a comma may stand for the decimal point.

    Angles of sin, cos and tan are in degrees. ValueError says what is wrong with the text.
    """
    cleaned = (
        text.strip().replace(",", ".").replace(MINUS, "-").replace("×", "*").replace("^", "**")
    )
    if not cleaned:
        raise ValueError("a number is needed")
    if len(cleaned) > LONGEST:
        raise ValueError("that is too long for a number")
    try:
        value = float(_value(ast.parse(cleaned, mode="eval").body))
    except (SyntaxError, RecursionError, MemoryError):
        raise ValueError(f"“{text.strip()}” is not a number") from None
    except ZeroDivisionError:
        raise ValueError("that divides by zero") from None
    except OverflowError:
        raise ValueError("that is too large") from None
    if not math.isfinite(value):
        raise ValueError("a finite number is needed")
    return value


def _value(node: ast.expr) -> float:
    match node:
        case ast.Constant(value=bool()):
            pass
        case ast.Constant(value=int() | float() as value):
            return float(value)
        case ast.UnaryOp(op=ast.USub(), operand=operand):
            return -_value(operand)
        case ast.UnaryOp(op=ast.UAdd(), operand=operand):
            return _value(operand)
        case ast.BinOp(left=left, op=op, right=right) if type(op) in BINARY:
            return BINARY[type(op)](_value(left), _value(right))
        case ast.Name(id=name) if name in NAMES:
            return NAMES[name]
        case ast.Call(func=ast.Name(id=name), args=[argument], keywords=[]) if name in FUNCTIONS:
            return FUNCTIONS[name](_value(argument))
    raise ValueError(f"“{ast.unparse(node)}” is not a number")


def written(value: float, digits: int = 6) -> str:
    """`value` as short as `digits` significant digits allow, never as "-0"."""
    text = f"{value:.{digits}g}"
    return "0" if float(text) == 0.0 else text


def true_minus(text: str) -> str:
    """A number in words with the sign that is as wide as a digit, for reading only."""
    return text.replace("-", MINUS)


def compact(value: float, longest: int, digits: int = 4) -> str:
    """`value` for reading, as wide as so many characters, a point among them, at most.

    With fewer digits where it would be wider.
    """
    forms = chain.from_iterable(_forms(value, count) for count in range(digits, 0, -1))
    return true_minus(next((text for text in forms if _width(text) <= longest), written(value, 1)))


def _width(text: str) -> int:
    """In narrow characters: without a point a number is wider than with one."""
    return len(text) + ("." not in text) + ("e-" in text)


def _forms(value: float, digits: int) -> Iterator[str]:
    """`value` with so many significant digits, the plainest form first."""
    plain = written(value, digits)
    if "e" not in plain:
        yield plain
    elif 1.0 <= abs(value) < WHOLE:
        yield f"{value:.0f}"
    mantissa, _, power = f"{value:.{digits - 1}e}".partition("e")
    yield f"{float(mantissa):g}e{int(power)}"
