// Elements, made in one line.

export const h = (tag, attributes = {}, ...children) => {
  const element = document.createElement(tag);
  for (const [key, value] of Object.entries(attributes)) {
    if (key.startsWith("on")) element.addEventListener(key.slice(2), value);
    else if (value !== null) element.setAttribute(key, value);
  }
  element.append(...children);
  return element;
};

export const button = (words, pressed, kind = "") => h("button", { type: "button", class: `live-button ${kind}`, onclick: pressed }, words);
