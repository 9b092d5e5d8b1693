// What an address leads to, what is searched for, and what is printed is open.
function unfold() {
  const there = document.getElementById(decodeURIComponent(location.hash.slice(1)));
  if (!there) return;
  const own = there.querySelector(":scope > details");
  for (let part = own ?? there; part; part = part.parentElement) if (part.localName === "details") part.open = true;
  there.scrollIntoView();
}
addEventListener("DOMContentLoaded", unfold);
addEventListener("hashchange", unfold);
addEventListener("load", () => document.querySelectorAll("details:has(.highlighted)").forEach((part) => (part.open = true)));
addEventListener("beforeprint", () => document.querySelectorAll("article details").forEach((part) => (part.open = true)));
