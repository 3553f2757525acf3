// A motion through kept configurations, seen with its trace: joint-straight, hand-straight, or both beside each other; and saved as a video or a GIF.

import { drawBody } from "../bodies.js";
import { button, choice } from "../controls.js";
import { h, write } from "../dom.js";
import { endOf, forward, frames } from "../kinematics.js";
import { origin } from "../matrix.js";
import { save, taker } from "./out.js";
import { STEPS, path } from "./path.js";

const SECONDS = 2.5; // for a stretch
const TYPES = ["video/webm;codecs=vp9", "video/webm", "video/mp4"];
const EVERY = 3, WIDEST = 640, REST = 1200; // of a GIF: steps from picture to picture, pixels, ms at its end

export class Motion {
  constructor({ stage, mode, host }, name) {
    Object.assign(this, { stage, mode, host, arm: host.data.arm, poses: [host.get("q")], way: "joints", running: 0, shown: null });
    this.said = h("p", { role: "status" });
    this.playing = button("Play", () => this.play());
    this.type = TYPES.find((one) => globalThis.MediaRecorder?.isTypeSupported(one));
    this.saving = [...(this.type ? [button("Save as a video", () => this.record(name()))] : []), button("Save as a GIF", () => this.animate(name()))];
    const ways = choice("Between two poses", "way", [["joints", "Each joint straight"], ["hand", "The hand straight"], ["both", "Both"]], "joints", (way) => {
      this.way = way;
      this.plan();
    });
    this.element = h("details", { class: "edit motion" }, h("summary", {}, "Play a motion"), h("div", { class: "below" },
      h("p", { class: "hint" }, "Move the arm and keep the pose, as often as you like; then play."),
      h("div", { class: "give" }, button("Keep this pose", () => this.keep()), button("Forget the poses", () => this.forget()), this.playing, ...this.saving), ways.element, this.said));
    this.plan();
  }

  keep() {
    this.poses.push(this.host.get("q"));
    this.plan();
  }

  forget() {
    this.poses = [this.host.get("q")];
    this.plan();
  }

  allow(ready) {
    this.playing.disabled = !ready;
    for (const one of this.saving) one.disabled = !ready || !this.stage.works;
  }

  // Both ways through the poses, and what is to be said of them.
  plan() {
    cancelAnimationFrame(this.running);
    const ready = this.poses.length > 1, { arm, poses, mode: { size } } = this;
    this.allow(ready);
    this.ways = ready ? { joints: path(arm, poses, "joints", size), hand: path(arm, poses, "hand", size) } : null;
    if (this.ways) for (const one of Object.values(this.ways)) one.trace = one.qs.map((q) => origin(forward(arm, q)));
    this.shown = null;
    write(this.said, ready ? this.words() : "One pose is kept.");
    this.stage.redraw();
  }

  words() {
    const { faults } = this.ways.hand, all = `${this.poses.length} poses are kept.`;
    if (this.way === "joints") return all;
    const said = faults.slice(0, 3).map(({ kind, step, joint, part }) => {
      const stretch = `from pose ${Math.floor((step - 1) / STEPS) + 1} to ${Math.floor((step - 1) / STEPS) + 2}`;
      if (kind === "jump") return `${stretch}, joint ${joint} jumps at ${Math.round((100 * ((step - 1) % STEPS)) / STEPS)} % of the way`;
      if (kind === "out") return `${stretch}, the line cannot be followed beyond ${Math.round(100 * part)} %`;
      return `${stretch}, the hand arrives on another branch: joint ${joint} differs from the kept pose`;
    });
    return said.length ? `${all} With the hand straight: ${said.join("; ")}.` : `${all} With the hand straight, the line can be followed all the way.`;
  }

  // The poses on the way, and how many there are.
  lead() {
    return (this.way === "hand" ? this.ways.hand : this.ways.joints).qs;
  }

  // From the first pose, with a new trace.
  begin() {
    cancelAnimationFrame(this.running);
    this.show(0);
    this.mode.rework();
  }

  show(k) {
    this.shown = k;
    this.host.set("q", this.lead()[k]);
  }

  // Resolves when the end is reached. `seen` is called after every picture.
  play(seen = () => {}) {
    this.begin();
    const last = this.lead().length - 1, start = performance.now();
    return new Promise((done) => {
      const tick = (now) => {
        const k = Math.max(0, Math.min(last, Math.round(((now - start) / 1000 / SECONDS) * STEPS)));
        this.show(k);
        seen();
        if (k < last) this.running = requestAnimationFrame(tick);
        else done();
      };
      this.running = requestAnimationFrame(tick);
    });
  }

  draw(scene) {
    if (!this.ways) return;
    for (const [way, color, dash] of [["joints", "trace", []], ["hand", "other", [7, 4]]]) {
      if (this.way === way || this.way === "both") scene.line(this.ways[way].trace, { color, pixels: 2.5, dash });
    }
    if (this.way !== "both" || this.shown === null) return;
    const chain = frames(this.arm, this.ways.hand.qs[this.shown]);
    scene.seeThrough(0.45, () => drawBody(scene, this.arm, chain, endOf(this.arm, chain), { link: "other", joint: "other", shadow: false }));
  }

  async record(name) {
    const { type } = this, { canvas, take } = taker(this.stage), parts = [], recorder = new MediaRecorder(canvas.captureStream(30), { mimeType: type });
    recorder.ondataavailable = ({ data }) => parts.push(data);
    recorder.onstop = () => save(`${name}.${type.startsWith("video/mp4") ? "mp4" : "webm"}`, type, new Blob(parts, { type }));
    recorder.start();
    this.allow(false);
    await this.play(take);
    recorder.stop();
    this.allow(true);
  }

  // As a GIF, picture by picture, however long each takes; nothing where the poses change meanwhile.
  async animate(name) {
    const { ways } = this, delay = (1000 * SECONDS * EVERY) / STEPS;
    this.allow(false);
    this.begin();
    const { gif } = await import(new URL(`gif.js${new URL(import.meta.url).search}`, import.meta.url)), made = await gif(this.pictures(ways), delay, REST);
    if (this.ways !== ways) return;
    save(`${name}.gif`, "image/gif", made);
    this.allow(true);
    write(this.said, this.words());
  }

  async *pictures(ways) {
    const { canvas, pen, take } = taker(this.stage, WIDEST), last = this.lead().length - 1;
    for (let k = 0; k <= last && this.ways === ways; k += EVERY) {
      this.show(k);
      this.stage.draw(performance.now());
      take();
      write(this.said, `${Math.round((100 * k) / last)} % of the GIF is made.`);
      yield pen.getImageData(0, 0, canvas.width, canvas.height);
      await new Promise((next) => setTimeout(next)); // so that the page answers
    }
  }
}
