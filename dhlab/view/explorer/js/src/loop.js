// One animation loop and one WebGL context for all explorers of a page, also when the module was loaded more than once (each notebook widget does).
// An explorer draws when something changed and it can be seen; otherwise nothing runs.

import { Renderer } from "./renderer.js";

const shared = (globalThis[Symbol.for("dhlab.explorer")] ??= { views: new Set(), asked: 0, renderer: null, observer: null });

export const renderer = () => (shared.renderer ??= new Renderer(() => shared.views.forEach((view) => view.redraw())));

function observer() {
  return (shared.observer ??= new IntersectionObserver((entries) => {
    for (const { target, isIntersecting } of entries) {
      const view = [...shared.views].find((one) => one.canvas === target);
      if (view) view.awake = isIntersecting;
    }
    schedule();
  }, { rootMargin: "80px" }));
}

export function enlist(view) {
  view.awake = false;
  shared.views.add(view);
  observer().observe(view.canvas);
  return () => {
    shared.views.delete(view);
    observer().unobserve(view.canvas);
  };
}

export function schedule() {
  if (!shared.asked) shared.asked = requestAnimationFrame(tick);
}

function tick(time) {
  shared.asked = 0;
  for (const view of shared.views) if (view.awake && view.stale) view.draw(time);
  if ([...shared.views].some((view) => view.awake && view.stale)) schedule();
}
