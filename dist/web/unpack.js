// Unpacks LZMA (https://www.7-zip.org/sdk.html, lzma.txt) with lc = 4, lp = pb = 0 and a known size, as dist/web/assemble.py packs.
// The browser's own packings, gzip and deflate, make the program a third larger.
function cameraLabUnpack(packed) {
  const LITERAL_BITS = 4, TOP = 0x1000000;
  const out = new Uint8Array(new DataView(packed.buffer, packed.byteOffset).getUint32(5, true));
  // A probability of 11 bits for each decision; each kind of decision has its place here.
  const MATCH = 0, REP = 16, REP0 = 32, REP1 = 48, REP2 = 64, LONG = 80, SLOT = 96, FAR = 352, ALIGN = 480;
  const LENGTH = 496, REP_LENGTH = 1024, LITERAL = 1552;
  const odds = new Uint16Array(LITERAL + (0x300 << LITERAL_BITS)).fill(1024);
  const coder = Uint32Array.of(0xFFFFFFFF, 0);
  let at = 13, size = 0, state = 0, rep0 = 0, rep1 = 0, rep2 = 0, rep3 = 0;
  for (let k = 0; k < 5; k++) coder[1] = coder[1] << 8 | packed[at++];
  function bit(place) {
    const odd = odds[place], bound = (coder[0] >>> 11) * odd;
    let one = 0, range = bound;
    if (coder[1] < bound) {
      odds[place] = odd + (2048 - odd >> 5);
    } else {
      range = coder[0] - bound;
      coder[1] -= bound;
      odds[place] = odd - (odd >> 5);
      one = 1;
    }
    coder[0] = range;
    if (range < TOP) {
      coder[0] = range << 8;
      coder[1] = coder[1] << 8 | packed[at++];
    }
    return one;
  }
  // The most significant bit first.
  function bits(place, count) {
    let tree = 1;
    for (let k = 0; k < count; k++) tree = tree << 1 | bit(place + tree);
    return tree - (1 << count);
  }
  // The least significant bit first.
  function reversed(place, count) {
    let tree = 1, value = 0;
    for (let k = 0; k < count; k++) {
      const b = bit(place + tree);
      tree = tree << 1 | b;
      value |= b << k;
    }
    return value;
  }
  function length(place) {
    if (!bit(place)) return bits(place + 2, 3);
    return bit(place + 1) ? 16 + bits(place + 258, 8) : 8 + bits(place + 130, 3);
  }
  function distance(long) {
    const slot = bits(SLOT + (Math.min(long, 3) << 6), 6);
    if (slot < 4) return slot;
    const direct = (slot >> 1) - 1, far = (2 | slot & 1) << direct;
    if (slot < 14) return far + reversed(FAR + far - slot, direct);
    let value = 0;
    for (let k = 4; k < direct; k++) {
      const range = coder[0] >>> 1, one = coder[1] >= range ? 1 : 0;
      coder[0] = range;
      if (one) coder[1] -= range;
      value = value << 1 | one;
      if (range < TOP) {
        coder[0] = range << 8;
        coder[1] = coder[1] << 8 | packed[at++];
      }
    }
    return far + (value << 4) + reversed(ALIGN, 4);
  }
  while (size < out.length) {
    if (!bit(MATCH + state)) {
      const literal = LITERAL + 0x300 * ((size ? out[size - 1] : 0) >> 8 - LITERAL_BITS);
      let symbol = 1;
      if (state >= 7) {
        let matched = out[size - rep0 - 1];
        while (symbol < 0x100) {
          const expected = matched >> 7 & 1, found = bit(literal + (1 + expected << 8) + symbol);
          matched <<= 1;
          symbol = symbol << 1 | found;
          if (expected !== found) break;
        }
      }
      while (symbol < 0x100) symbol = symbol << 1 | bit(literal + symbol);
      out[size++] = symbol;
      state = state < 4 ? 0 : state < 10 ? state - 3 : state - 6;
      continue;
    }
    let long;
    if (!bit(REP + state)) {
      [rep3, rep2, rep1] = [rep2, rep1, rep0];
      long = length(LENGTH);
      state = state < 7 ? 7 : 10;
      rep0 = distance(long);
    } else {
      if (!bit(REP0 + state)) {
        if (!bit(LONG + state)) {
          state = state < 7 ? 9 : 11;
          out[size] = out[size - rep0 - 1];
          size++;
          continue;
        }
      } else {
        let far = rep1;
        if (bit(REP1 + state)) {
          far = rep2;
          if (bit(REP2 + state)) {
            far = rep3;
            rep3 = rep2;
          }
          rep2 = rep1;
        }
        rep1 = rep0;
        rep0 = far;
      }
      long = length(REP_LENGTH);
      state = state < 7 ? 8 : 11;
    }
    if (rep0 >= size) throw new Error('damaged');
    for (const end = Math.min(size + long + 2, out.length); size < end; size++) out[size] = out[size - rep0 - 1];
  }
  return out;
}

// Starts the program, once its packed bytes are there.
async function cameraLabStart(packed) {
  await wasm_bindgen({ module_or_path: cameraLabUnpack(new Uint8Array(await packed)).buffer });
}
