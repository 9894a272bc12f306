"""Eight numbers of single precision at a time, for loops that numba compiles.

Left to itself the compiler takes thirty-two numbers at once or one at a time, and most rows of the
loops in `preview_kernels` are shorter than that. A value of type `Lanes` is eight numbers in a
register, on every processor that has such registers and in two or more where it has not.
"""

from collections.abc import Callable
from typing import Any

from llvmlite import ir
from numba import types
from numba.extending import intrinsic, models, register_model

COUNT = 8
VECTOR = ir.VectorType(ir.FloatType(), COUNT)
WHOLE = ir.VectorType(ir.IntType(32), COUNT)


class Lanes(types.Type):
    """Eight numbers of single precision."""


LANES = Lanes(name="Lanes")


@register_model(Lanes)
class LanesModel(models.PrimitiveModel):
    """Kept as one vector of LLVM."""

    def __init__(self, manager: Any, kind: Any) -> None:
        super().__init__(manager, kind, VECTOR)  # type: ignore[no-untyped-call]


def code(writer: Callable[..., Any]) -> Callable[..., Any]:
    """A function for compiled loops, given by what writes its code."""
    return intrinsic(writer)


def _place(context: Any, builder: Any, array_type: Any, array: Any, index: Any) -> Any:
    """The address of eight numbers from an index on, in an array of one axis."""
    data = context.make_array(array_type)(context, builder, array).data
    return builder.bitcast(builder.gep(data, [index]), VECTOR.as_pointer())


def _of_llvm(builder: Any, name: str, result: Any, arguments: Any) -> Any:
    """A function that LLVM has for vectors."""
    full = f"llvm.{name}.v{COUNT}f32"
    known = builder.module.globals.get(full)
    return known or ir.Function(builder.module, ir.FunctionType(result, arguments), full)


@code
def load(typing: Any, array: Any, index: Any) -> Any:
    """array[index : index + 8]"""

    def written(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        place = _place(context, builder, signature.args[0], arguments[0], arguments[1])
        found = builder.load(place)
        found.align = 4
        return found

    return LANES(array, types.intp), written


@code
def store(typing: Any, array: Any, index: Any, value: Any) -> Any:
    """array[index : index + 8] = value"""

    def written(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        place = _place(context, builder, signature.args[0], arguments[0], arguments[1])
        builder.store(arguments[2], place).align = 4
        return context.get_dummy_value()

    return types.none(array, types.intp, LANES), written


@code
def same(typing: Any, value: Any) -> Any:
    """Eight times the same number."""

    def written(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        one = builder.insert_element(
            ir.Constant(VECTOR, ir.Undefined), arguments[0], ir.Constant(ir.IntType(32), 0)
        )
        mask = ir.Constant(WHOLE, [0] * COUNT)
        return builder.shuffle_vector(one, ir.Constant(VECTOR, ir.Undefined), mask)

    return LANES(types.float32), written


@code
def fused(typing: Any, a: Any, b: Any, c: Any) -> Any:
    """a b + c"""

    def written(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        return builder.call(_of_llvm(builder, "fmuladd", VECTOR, [VECTOR] * 3), arguments)

    return LANES(LANES, LANES, LANES), written


@code
def plus(typing: Any, a: Any, b: Any) -> Any:
    """a + b"""

    def written(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        return builder.fadd(*arguments)

    return LANES(LANES, LANES), written


@code
def minus(typing: Any, a: Any, b: Any) -> Any:
    """a - b"""

    def written(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        return builder.fsub(*arguments)

    return LANES(LANES, LANES), written


@code
def times(typing: Any, a: Any, b: Any) -> Any:
    """a b"""

    def written(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        return builder.fmul(*arguments)

    return LANES(LANES, LANES), written


@code
def total(typing: Any, a: Any) -> Any:
    """The sum of the eight numbers."""

    def written(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        number = ir.FloatType()
        function = _of_llvm(builder, "vector.reduce.fadd", number, [number, VECTOR])
        return builder.call(
            function, [ir.Constant(number, 0.0), arguments[0]], fastmath=("reassoc",)
        )

    return types.float32(LANES), written


@code
def totals(typing: Any, a: Any, b: Any, c: Any, d: Any) -> Any:
    """The sum of the eight numbers in each, and these four again."""

    def written(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        def folded(x: Any, y: Any, first: list[int], second: list[int]) -> Any:
            def mask(numbers: list[int]) -> Any:
                return ir.Constant(WHOLE, numbers)

            parts = (builder.shuffle_vector(x, y, mask(each)) for each in (first, second))
            return builder.fadd(*parts)

        pairs = [0, 8, 2, 10, 4, 12, 6, 14], [1, 9, 3, 11, 5, 13, 7, 15]
        fours = [0, 1, 8, 9, 4, 5, 12, 13], [2, 3, 10, 11, 6, 7, 14, 15]
        halves = [0, 1, 2, 3, 0, 1, 2, 3], [4, 5, 6, 7, 4, 5, 6, 7]
        a, b, c, d = arguments
        found = folded(folded(a, b, *pairs), folded(c, d, *pairs), *fours)
        return folded(found, found, *halves)

    return LANES(LANES, LANES, LANES, LANES), written


@code
def exponential(typing: Any, a: Any) -> Any:
    """exp of eight numbers below 80, to 2e-7; of those below -80 as if they were -80."""

    def written(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        def constant(value: float) -> Any:
            return ir.Constant(VECTOR, [value] * COUNT)

        def fma(x: Any, y: Any, z: Any) -> Any:
            return builder.call(_of_llvm(builder, "fmuladd", VECTOR, [VECTOR] * 3), [x, y, z])

        (y,) = arguments
        y = builder.select(builder.fcmp_ordered(">", y, constant(-80.0)), y, constant(-80.0))
        shifter = constant(12582912.0)
        shifted = fma(y, constant(1.4426950408889634), shifter)
        k = builder.fsub(shifted, shifter)
        r = fma(k, constant(-0.693359375), y)
        r = fma(k, constant(2.12194440e-4), r)
        p = constant(1 / 720)
        for denominator in (120, 24, 6, 2, 1, 1):
            p = fma(p, r, constant(1.0 / denominator))
        bits = builder.bitcast(shifted, WHOLE)
        exponent = builder.shl(bits, ir.Constant(WHOLE, [23] * COUNT))
        whole = builder.add(builder.bitcast(p, WHOLE), exponent)
        return builder.bitcast(whole, VECTOR)

    return LANES(LANES), written
