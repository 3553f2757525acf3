// The gallery's search: cards that do not fit are hidden; what was asked stands in the address.

const form = document.querySelector(".arm-search");
const cards = [...document.querySelectorAll(".arm-card")];
const said = form.querySelector("[role=status]");
const letters = (text) => text.toLowerCase().normalize("NFD").replace(/[^a-z0-9 ]/g, "");
const known = cards.map((card) => {
  const words = letters(`${card.dataset.words} ${card.dataset.joints} joints`);
  return { card, words, tight: words.replaceAll(" ", "") };
});

function offer(name) {
  const values = [...new Set(cards.map((card) => card.dataset[name]).filter(Boolean))];
  values.sort((a, b) => a.localeCompare(b, "en", { numeric: true }));
  for (const value of values) form.elements[name].append(new Option(value, value));
}

// Every word must be there; a name may be written with or without its spaces and signs.
function fits({ card, words, tight }, { q, maker, joints }) {
  const asked = letters(q);
  const found = asked.split(" ").every((word) => words.includes(word)) || tight.includes(asked.replaceAll(" ", ""));
  return found && (!maker || card.dataset.maker === maker) && (!joints || card.dataset.joints === joints);
}

function show() {
  const asked = Object.fromEntries(new FormData(form));
  let count = 0;
  for (const one of known) count += !(one.card.hidden = !fits(one, asked));
  said.textContent = count ? `${count} of ${cards.length} arms` : "No arm of the library is called so. Fewer letters find more.";
  const kept = new URLSearchParams(Object.entries(asked).filter(([, value]) => value));
  history.replaceState(null, "", kept.size ? `?${kept}` : location.pathname);
}

offer("maker");
offer("joints");
form.hidden = false;
for (const [name, value] of new URLSearchParams(location.search)) if (form.elements[name]) form.elements[name].value = value;
form.addEventListener("input", show);
form.addEventListener("submit", (event) => event.preventDefault());
show();
