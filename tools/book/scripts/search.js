/* The search. The words of all pages come in a file of their own, once somebody begins to search: MiniSearch finds in them. */
(() => {
  const { root } = document.documentElement.dataset;
  const form = document.querySelector("form.search");
  const input = form.querySelector("input");
  const found = form.querySelector(".found");
  const count = found.querySelector(".count");
  const list = found.querySelector("ol");
  let index;

  const script = (src) =>
    new Promise((resolve, reject) => {
      const element = Object.assign(document.createElement("script"), { src: `${root}/assets/${src}` });
      Object.assign(element, { onload: resolve, onerror: reject });
      document.head.append(element);
    });

  /* Without accents, in small letters. */
  const plain = (text) =>
    text
      .normalize("NFD")
      .replace(/[\u0300-\u036f]/g, "")
      .toLowerCase();
  /* Of a word and its forms the same beginning: of "sinks" and "sinking" "sink". */
  const stem = (word) => plain(word).replace(/(?<=.{4})(ing|ed|es|e)$|(?<=.{3}[^s])s$/, "");
  /* What a question has besides what is asked for. */
  const little = /^(an?|and|are|can|do(es)?|how|i[nst]?|my|not|o[fnr]|so|th(e|en)|to|wh(at|en|ich|y))$/;

  const load = () =>
    (index ??= Promise.all([script("minisearch.js"), script("search_index.js")]).then(() => {
      const search = new MiniSearch({
        fields: ["title", "page", "keywords", "text"],
        storeFields: ["address", "title", "page", "text"],
        processTerm: stem,
        searchOptions: {
          boost: { title: 4, page: 2, keywords: 12 },
          prefix: (term) => term.length > 1,
          fuzzy: (term) => (term.length > 4 ? 0.2 : false),
          combineWith: "AND",
          // The page that is written in the words of who asks comes first; challenges explain nothing.
          boostDocument: (id, term, { address }) =>
            address.startsWith("docs/symptoms") ? 4 : address.startsWith("docs/challenges") ? 0.2 : 1,
        },
      });
      search.addAll(window.PUSHBACK_SEARCH);
      return search;
    }));

  /* Some 150 characters around the longest of the words that is there. */
  const excerpt = (text, terms) => {
    const longest = [...terms].sort((a, b) => b.length - a.length).find((term) => plain(text).includes(term));
    const start = Math.max(0, (longest ? plain(text).indexOf(longest) : 0) - 40);
    return `${start ? "… " : ""}${text.slice(start, start + 150)} …`;
  };

  const itemOf = ({ address, title, page, text, terms }) => {
    const make = (tag, properties, ...children) => {
      const element = Object.assign(document.createElement(tag), properties);
      element.append(...children);
      return element;
    };
    const name = make("strong", {}, title === page ? page : `${page} › ${title}`);
    return make("li", {}, make("a", { href: `${root}/${address}` }, name, make("span", {}, excerpt(text, terms))));
  };

  const show = async () => {
    const words = input.value.trim();
    if (!words) return void (found.hidden = true);
    const search = await load();
    if (input.value.trim() !== words) return; // more has been typed meanwhile
    const terms = words.split(/[\s,.;:?!]+/).filter((term) => !little.test(plain(term)));
    const asked = terms.join(" ") || words;
    const all = search.search(asked);
    const results = all.length ? all : search.search(asked, { combineWith: "OR" });
    count.textContent = results.length ? `Places: ${results.length}` : `Nothing was found for “${words}”.`;
    list.replaceChildren(...results.slice(0, 30).map(itemOf));
    found.hidden = false;
  };

  input.addEventListener("focus", () => load() && show());
  input.addEventListener("input", show);
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    list.querySelector("a")?.click();
  });
  form.addEventListener("keydown", (event) => {
    const stops = [input, ...list.querySelectorAll("a")];
    const at = stops.indexOf(document.activeElement) + { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (event.key === "Escape") {
      found.hidden = true;
      input.focus();
    } else if (stops[at]) {
      stops[at].focus();
      event.preventDefault();
    }
  });
  document.addEventListener("click", (event) => form.contains(event.target) || (found.hidden = true));
  form.addEventListener("focusout", ({ relatedTarget }) => {
    if (relatedTarget && !form.contains(relatedTarget)) found.hidden = true;
  });
  document.addEventListener("keydown", (event) => {
    if (event.key !== "/" || event.ctrlKey || event.metaKey || event.altKey) return;
    if (/^(INPUT|TEXTAREA|SELECT)$/.test(event.target.tagName)) return;
    event.preventDefault();
    input.focus();
  });
})();
