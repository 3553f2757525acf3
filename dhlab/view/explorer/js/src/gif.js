// Pictures one after the other as a GIF, which every browser and chat shows; loaded when somebody asks for one.

/*! Contains gifenc 1.0.3 under the MIT License.

   Copyright (c) 2017 Matt DesLauriers

   Permission is hereby granted, free of charge, to any person obtaining a copy
   of this software and associated documentation files (the "Software"), to deal
   in the Software without restriction, including without limitation the rights
   to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
   copies of the Software, and to permit persons to whom the Software is
   furnished to do so, subject to the following conditions:

   The above copyright notice and this permission notice shall be included in all
   copies or substantial portions of the Software.

   THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND,
   EXPRESS OR IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF
   MERCHANTABILITY, FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT.
   IN NO EVENT SHALL THE AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM,
   DAMAGES OR OTHER LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR
   OTHERWISE, ARISING FROM, OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE
   OR OTHER DEALINGS IN THE SOFTWARE. */
import { GIFEncoder, applyPalette, quantize } from "gifenc/dist/gifenc.esm.js";

const COLORS = 255; // and one that says: as in the picture before

// `pictures` yields ImageData of one size, each shown for `delay` ms and the last one for `rest`; the colours are those of the first.
export async function gif(pictures, delay, rest) {
  const made = GIFEncoder();
  let palette, before, waiting;
  const give = (ms) => waiting && made.writeFrame(waiting.index, waiting.width, waiting.height, { palette: waiting.palette, delay: ms, transparent: true, transparentIndex: palette.length, dispose: 1 });
  for await (const { data, width, height } of pictures) {
    give(delay);
    palette ??= quantize(data, COLORS);
    const whole = applyPalette(data, palette);
    waiting = before ? { index: whole.map((color, i) => (color === before[i] ? palette.length : color)), width, height } : { index: whole, width, height, palette: [...palette, [0, 0, 0]] };
    before = whole;
  }
  give(rest);
  made.finish();
  return made.bytes();
}
