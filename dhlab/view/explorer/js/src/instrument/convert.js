// One arm in the other convention: the same theta and d, a and alpha one row on, and what is left over in base and tool.

import { move } from "../kinematics.js";
import { inverse, product } from "../matrix.js";

// `arm` in the convention `to`, with the same pose for every q; the arm itself where it has it already.
export function converted(arm, to) {
  if (arm.convention === to) return structuredClone(arm);
  const craig = to === "craig", n = arm.rows.length, links = arm.rows.map(([, , a, alpha]) => [a, alpha]);
  const [spare] = craig ? links.splice(n - 1, 1) : links.splice(0, 1), left = arm.spare ?? [0, 0];
  links.splice(craig ? 0 : n - 1, 0, left);
  const side = ([a, alpha]) => product(move("a", a), move("alpha", alpha));
  return {
    ...arm, convention: to, spare, rows: arm.rows.map(([theta, d], i) => [theta, d, ...links[i]]),
    base: product(arm.base, craig ? inverse(side(left)) : side(spare)),
    tool: product(craig ? side(spare) : inverse(side(left)), arm.tool),
  };
}
