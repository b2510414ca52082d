"""Integers of a 16-bit C: types, conversions, comparisons and division, as exact numbers."""
import collections

Type = collections.namedtuple("Type", "name bits signed")

INT = Type("int", 16, True)
UNSIGNED = Type("unsigned", 16, False)
LONG = Type("long", 32, True)
UNSIGNED_LONG = Type("unsigned long", 32, False)
TYPES = [Type("signed char", 8, True), Type("unsigned char", 8, False), INT, UNSIGNED, LONG, UNSIGNED_LONG]


def low(of):
    return -(1 << (of.bits - 1)) if of.signed else 0


def high(of):
    return (1 << (of.bits - 1)) - 1 if of.signed else (1 << of.bits) - 1


def convert(value, to):
    value &= (1 << to.bits) - 1
    return value - (1 << to.bits) if to.signed and value >> (to.bits - 1) else value


def promoted(of):
    return INT if of.bits < 16 else of


def common(a, b):
    a, b = promoted(a), promoted(b)
    if UNSIGNED_LONG in (a, b):
        return UNSIGNED_LONG
    if LONG in (a, b):
        return LONG
    return UNSIGNED if UNSIGNED in (a, b) else INT


RELATIONS = {
    "<": lambda a, b: a < b,
    "<=": lambda a, b: a <= b,
    ">": lambda a, b: a > b,
    ">=": lambda a, b: a >= b,
    "!=": lambda a, b: a != b,
    "==": lambda a, b: a == b,
}


def compare(relation, a, a_type, b, b_type):
    of = common(a_type, b_type)
    return int(RELATIONS[relation](convert(a, of), convert(b, of)))


def halve(value):
    return -(-value // 2) if value < 0 else value // 2
