// C with 16-bit int as an interpreter of single operations, to run programs of dialect hnc without plcxx.
//
// Written from the specification alone (layouts 5.6, conversions 6.1, operators 6.2, faults 6.9), and sharing nothing
// with plcxx: values carry their type at run time, objects are little-endian bytes with a length. generate.py spells a
// program twice, as C for plcxx and as calls of these functions; both must leave the same memory.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>

namespace borland {

enum class Type : uint8_t { kChar, kUchar, kInt, kUnsigned, kLong, kUlong, kFloat, kDouble };

inline int fault_code = 0;

inline void Fault(int code) { fault_code = code; }

inline int Size(Type type) {
  switch (type) {
    case Type::kChar:
    case Type::kUchar:
      return 1;
    case Type::kInt:
    case Type::kUnsigned:
      return 2;
    case Type::kLong:
    case Type::kUlong:
    case Type::kFloat:
      return 4;
    case Type::kDouble:
      return 8;
  }
  return 0;
}

inline bool IsFloating(Type type) { return type == Type::kFloat || type == Type::kDouble; }

/// The low bits of `number`, read as the integer type.
inline int64_t Wrap(Type type, int64_t number) {
  switch (type) {
    case Type::kChar:
      return static_cast<int8_t>(number);
    case Type::kUchar:
      return static_cast<uint8_t>(number);
    case Type::kInt:
      return static_cast<int16_t>(number);
    case Type::kUnsigned:
      return static_cast<uint16_t>(number);
    case Type::kLong:
      return static_cast<int32_t>(number);
    case Type::kUlong:
      return static_cast<uint32_t>(number);
    case Type::kFloat:
    case Type::kDouble:
      break;
  }
  return number;
}

/// A value with its type; `real` counts for floating types only, `whole` for the others.
struct Value {
  Type type = Type::kInt;
  int64_t whole = 0;
  double real = 0;

