// What a page needs that is read and does not run.

// What follows a prediction stays folded until the reader has chosen. A lesson that runs in its page shows all.

const HIDDEN = "later";

// The list of options stands before the cell; what tells the outcome stands between the cell and the next heading or question.
function options(cell) {
  for (let before = cell.previousElementSibling; before && !before.matches("h1, h2, h3, .cell"); before = before.previousElementSibling) {
    if (before.matches("ul") && [...before.children].every((item) => item.querySelector("code"))) return before;
  }
  return null;
}

function outcome(cell) {
  const found = [];
  let told = false;
  for (let next = cell.nextElementSibling; next && !next.matches("h1, h2, h3, section"); next = next.nextElementSibling) {
    if (told && next.matches(".cell")) break;
    found.push(next);
    told ||= next.textContent.includes("reveal(");
  }
  return told ? found : [];
}

for (const cell of document.querySelectorAll(".cell.tag_predict")) {
  const list = options(cell), later = outcome(cell);
  if (!list || !later.length) continue;
  const wait = document.createElement("p");
  wait.className = "predict-wait";
  wait.textContent = "Choose above what you expect; then it goes on here.";
  later[0].before(wait);
  for (const element of later) element.classList.add(HIDDEN);
  list.classList.add("predict-options");
  for (const item of list.children) {
    const button = document.createElement("button");
    button.type = "button";
    button.append(...item.childNodes);
    item.append(button);
    button.addEventListener("click", () => {
      for (const other of list.querySelectorAll("button")) other.setAttribute("aria-pressed", String(other === button));
      for (const element of later) element.classList.remove(HIDDEN);
      wait.textContent = "Your guess is kept on this page alone, and nobody marks it. Compare it with what comes out:";
    });
  }
}

// What is wider than its column scrolls; then the keyboard must reach it.
function reachable() {
  for (const output of document.querySelectorAll(".cell_output, .dhlab-picture")) {
    if (output.scrollWidth > output.clientWidth + 1) output.tabIndex = 0;
    else output.removeAttribute("tabindex");
  }
}

// On paper all is shown, and it is shown before explorers draw themselves for the paper.
let folded = [];
addEventListener("beforeprint", () => {
  folded = [...document.querySelectorAll(`.${HIDDEN}`)];
  for (const element of folded) {
    element.classList.remove(HIDDEN);
    for (const picture of element.querySelectorAll("img")) picture.loading = "eager";
  }
});
addEventListener("afterprint", () => folded.forEach((element) => element.classList.add(HIDDEN)));

addEventListener("resize", reachable);
addEventListener("load", reachable);
