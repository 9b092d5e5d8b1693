// The list of pages begins at the page that is open, not at its own top.
addEventListener("DOMContentLoaded", () => {
  const list = document.querySelector(".sidebar-scroll");
  const here = list?.querySelector(".current-page");
  const below = (part) => part.getBoundingClientRect().top - list.getBoundingClientRect().top;
  if (here) list.scrollTop += below(here) - list.clientHeight / 3;
  const whole = list && list.scrollTop > 0 && [...list.querySelectorAll(".caption, li")].find((part) => below(part) >= 0);
  if (whole) list.scrollTop += below(whole); // no line is cut in two
  unfold();
});

// What an address leads to, what is searched for, and what is printed is open.
function unfold() {
  const there = document.getElementById(decodeURIComponent(location.hash.slice(1)));
  if (!there) return;
  const own = there.querySelector(":scope > details");
  for (let part = own ?? there; part; part = part.parentElement) if (part.localName === "details") part.open = true;
  there.scrollIntoView();
}
addEventListener("hashchange", unfold);
addEventListener("load", () => document.querySelectorAll("details:has(.highlighted)").forEach((part) => (part.open = true)));
addEventListener("beforeprint", () => document.querySelectorAll("article details").forEach((part) => (part.open = true)));

// A search shows the pages in the language of the page it was asked from first, and of each the sentence that it found.
const ASKED = new URLSearchParams(location.search);
const SPANISH = document.documentElement.lang === "es" || ASKED.get("lang") === "es";
const isSpanish = (page) => page.endsWith(".es") || page.startsWith("notebooks/es/");
const FIRST = 1000; // more than any page's score
const LONGEST = 200; // letters of a sentence that is shown whole
const WORDS = {
  locale: "es",
  plural_expr: "n == 1 ? 0 : 1",
  messages: {
    Searching: "Buscando",
    "Search Results": "Resultados",
    "Preparing search...": "Preparando la búsqueda …",
    "Search finished, found one page matching the search query.": ["Se encontró una página.", "Se encontraron ${resultCount} páginas; primero las que están en español."],
    "Your search did not match any documents. Please make sure that all words are spelled correctly and that you've selected enough categories.": "No se encontró nada. Pruebe con otra palabra, o con menos palabras.",
  },
};

document.addEventListener("DOMContentLoaded", () => { // before the search begins, which waits for the same
  for (const form of document.querySelectorAll("form[role=search]")) if (SPANISH) form.insertAdjacentHTML("beforeend", '<input type="hidden" name="lang" value="es">');
  const results = document.getElementById("search-results");
  if (!results) return;
  if (SPANISH) {
    document.documentElement.lang = "es";
    document.querySelectorAll(".sidebar-search").forEach((box) => [box.placeholder, box.ariaLabel] = ["Buscar", "Buscar"]);
    Documentation.addTranslations(WORDS);
  }
  Scorer.score = ([page, , , , score]) => score + (isSpanish(page) === SPANISH ? FIRST : 0);
  const script = document.createElement("script");
  script.src = "_static/about.js";
  script.onload = () => {
    explain(results);
    new MutationObserver(() => explain(results)).observe(results, { childList: true, subtree: true });
  };
  document.head.append(script);
});

// Below each page that was found: the sentence, and for whom the page is.
function explain(results) {
  const line = (text, kind) => Object.assign(document.createElement("p"), { className: kind, textContent: text });
  for (const link of results.querySelectorAll("li > a:not([data-seen])")) {
    link.dataset.seen = "";
    const [file, place = ""] = link.getAttribute("href").split("#");
    const page = file.split(".html")[0];
    const whom = aboutPages.whom[page] ?? "";
    const [sentence, at] = sentenceOf(aboutPages.texts[page] ?? [], decodeURIComponent(place), whom);
    if (sentence) {
      const shown = line(sentence, "sentence");
      marked(shown);
      link.parentElement.append(shown);
      if (!place && at) link.setAttribute("href", `${file}#${at}`); // where the sentence stands
    }
    if (whom) link.parentElement.append(line(whom, "whom"));
  }
}

const TERMS = (ASKED.get("q") ?? "").toLowerCase().split(/[^\p{L}\p{N}_]+/u).filter((word) => word.length > 2);
const like = (word) => word.slice(0, Math.max(4, word.length - 2)); // "filters" finds filter, too
const begins = (word, flags = "iu") => new RegExp(`(?<![\\p{L}\\p{N}])${like(word)}[\\p{L}\\p{N}]*`, flags); // the start of a word

// Of a page's parts [place, text] the sentence that has the most of the words, and its place; not for whom the page is.
function sentenceOf(parts, place, whom) {
  const there = parts.filter(([id]) => id === place);
  let best = ["", "", 0];
  for (const [id, text] of there.length ? there : parts) {
    for (const sentence of text.split(/\n+|(?<=[.?!]) +(?=[\p{Lu}¿¡])/u)) {
      const hits = TERMS.filter((word) => begins(word).test(sentence)).length;
      if (hits > best[2] && sentence.length > 30 && !whom.includes(sentence)) best = [sentence, id, hits];
    }
  }
  return [short(best[0] || (there[0]?.[1] ?? "").split("\n")[0]), best[1]];
}

function short(sentence) {
  if (sentence.length <= LONGEST) return sentence;
  const at = Math.max(0, Math.min(...TERMS.map((word) => sentence.search(begins(word))).filter((k) => k >= 0), sentence.length) - LONGEST / 3);
  const from = at > 0 ? sentence.indexOf(" ", at) + 1 : 0;
  const to = from + LONGEST < sentence.length ? sentence.lastIndexOf(" ", from + LONGEST) : sentence.length;
  return `${from ? "… " : ""}${sentence.slice(from, to)}${to < sentence.length ? " …" : ""}`;
}

function marked(line) {
  if (!TERMS.length) return;
  const found = new RegExp(TERMS.map((word) => begins(word).source).join("|"), "giu");
  const text = line.textContent;
  line.textContent = "";
  let end = 0;
  for (const match of text.matchAll(found)) {
    const mark = Object.assign(document.createElement("mark"), { textContent: match[0] });
    line.append(text.slice(end, match.index), mark);
    end = match.index + match[0].length;
  }
  line.append(text.slice(end));
}
