/// What a program has that another has not. The chapters' programs are mostly the same code, so one of them is stored whole, and each
/// as what differs from another: parts of the other, by place and length, the few bytes that differ within a part (a call names its
/// function by a number, and one function more moves all the numbers after it), and the bytes between the parts.
/// tools/book/live/engine.js joins them again.
const seed = 12; // bytes that are alike where a part is found
const least = 20; // a part that is worth less is stored as it is
const wrong = 2; // a byte that is alike makes a part worth 1 more, one that differs this much less
const patience = 24; // how far the worth may fall before the search for the part's end gives up
const tries = 48; // places that are compared
const bits = 20;

/// Bytes: how long the list of parts is, the list, what is added to each byte of the parts (modulo 256; almost all are 0, which
/// compresses to nothing), and the bytes between the parts. Of each part the list has how many bytes come before it, its length, and
/// how far behind the end of the part before it stands.
export function difference(from, to) {
  const { first, next } = places(from);
  const parts = [];
  const added = [];
  const between = [];
  let done = 0; // of `to`
  let end = 0; // of the last part, in `from`
  for (let at = 0; at + seed <= to.length;) {
    let place = end + at - done; // after a change of a few bytes both go on alike
    let ahead = alike(from, to, place, at, 1);
    for (let other = first[hash(to, at)], left = tries; other >= 0 && left > 0; other = next[other], --left) {
      const found = alike(from, to, other, at, 1);
      if (found.worth > ahead.worth) [place, ahead] = [other, found];
    }
    if (ahead.worth < least) {
      ++at;
      continue;
    }
    const before = Math.min(alike(from, to, place - 1, at - 1, -1).length, at - done);
    const start = at - before;
    const length = before + ahead.length;
    place -= before;
    between.push(to.subarray(done, start));
    parts.push(...varying(start - done), ...varying(length), ...varying(zigzag(place - end)));
    added.push(to.subarray(start, start + length).map((byte, i) => byte - from[place + i]));
    done = at = start + length;
    end = place + length;
  }
  return Buffer.concat([
    Buffer.from(varying(parts.length)),
    Buffer.from(parts),
    ...added,
    ...between,
    to.subarray(done),
  ]);
}

/// How many bytes from here on, forwards (1) or backwards (-1), are worth the most as one part: {length, worth}.
function alike(from, to, place, at, way) {
  const best = { length: 0, worth: 0 };
  let worth = 0;
  for (let i = 0; worth >= best.worth - patience; ++i) {
    const [one, other] = [from[place + way * i], to[at + way * i]];
    if (one === undefined || other === undefined) break;
    worth += one === other ? 1 : -wrong;
    if (worth > best.worth) Object.assign(best, { length: i + 1, worth });
  }
  return best;
}

const hash = (bytes, at) => {
  let value = 0;
  for (let i = 0; i < seed; ++i) value = Math.imul(value ^ bytes[at + i], 0x9e3779b1) ^ (value >>> 15);
  return value >>> (32 - bits);
};

/// Where each of these hashes stands last, and before that.
function places(bytes) {
  const first = new Int32Array(1 << bits).fill(-1);
  const next = new Int32Array(bytes.length);
  for (let at = 0; at + seed <= bytes.length; ++at) {
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
