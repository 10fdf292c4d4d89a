/* The search. The words of all pages come in a file of their own, once somebody begins to search: MiniSearch finds in them. */
(() => {
  const root = document.documentElement.dataset.root;
  const form = document.querySelector("form.search");
  const input = form.querySelector("input");
  const found = form.querySelector(".found");
  const count = found.querySelector(".count");
  const list = found.querySelector("ol");
  let index;

  const script = (src) =>
    new Promise((resolve, reject) => {
      const element = document.createElement("script");
      element.src = `${root}/assets/${src}`;
      element.onload = resolve;
      element.onerror = reject;
      document.head.append(element);
    });

  /* Words are compared without accents, in small letters. */
  const plain = (word) =>
    word
      .normalize("NFKD")
      .replace(/[\u0300-\u036f]/g, "")
      .toLowerCase();

  /* Of a word and its forms the same beginning: of "sinks", "sinking" and "sink" "sink". */
  const stem = (word) => plain(word).replace(/(?<=.{4})(ing|ed|es|e)$|(?<=.{3}[^s])s$/, "");
  /* What a question has besides what is asked for. */
  const little = new Set(
    "a an and are can do does how i in is it my not of on or so the then to what when which why".split(" "),
  );

  /* A text so that a place in it is the same place in the text. */
  const folded = (text) =>
    [...text].map((letter) => (plain(letter).length === letter.length ? plain(letter) : letter)).join("");

  const load = () =>
    (index ??= Promise.all([script("minisearch.js"), script("search_index.js")]).then(() => {
      const search = new MiniSearch({
        fields: ["title", "page", "text"],
        storeFields: ["address", "title", "page", "text"],
        processTerm: stem,
        searchOptions: {
          boost: { title: 4, page: 2 },
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

  const placesOf = (text, terms) =>
    terms.flatMap((term) => {
      const places = [];
      for (let at = text.indexOf(term); at >= 0; at = text.indexOf(term, at + term.length)) places.push({ at, term });
      return places;
    });

  /* Some 150 characters that hold as many of the words as any; of several such places the first. */
  const excerpt = (text, terms) => {
    const places = placesOf(folded(text), terms).sort((a, b) => a.at - b.at);
    const within = ({ at }) => new Set(places.filter((p) => p.at >= at && p.at < at + 100).map((p) => p.term)).size;
    const first =
      places.reduce((best, place) => (!best || within(place) > within(best) ? place : best), undefined)?.at ?? 0;
    const start = first < 60 ? 0 : text.lastIndexOf(" ", first - 40) + 1;
    const end = start + 150 < text.length ? text.lastIndexOf(" ", start + 150) : text.length;
    return (start ? "… " : "") + text.slice(start, end) + (end < text.length ? " …" : "");
  };

  const marked = (text, terms) => {
    const part = document.createDocumentFragment();
    const words = terms.map((term) => term.replace(/[.*+?^${}()|[\]\\]/g, "\\$&")).sort((a, b) => b.length - a.length);
    let done = 0;
    for (const { index, 0: word } of words.length ? folded(text).matchAll(new RegExp(words.join("|"), "g")) : []) {
      const mark = document.createElement("mark");
      mark.textContent = text.slice(index, index + word.length);
      part.append(text.slice(done, index), mark);
      done = index + word.length;
    }
    part.append(text.slice(done));
    return part;
  };

  const show = async () => {
    const words = input.value.trim();
    if (!words) return void (found.hidden = true);
    const search = await load();
    if (input.value.trim() !== words) return; // more has been typed meanwhile
    const terms = words.split(/[\s,.;:?!]+/);
    const asked = terms.filter((term) => !little.has(plain(term))).join(" ") || words;
    const all = search.search(asked);
    const results = all.length ? all : search.search(asked, { combineWith: "OR" });
    count.textContent =
      results.length === 0
        ? `Nothing was found for “${words}”.`
        : results.length === 1
          ? "One place"
          : `${results.length} places`;
    list.replaceChildren(
      ...results.slice(0, 30).map((result) => {
        const item = document.createElement("li");
        const link = document.createElement("a");
        const title = document.createElement("strong");
        const text = document.createElement("span");
        link.href = `${root}/${result.address}`;
        title.append(
          marked(result.title === result.page ? result.page : `${result.page} › ${result.title}`, result.terms),
        );
        text.append(marked(excerpt(result.text, result.terms), result.terms));
        link.append(title, text);
        item.append(link);
        return item;
      }),
    );
    found.hidden = false;
  };

  input.addEventListener("focus", load, { once: true });
  input.addEventListener("input", show);
  input.addEventListener("focus", () => input.value && show());
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    list.querySelector("a")?.click();
  });
  form.addEventListener("keydown", (event) => {
    const links = [...list.querySelectorAll("a")];
    const at = links.indexOf(document.activeElement);
    if (event.key === "Escape") {
      found.hidden = true;
      input.focus();
    } else if (event.key === "ArrowDown" && links.length) (links[at + 1] ?? links[at]).focus();
    else if (event.key === "ArrowUp" && at >= 0) (links[at - 1] ?? input).focus();
    else return;
    event.preventDefault();
  });
  document.addEventListener("click", (event) => form.contains(event.target) || (found.hidden = true));
  form.addEventListener(
    "focusout",
    (event) => event.relatedTarget && !form.contains(event.relatedTarget) && (found.hidden = true),
  );
  document.addEventListener("keydown", (event) => {
    if (
      event.key !== "/" ||
      event.ctrlKey ||
      event.metaKey ||
      event.altKey ||
      /^(INPUT|TEXTAREA|SELECT)$/.test(event.target.tagName)
    )
      return;
    event.preventDefault();
    input.focus();
  });
})();
