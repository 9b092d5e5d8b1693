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

// Below each page that a search finds: for whom it is.
addEventListener("DOMContentLoaded", () => {
  const results = document.getElementById("search-results");
  if (!results) return;
  const script = document.createElement("script");
  script.src = "_static/about.js";
  script.onload = () => {
    tell(results);
    new MutationObserver(() => tell(results)).observe(results, { childList: true, subtree: true });
  };
  document.head.append(script);
});

function tell(results) {
  for (const link of results.querySelectorAll("li > a")) {
    const whom = aboutPages[link.getAttribute("href").split(".html")[0]];
    if (!whom || link.parentElement.querySelector(".whom")) continue;
    const line = document.createElement("p");
    line.className = "whom";
    line.textContent = whom;
    link.parentElement.append(line);
  }
}