  bool Truth() const { return IsFloating(type) ? real != 0 : whole != 0; }
};

inline Value Whole(Type type, int64_t number) { return {type, Wrap(type, number), 0}; }
inline Value Real(double number) { return {Type::kDouble, 0, number}; }
inline Value Bool(bool truth) { return Whole(Type::kInt, truth ? 1 : 0); }

inline double AsReal(const Value& value) {
  return IsFloating(value.type) ? value.real : static_cast<double>(value.whole);
}

inline Value Convert(Type type, const Value& value) {
  if (type == Type::kFloat) return {type, 0, static_cast<double>(static_cast<float>(AsReal(value)))};
  if (type == Type::kDouble) return Real(AsReal(value));
  if (!IsFloating(value.type)) return Whole(type, value.whole);
  const bool fits = std::fabs(value.real) < 9223372036854775808.0;  // false for a NaN, too
  return Whole(type, fits ? static_cast<int64_t>(value.real) : 0);
}

/// Integer promotion; a float becomes a double, as every operator wants it.
inline Value Promote(const Value& value) {
  if (value.type == Type::kChar || value.type == Type::kUchar) return Whole(Type::kInt, value.whole);
  if (value.type == Type::kFloat) return Real(value.real);
  return value;
}

inline Type Common(Type a, Type b) {
  if (IsFloating(a) || IsFloating(b)) return Type::kDouble;
  for (const Type type : {Type::kUlong, Type::kLong, Type::kUnsigned}) {
    if (a == type || b == type) return type;
  }
  return Type::kInt;
}

enum class Op : uint8_t { kAdd, kSub, kMul, kDiv, kMod, kAnd, kOr, kXor, kShl, kShr, kLt, kLe, kGt, kGe, kEq, kNe };

inline Value Divided(Type type, int64_t a, int64_t b, bool remainder) {
  if (b == 0) {
    Fault(1);
    return Whole(type, 0);
  }
  if (type == Type::kInt && a == -32768 && b == -1) Fault(1);
  return Whole(type, remainder ? a % b : a / b);  // 64 bits hold every quotient
}

inline Value Shifted(const Value& left, const Value& right, bool to_the_left) {
  int64_t count = right.whole & 0xFF;
  const bool small = Size(left.type) == 2;
  if (small) count %= 32;
  if (count >= (small ? 16 : 32)) return Whole(left.type, !to_the_left && left.whole < 0 ? -1 : 0);
  if (to_the_left) return Whole(left.type, static_cast<int64_t>(static_cast<uint64_t>(left.whole) << count));
  return Whole(left.type, left.whole >> count);
}

inline Value RealBinary(Op op, double a, double b) {
  switch (op) {
    case Op::kAdd:
      return Real(a + b);
    case Op::kSub:
      return Real(a - b);
    case Op::kMul:
      return Real(a * b);
    case Op::kDiv:
      return Real(a / b);
    case Op::kLt:
      return Bool(a < b);
    case Op::kLe:
      return Bool(a <= b);
    case Op::kGt:
      return Bool(a > b);
    case Op::kGe:
      return Bool(a >= b);
    case Op::kEq:
      return Bool(a == b);
    default:
      return Bool(a != b);
  }
}

inline Value WholeBinary(Op op, Type type, int64_t a, int64_t b) {
  switch (op) {
    case Op::kAdd:
      return Whole(type, a + b);
    case Op::kSub:
      return Whole(type, a - b);
    case Op::kMul:
      return Whole(type, static_cast<int64_t>(static_cast<uint64_t>(a) * static_cast<uint64_t>(b)));
    case Op::kDiv:
      return Divided(type, a, b, false);
    case Op::kMod:
      return Divided(type, a, b, true);
    case Op::kAnd:
      return Whole(type, a & b);
    case Op::kOr:
      return Whole(type, a | b);
    case Op::kXor:
      return Whole(type, a ^ b);
    case Op::kLt:
      return Bool(a < b);
    case Op::kLe:
      return Bool(a <= b);
    case Op::kGt:
      return Bool(a > b);
    case Op::kGe:
      return Bool(a >= b);
    case Op::kEq:
      return Bool(a == b);
    default:
      return Bool(a != b);
  }
}

/// `Binary{left, op, right}()`: braces evaluate from left to right, as the dialect does.
struct Binary {
  Value left;
  Op op;
  Value right;

