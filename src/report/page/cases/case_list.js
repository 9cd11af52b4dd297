// The list of cards. It grows as it is scrolled, so that a thousand cases cost no more than what is looked at.

const CARDS_AT_ONCE = 16;
const list = { groups: [], shown: 0, order: [] };

// What lies above the window does not count: a jump to a later section must not fill the list.
const nearEnd = new IntersectionObserver((entries) => {
  if (entries.some((entry) => entry.isIntersecting)) growList();
}, { rootMargin: "-25% 0px 800px 0px" });

function growList(most = CARDS_AT_ONCE) {
  const next = list.groups.slice(list.shown, list.shown + most);
  list.shown += next.length;
  byId("cards").append(...next.map(card));
  const more = byId("more");
  more.hidden = list.shown >= list.groups.length;
  // Observing anew reports again, as long as the end stays in sight.
  nearEnd.unobserve(more);
  if (!more.hidden) nearEnd.observe(more);
}

function refreshList() {
  list.groups = shownGroups();
  list.shown = 0;
  list.order = list.groups.flatMap((group) => group.cases);
  for (const holder of document.querySelectorAll(".thumbnail-holder")) nearWindow.unobserve(holder);
  byId("cards").replaceChildren();
  growList();
  refreshFilters();
  const text = list.order.length === 0 ? "No file passes these filters."
    : `${counted(list.order.length, "file")} of ${whole(report.cases.length)}, in ${counted(list.groups.length, "group")}`;
  byId("shown-count").textContent = text;
}

function growWhole() {
  growList(list.groups.length);
}

// The keys j and k walk through what the list shows.
function walkList(step) {
  const links = [...document.querySelectorAll("#cards a[data-case]")];
  const at = links.indexOf(document.activeElement);
  const link = links[Math.min(Math.max(at + step, 0), links.length - 1)];
  link?.focus();
  link?.scrollIntoView({ block: "nearest" });
}

function casesSection() {
  if (report.cases.length === 0) return null;
  return section("cases", "Cases", verdictMatrix(), filterBar(),
    element("p", { id: "shown-count", class: "quiet", role: "status" }),
    element("div", { id: "cards", class: "cards" }),
    element("div", { id: "more", class: "quiet" }, "more below"));
}
