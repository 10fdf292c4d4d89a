/// What a program has that another has not. The chapters' programs are nine tenths the same code, so one of them is stored whole, and
/// each as what differs from it: parts of the other, by place and length, and the bytes between them. tools/book/live/engine.js joins
/// them again.
const least = 12; // bytes: a shorter part is stored as it is
const tries = 48; // places that are compared
const bits = 20;

/// Bytes: how long the list of parts is, the list, and the bytes between them one after the other. Of each part how many bytes come
/// before it, its length, and how far behind the end of the part before it stands.
export function difference(from, to) {
  const { first, next } = places(from);
  const parts = [];
  const between = [];
  let done = 0; // of `to`
  let end = 0; // of the last part, in `from`
  const lengthAt = (place, at) => {
    let length = 0;
    while (place + length < from.length && at + length < to.length && from[place + length] === to[at + length])
      ++length;
    return length;
  };
  for (let at = 0; at + least <= to.length;) {
    let place = end + at - done; // after a change of a few bytes both go on alike
    let length = place < from.length ? lengthAt(place, at) : 0;
    for (let other = first[hash(to, at)], left = tries; other >= 0 && left > 0; other = next[other], --left) {
      const found = lengthAt(other, at);
      if (found > length) [place, length] = [other, found];
    }
    if (length < least) {
      ++at;
      continue;
    }
    for (; at > done && place > 0 && from[place - 1] === to[at - 1]; --at, --place) ++length;
    between.push(to.subarray(done, at));
    parts.push(...varying(at - done), ...varying(length), ...varying(zigzag(place - end)));
    done = at = at + length;
    end = place + length;
  }
  return Buffer.concat([Buffer.from(varying(parts.length)), Buffer.from(parts), ...between, to.subarray(done)]);
}

const hash = (bytes, at) => {
  let value = 0;
  for (let i = 0; i < least; ++i) value = Math.imul(value ^ bytes[at + i], 0x9e3779b1) ^ (value >>> 15);
  return value >>> (32 - bits);
};

/// Where each of these hashes stands last, and before that.
function places(bytes) {
  const first = new Int32Array(1 << bits).fill(-1);
  const next = new Int32Array(bytes.length);
  for (let at = 0; at + least <= bytes.length; ++at) {
    const value = hash(bytes, at);
    next[at] = first[value];
    first[value] = at;
  }
  return { first, next };
}

const zigzag = (number) => (number < 0 ? -2 * number - 1 : 2 * number);

/// Seven bits a byte, the lowest first; the eighth says that another follows.
function varying(number) {
  const bytes = [];
  for (; number > 127; number >>>= 7) bytes.push((number & 127) | 128);
  return [...bytes, number];
}