  Value operator()() const {
    const Value a = Promote(left), b = Promote(right);
    if (op == Op::kShl || op == Op::kShr) return Shifted(a, b, op == Op::kShl);
    const Type type = Common(a.type, b.type);
    const Value x = Convert(type, a), y = Convert(type, b);
    return IsFloating(type) ? RealBinary(op, x.real, y.real) : WholeBinary(op, type, x.whole, y.whole);
  }
};

inline Value Minus(const Value& value) {
  const Value v = Promote(value);
  return IsFloating(v.type) ? Real(-v.real) : Whole(v.type, -v.whole);
}
inline Value Complement(const Value& value) {
  const Value v = Promote(value);
  return Whole(v.type, ~v.whole);
}
inline Value Not(const Value& value) { return Bool(!value.Truth()); }

/// Bytes of a variable or of a register area.
struct Object {
  uint8_t* bytes;
  int64_t size;
};

/// Where a value is stored; no bytes: outside its object.
struct Place {
  uint8_t* bytes = nullptr;
  Type type = Type::kInt;
};

inline Place At(const Object& object, Type type, int64_t offset) {
  const bool inside = offset >= 0 && offset + Size(type) <= object.size;
  return {inside ? object.bytes + offset : nullptr, type};
}

/// Element `index` counted from `offset` bytes.
inline Place Element(const Object& object, Type type, int64_t offset, const Value& index) {
  return At(object, type, offset + index.whole * Size(type));
}

inline Value Read(const Place& place) {
  if (place.bytes == nullptr) {
    Fault(2);
    return IsFloating(place.type) ? Value{place.type, 0, 0} : Whole(place.type, 0);
  }
  uint64_t bits = 0;
  for (int i = Size(place.type) - 1; i >= 0; --i) bits = bits << 8 | place.bytes[i];
  if (place.type == Type::kFloat) {
    float number = 0;
    __builtin_memcpy(&number, &bits, 4);
    return {place.type, 0, static_cast<double>(number)};
  }
  if (place.type == Type::kDouble) {
    double number = 0;
    __builtin_memcpy(&number, &bits, 8);
    return Real(number);
  }
  return Whole(place.type, static_cast<int64_t>(bits));
}

/// Whether an access outside its object has been told by a read of the same operator: `a += b` and `++` are one access.
enum class Told : uint8_t { kNotYet, kByRead };

/// Stores, and gives the stored value in the place's type.
inline Value Store(const Place& place, const Value& value, Told told = Told::kNotYet) {
  const Value stored = Convert(place.type, value);
  if (place.bytes == nullptr) {
    if (told == Told::kNotYet) Fault(2);
    return stored;
  }
  uint64_t bits = static_cast<uint64_t>(stored.whole);
  if (place.type == Type::kFloat) {
    const auto number = static_cast<float>(stored.real);
    __builtin_memcpy(&bits, &number, 4);
  } else if (place.type == Type::kDouble) {
    __builtin_memcpy(&bits, &stored.real, 8);
  }
  for (int i = 0; i < Size(place.type); ++i) place.bytes[i] = static_cast<uint8_t>(bits >> (8 * i));
  return stored;
}

/// `a = b` of structures.
inline void Copy(const Object& to, int64_t to_offset, const Object& from, int64_t from_offset, int64_t size) {
  __builtin_memmove(to.bytes + to_offset, from.bytes + from_offset, static_cast<size_t>(size));
}

/// A bit-field: `width` bits from `shift` on in a unit of one or two bytes.
struct Field {
  uint8_t* unit;
  int bytes, shift, width;
  bool is_signed;
};

inline int64_t UnitOf(const Field& field) {
  return field.bytes == 1 ? field.unit[0] : field.unit[0] | field.unit[1] << 8;
}

inline Value Read(const Field& field) {
  int64_t bits = UnitOf(field) >> field.shift & ((1 << field.width) - 1);
  if (field.is_signed && (bits >> (field.width - 1)) != 0) bits -= int64_t{1} << field.width;
  return Whole(!field.is_signed && field.width == 16 ? Type::kUnsigned : Type::kInt, bits);
}

inline Value Store(const Field& field, const Value& value, Told /*told*/ = Told::kNotYet) {
  const int64_t mask = ((int64_t{1} << field.width) - 1) << field.shift;
  const int64_t bits = Convert(Type::kLong, value).whole << field.shift & mask;
  const int64_t unit = (UnitOf(field) & ~mask) | bits;
  field.unit[0] = static_cast<uint8_t>(unit);
  if (field.bytes == 2) field.unit[1] = static_cast<uint8_t>(unit >> 8);
  return Read(field);
}

/// `place = value`: the right side comes first, so `place` is a function that finds the place.
template <class Where>
Value Assign(const Value& value, Where place) {
  return Store(place(), value);
}

template <class Where>
Value AssignOp(const Value& value, Op op, Where where) {
  const auto place = where();
  return Store(place, Binary{Read(place), op, value}(), Told::kByRead);
}

template <class Where>
Value Before(Where where, int step) {  // ++x, --x
  return AssignOp(Whole(Type::kInt, step), Op::kAdd, where);
}

template <class Where>
Value After(Where where, int step) {  // x++, x--
  const auto place = where();
  const Value old = Read(place);
  Store(place, Binary{old, Op::kAdd, Whole(Type::kInt, step)}(), Told::kByRead);
  return old;
}

}  // namespace borland
