// Values as people read them: bit, decimal, signed, hexadecimal, BCD, characters.

export const bases = ["dec", "signed", "hex", "bin", "bcd", "ascii"];
const widths = { bit: 1, i8: 8, i16: 16, i32: 32, i64: 64, f32: 32, f64: 64 };

function floatOf(bits, type) {
  const view = new DataView(new ArrayBuffer(8));
  if (type === "f32") {
    view.setUint32(0, Number(bits));
    return view.getFloat32(0);
  }
  view.setBigUint64(0, bits);
  return view.getFloat64(0);
}

export function baseOf(type, isSigned) {
  if (type === "f32" || type === "f64") return "float";
  return type === "bit" ? "bit" : isSigned ? "signed" : "dec";
}

export function format(value, type, base) {
  if (value === undefined || value === null) return "–";
  if (!(type in widths)) return String(value);  // an instance says it in words
  const bits = BigInt(value);
  const width = widths[type];
  switch (base) {
    case "float":
      return String(floatOf(bits, type));
    case "bit":
      return String(bits & 1n);
    case "signed":
      return String(BigInt.asIntN(width, bits));
    case "hex":
      return bits.toString(16).toUpperCase().padStart(Math.ceil(width / 4), "0") + "H";
    case "bin":
      return bits.toString(2).padStart(width, "0").replace(/(?=(?:.{4})+$)/g, " ").trim();
    case "bcd": {
      const digits = bits.toString(16).padStart(Math.ceil(width / 4), "0");
      return /^[0-9]*$/.test(digits) ? digits : digits.toUpperCase() + " is no BCD";
    }
    case "ascii": {
      let text = "";
      for (let shift = width - 8; shift >= 0; shift -= 8) {
        const code = Number((bits >> BigInt(shift)) & 0xffn);
        text += code >= 32 && code < 127 ? String.fromCharCode(code) : "·";
      }
      return "'" + text + "'";
    }
    default:
      return String(bits);
  }
}

export function timeText(ms) {
  if (ms < 10000) return ms + " ms";
  const seconds = Math.floor(ms / 1000);
  const two = (number) => String(number).padStart(2, "0");
  return (
    (seconds >= 3600 ? Math.floor(seconds / 3600) + ":" + two(Math.floor(seconds / 60) % 60) : Math.floor(seconds / 60)) +
    ":" + two(seconds % 60) + "." + String(ms % 1000).padStart(3, "0")
  );
}
