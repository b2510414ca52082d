"""The assembler subset of TECHNOL (specification 6.9) as plain arithmetic, written apart from plcxx.

Each function gives a result and the flags that are defined behind the instruction: C carry, Z zero, S sign, O overflow,
A auxiliary carry. A flag that is not in the dictionary is undefined.
"""
MASK = {8: 0xFF, 16: 0xFFFF, 32: 0xFFFFFFFF}


def signed(value, n):
    return value - (1 << n) if value >> (n - 1) else value


def zero_sign(result, n):
    return {"Z": int(result == 0), "S": result >> (n - 1)}


def fits(value, n):
    return -(1 << (n - 1)) <= value < 1 << (n - 1)


def add(a, b, n, carry=0):
    total = a + b + carry
    result = total & MASK[n]
    overflow = int(not fits(signed(a, n) + signed(b, n) + carry, n))
    return result, {"C": total >> n, "O": overflow, "A": int((a & 15) + (b & 15) + carry > 15), **zero_sign(result, n)}


def sub(a, b, n, borrow=0):
    total = a - b - borrow
    result = total & MASK[n]
    overflow = int(not fits(signed(a, n) - signed(b, n) - borrow, n))
    half = int((a & 15) - (b & 15) - borrow < 0)
    return result, {"C": int(total < 0), "O": overflow, "A": half, **zero_sign(result, n)}


def logic(result, n):
    return result, {"C": 0, "O": 0, **zero_sign(result, n)}


def neg(value, n):
    result = -value & MASK[n]
    flags = {"C": int(value != 0), "O": int(value == 1 << (n - 1)), "A": int(value & 15 != 0)}
    return result, {**flags, **zero_sign(result, n)}


def shift(name, d, count, n, flags):
    """SHL, SHR, SAR; `count` of 0 to 31."""
    if count == 0:
        return d, dict(flags)
    original, carry = d, 0
    for _ in range(count):
        if name == "SHL":
            carry, d = d >> (n - 1), (d * 2) & MASK[n]
        elif name == "SHR":
            carry, d = d & 1, d >> 1
        else:
            carry, d = d & 1, (d >> 1) | (d & (1 << (n - 1)))
    result = {"C": carry, **zero_sign(d, n)}
    if count == 1:
        result["O"] = {"SHL": (d >> (n - 1)) ^ carry, "SHR": original >> (n - 1), "SAR": 0}[name]
    return d, result


def rotate(name, d, count, n, flags):
    """ROL, ROR, RCL, RCR; `count` of 0 to 31. Z, S and A stay as they were."""
    through_carry = name[1] == "C"
    if count == 0 and not through_carry:
        return d, dict(flags)
    carry = flags["C"] if through_carry else 0
    top = n - 1
    for _ in range(count % (n + 1) if through_carry else count % n):
        if name[2] == "L":
            out = d >> top
            d = ((d << 1) & MASK[n]) | (carry if through_carry else out)
        else:
            out = d & 1
            d = (d >> 1) | ((carry if through_carry else out) << top)
        carry = out
    if not through_carry:
        carry = d & 1 if name == "ROL" else d >> top
    result = {flag: flags[flag] for flag in "ZSA" if flag in flags}
    result["C"] = carry
    if count == 1:
        result["O"] = (d >> top) ^ (carry if name[2] == "L" else (d >> (n - 2)) & 1)
    return d, result


def multiply(name, a, b, n):
    """The product of 2 n bits."""
    if name == "MUL":
        product = a * b
        large = int(product >> n != 0)
    else:
        product = signed(a, n) * signed(b, n)
        large = int(not fits(product, n))
    return product & ((1 << 2 * n) - 1), {"C": large, "O": large}


def divide(name, a, b, n):
    """Quotient and remainder of 2 n by n bits; all ones or 80...0 and 0 where there is no quotient of n bits."""
    if name == "DIV":
        if b == 0 or a // b > MASK[n]:
            return MASK[n], 0
        return a // b, a % b
    dividend, divisor = signed(a, 2 * n), signed(b, n)
    if divisor == 0:
        return 1 << (n - 1), 0
    quotient = abs(dividend) // abs(divisor) * (-1 if (dividend < 0) != (divisor < 0) else 1)
    if not fits(quotient, n):
        return 1 << (n - 1), 0
    return quotient & MASK[n], (dividend - quotient * divisor) & MASK[n]


def adjust(name, al, flags):
    """DAA, DAS."""
    old, carry = al, flags["C"]
    step = -1 if name == "DAS" else 1
    new_carry = 0
    half = int((al & 15) > 9 or flags["A"] == 1)
    if half:
        new_carry = int(name == "DAS" and (carry == 1 or al < 6))
        al = (al + 6 * step) & 0xFF
    if old > 0x99 or carry:
        al = (al + 0x60 * step) & 0xFF
        new_carry = 1
    return al, {"C": new_carry, "A": half, **zero_sign(al, 8)}
