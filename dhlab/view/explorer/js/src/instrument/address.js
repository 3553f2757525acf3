// The state as the part of an address behind #: q=30,-60,…&convention=craig&rows=0,162.5,0,90;… in degrees and millimetres.

import { DEGREE } from "../format.js";
import { COLUMNS, isTurn } from "../kinematics.js";

const unit = (letter) => (letter === "P" ? 1000 : DEGREE);
const factors = COLUMNS.map((kind) => (isTurn(kind) ? DEGREE : 1000));
const short = (value, digits) => String(Number(value.toFixed(digits)) + 0);

export function written(arm, q, changed) {
  const parts = [`q=${q.map((v, i) => short(v * unit(arm.joints[i]), 3)).join(",")}`, `convention=${arm.convention}`];
  if (changed) parts.push(`rows=${arm.rows.map((row) => row.map((v, k) => short(v * factors[k], 7)).join(",")).join(";")}`);
  return parts.join("&");
}

// {q, rows, convention}, each where the address has it in the shape that the arm has; null where it says nothing of an arm.
export function read(address, arm) {
  const said = new URLSearchParams(address), n = arm.rows.length, numbers = (text) => text.split(",").map((part) => (part.trim() === "" ? NaN : Number(part)));
  const fits = (values, many) => values.length === many && values.every(Number.isFinite);
  const q = said.has("q") ? numbers(said.get("q")) : [], rows = said.has("rows") ? said.get("rows").split(";").map(numbers) : [];
  if (!fits(q, n)) return null;
  return {
    q: q.map((v, i) => v / unit(arm.joints[i])),
    rows: rows.length === n && rows.every((row) => fits(row, 4)) ? rows.map((row) => row.map((v, k) => v / factors[k])) : null,
    convention: ["standard", "craig"].includes(said.get("convention")) ? said.get("convention") : arm.convention,
  };
}
