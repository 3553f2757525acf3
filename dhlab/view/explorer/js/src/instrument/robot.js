// The links of a URDF with their meshes, placed at joint values 0: {name, file, scale, pose, joint}; `joint` counts the moving joints before the link.

import { IDENTITY, axis, origin, poseOf, product } from "../matrix.js";

const numbers = (element, name, otherwise) => (element?.getAttribute(name)?.trim().split(/\s+/).map(Number) ?? otherwise);
const placeOf = (element) => {
  const at = element?.querySelector(":scope > origin");
  return at ? poseOf(numbers(at, "xyz", [0, 0, 0]), numbers(at, "rpy", [0, 0, 0])) : IDENTITY;
};

// A mesh in another format is looked for as an STL file of the same name.
// `many` joints move the arm: the chain with so many is taken, and what hangs beside it goes with the joint it hangs on. Null where there is none.
export function robot(text, many) {
  const root = new DOMParser().parseFromString(text, "text/xml").documentElement;
  if (root.tagName !== "robot") return null;
  const joints = [...root.querySelectorAll(":scope > joint")].map((joint) => ({
    parent: joint.querySelector("parent")?.getAttribute("link"), child: joint.querySelector("child")?.getAttribute("link"), place: placeOf(joint),
    moves: ["revolute", "continuous", "prismatic"].includes(joint.getAttribute("type")) && !joint.querySelector("mimic"), axis: numbers(joint.querySelector("axis"), "xyz", [1, 0, 0]),
  }));
  const children = new Set(joints.map((joint) => joint.child)), first = [...root.querySelectorAll(":scope > link")].find((link) => !children.has(link.getAttribute("name")));
  const links = [], axes = [];
  const walk = (name, T, count) => {
    for (const visual of root.querySelectorAll(`:scope > link[name="${CSS.escape(name)}"] > visual`)) {
      const mesh = visual.querySelector("geometry > mesh");
      if (mesh) links.push({ file: mesh.getAttribute("filename").split(/[/\\]/).pop().toLowerCase().replace(/\.(dae|obj)$/, ".stl"), scale: numbers(mesh, "scale", [1, 1, 1]), pose: product(T, placeOf(visual)), joint: Math.min(count, many) });
    }
    for (const joint of joints.filter((one) => one.parent === name)) {
      const at = product(T, joint.place), next = count + Number(joint.moves);
      if (joint.moves && next <= many && !axes[next - 1]) axes[next - 1] = { at: origin(at), along: [0, 1, 2].map((r) => joint.axis.reduce((sum, v, k) => sum + v * axis(at, k)[r], 0)) };
      walk(joint.child, at, next);
    }
  };
  if (first) walk(first.getAttribute("name"), IDENTITY, 0);
  return { links, axes: axes.filter(Boolean) };
}
