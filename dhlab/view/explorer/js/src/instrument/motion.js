// A motion through kept configurations, seen with its trace: joint-straight, hand-straight, or both beside each other; and saved as a video.

import { drawBody } from "../bodies.js";
import { button, choice } from "../controls.js";
import { h, write } from "../dom.js";
import { endOf, forward, frames } from "../kinematics.js";
import { origin } from "../matrix.js";
import { save } from "./out.js";
import { STEPS, path } from "./path.js";

const SECONDS = 2.5; // for a stretch
const TYPES = ["video/webm;codecs=vp9", "video/webm", "video/mp4"];

export class Motion {
  constructor({ stage, mode, host }, name) {
    Object.assign(this, { stage, mode, host, arm: host.data.arm, poses: [host.get("q")], way: "joints", running: 0, shown: null });
    this.said = h("p", { role: "status" });
    this.playing = button("Play", () => this.play());
    this.video = button("Save as a video", () => this.record(name()));
    const ways = choice("Between two poses", "way", [["joints", "Each joint straight"], ["hand", "The hand straight"], ["both", "Both"]], "joints", (way) => {
      this.way = way;
      this.plan();
    });
    this.element = h("details", { class: "edit motion" }, h("summary", {}, "Play a motion"), h("div", { class: "below" },
      h("p", { class: "hint" }, "Move the arm and keep the pose, as often as you like; then play."),
      h("div", { class: "give" }, button("Keep this pose", () => this.keep()), button("Forget the poses", () => this.forget()), this.playing, this.video), ways.element, this.said));
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

  // Both ways through the poses, and what is to be said of them.
  plan() {
    cancelAnimationFrame(this.running);
    const ready = this.poses.length > 1, { arm, poses, mode: { size } } = this;
    this.playing.disabled = this.video.disabled = !ready;
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

  // Resolves when the end is reached. `seen` is called after every picture.
  play(seen = () => {}) {
    cancelAnimationFrame(this.running);
    const last = this.ways.joints.qs.length - 1, lead = this.way === "hand" ? this.ways.hand : this.ways.joints, begin = performance.now();
    this.host.set("q", lead.qs[0]);
    this.mode.rework(); // with a new trace
    return new Promise((done) => {
      const tick = (now) => {
        const k = Math.max(0, Math.min(last, Math.round(((now - begin) / 1000 / SECONDS) * STEPS)));
        this.shown = k;
        this.host.set("q", lead.qs[k]);
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
    const type = TYPES.find((one) => globalThis.MediaRecorder?.isTypeSupported(one));
    if (!type) return write(this.said, "This browser records no video; a screen recorder will do.");
    const { canvas } = this.stage, copy = h("canvas", { width: canvas.width, height: canvas.height }), pen = copy.getContext("2d"), parts = [];
    const ground = getComputedStyle(this.stage.element.closest(".explorer")).backgroundColor, recorder = new MediaRecorder(copy.captureStream(30), { mimeType: type });
    recorder.ondataavailable = ({ data }) => parts.push(data);
    recorder.onstop = () => save(`${name}.${type.startsWith("video/mp4") ? "mp4" : "webm"}`, type, new Blob(parts, { type }));
    recorder.start();
    this.video.disabled = true;
    await this.play(() => {
      pen.fillStyle = ground;
      pen.fillRect(0, 0, copy.width, copy.height);
      pen.drawImage(canvas, 0, 0);
    });
    recorder.stop();
    this.video.disabled = false;
  }
}
