"""The specification's rules for loops (6.6), read independently: does a loop end, after how many rounds, with what.

A loop counts a variable from a start by a step while a relation to a limit holds. `verdict` tells what is to be done with
it: Verdict.ACCEPT, REFUSE, or OPEN where the rules can be read in two ways.
"""
import dataclasses
import enum
import functools

MOST_ROUNDS = 10_000_000
COUNTED_OUT = 3_000  # values of a 32-bit counter that are tried one by one

# bits, signed; and what each is promoted to
TYPES = {"char": (8, True), "unsigned char": (8, False), "int": (16, True), "unsigned": (16, False), "long": (32, True),
         "unsigned long": (32, False)}


class Verdict(enum.Enum):
    ACCEPT = "accept"
    REFUSE = "refuse"
    OPEN = "open"


def wrap(value, kind):
    bits, signed = TYPES[kind]
    value &= (1 << bits) - 1
    return value - (1 << bits) if signed and value >> (bits - 1) else value


def bounds(kind):
    bits, signed = TYPES[kind]
    return (-(1 << (bits - 1)), (1 << (bits - 1)) - 1) if signed else (0, (1 << bits) - 1)


def common(one, other):
    """The usual arithmetic conversions, int of 16 bits."""
    for kind in ("unsigned long", "long", "unsigned"):
        if kind in (one, other):
            return kind
    return "int"


def holds(relation, one, other, kind):
    one, other = wrap(one, kind), wrap(other, kind)
    return {"<": one < other, "<=": one <= other, ">": one > other, ">=": one >= other, "!=": one != other}[relation]


@dataclasses.dataclass(frozen=True)
class Run:
    ended: bool
    rounds: int
    end: int
    wrapped: bool  # a value beyond the type's end was compared


@dataclasses.dataclass(frozen=True)
class Count:
    """When the test is made: 'first' (while), 'last' (do), 'prefix' and 'postfix' (the change is in the condition)."""
    kind: str
    start: int
    relation: str
    limit_kind: str
    step: int
    when: str
    first: bool = True  # prefix, postfix: the test comes before the body


def step_once(count, value):
    return wrap(value + count.step, count.kind)


@functools.lru_cache(maxsize=200_000)
def run(count, limit):
    quick = run_quickly(count, limit)
    return quick if quick else run_slowly(count, limit)


def run_quickly(count, limit):
    """By arithmetic, where the comparison keeps both values and the loop is a plain one."""
    kind = common(count.kind, count.limit_kind)
    low, high = bounds(kind)
    own_low, own_high = bounds(count.kind)
    if not (low <= own_low and own_high <= high and low <= limit <= high) or count.when not in ("first", "last"):
        return None
    if count.relation == "!=":
        return run_to_equality(count, limit) if own_low <= limit <= own_high and abs(count.step) == 1 else None
    if (count.step > 0) != (count.relation in ("<", "<=")):
        return None
    value, rounds = count.start, 0
    if count.when == "last":
        value, rounds = value + count.step, 1
        if not own_low <= value <= own_high:
            return None
    beyond = limit + (1 if count.relation == "<=" else -1 if count.relation == ">=" else 0)
    distance = (beyond - value) * (1 if count.step > 0 else -1)
    more = max(0, -(-distance // abs(count.step)))
    end = value + more * count.step
    return Run(True, rounds + more, end, False) if own_low <= end <= own_high else None


def run_to_equality(count, limit):
    """A step of 1 meets every value of the type."""
    value, rounds = count.start, 0
    if count.when == "last":
        value, rounds = step_once(count, value), 1
    more = (limit - value) * count.step % (1 << TYPES[count.kind][0])
    over = (value - count.start) * count.step < 0 or (limit - value) * count.step < 0
    return Run(True, rounds + more, limit, over)


def run_slowly(count, limit):
    kind = common(count.kind, count.limit_kind)
    value, rounds, wrapped = count.start, 0, False
    if count.when == "last" or not count.first:
        rounds = 1
        if count.when == "last":
            value = step_once(count, value)
            wrapped = value != count.start + count.step
    most = COUNTED_OUT if TYPES[count.kind][0] == 32 else (1 << TYPES[count.kind][0]) + 2
    while rounds < most:
        if count.when in ("first", "last"):
            if not holds(count.relation, value, limit, kind):
                return Run(True, rounds, value, wrapped)
            following = step_once(count, value)
            wrapped |= following != value + count.step
            value, rounds = following, rounds + 1
            continue
        following = step_once(count, value)
        over = following != value + count.step
        compared = following if count.when == "prefix" else value
        wrapped |= over and count.when == "prefix"
        value = following
        if not holds(count.relation, compared, limit, kind):
            return Run(True, rounds, value, wrapped)
        wrapped |= over
        rounds += 1
    return Run(False, rounds, value, wrapped)


def extremes(low, high, start):
    near = [low + i for i in range(6)] + [high - i for i in range(8)] + [start + i for i in range(-3, 4)] + [0, (low + high) // 2]
    return sorted({value for value in near if low <= value <= high})


def verdict(count, low, high):
    """The limit is somewhere in low..high, which is all that is known of it."""
    constant = low == high
    bits, signed = TYPES[count.kind]
    towards = (count.step > 0) == (count.relation in ("<", "<="))
    if not constant and count.relation == "!=" and abs(count.step) != 1:
        return Verdict.REFUSE
    if not constant and not towards and count.relation != "!=":
        ones = [run(count, limit) for limit in (low, high)]
        return Verdict.OPEN if all(r.ended and r.rounds <= 1 for r in ones) else Verdict.REFUSE
    runs = [run(count, limit) for limit in extremes(low, high, count.start)]
    if count.relation == "!=":
        if constant:
            if not runs[0].ended:
                # counted further than anybody waits, or forever
                return Verdict.OPEN if bits == 32 else Verdict.REFUSE
            return Verdict.OPEN if runs[0].wrapped and signed and abs(count.step) != 1 else Verdict.ACCEPT
        if not all(r.ended for r in runs):
            return Verdict.REFUSE
        return Verdict.ACCEPT if max(r.rounds for r in runs) <= MOST_ROUNDS else Verdict.REFUSE
    if not towards:
        # Counting away from the limit ends at the first test, or over the end of the type.
        return Verdict.OPEN if runs[0].ended else Verdict.REFUSE
    if not all(r.ended for r in runs):
        return Verdict.REFUSE
    if any(r.wrapped for r in runs):
        if not constant:
            return Verdict.REFUSE
        return Verdict.OPEN if signed else Verdict.ACCEPT
    if max(r.rounds for r in runs) > MOST_ROUNDS:
        return Verdict.REFUSE
    return Verdict.ACCEPT if constant or in_range(count, low, high) else Verdict.OPEN


def in_range(count, low, high):
    """The last value stays in the type for each limit, whatever the start is: what a proof by ranges can see."""
    kind = common(count.kind, count.limit_kind)
    own_low, own_high = bounds(count.kind)
    if not (bounds(kind)[0] <= own_low and own_high <= bounds(kind)[1] and bounds(kind)[0] <= low):
        return False
    equal = 0 if count.relation in ("<=", ">=") or count.when in ("prefix", "postfix") else 1
    return high - equal + count.step <= own_high if count.step > 0 else low + equal + count.step >= own_low
