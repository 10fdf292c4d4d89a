/* What a page of the book does besides being read: the menu, the colours, films, prints. Nothing here is needed to read it. */
(() => {
  const html = document.documentElement;
  const all = (selector, within = document) => [...within.querySelectorAll(selector)];

  // Light or dark: as the system has it, until somebody chooses; what equals the system's choice is not kept.
  const system = matchMedia("(prefers-color-scheme: dark)");
  const button = document.querySelector("button.theme");
  const isDark = () => (html.dataset.theme ? html.dataset.theme === "dark" : system.matches);
  const label = () => {
    button.setAttribute("aria-pressed", String(isDark()));
    html.dispatchEvent(new CustomEvent("theme", { detail: isDark() ? "dark" : "light" }));
  };
  button.addEventListener("click", () => {
    const theme = isDark() ? "light" : "dark";
    html.dataset.theme = (theme === "dark") === system.matches ? "" : theme;
    try {
      localStorage.setItem("pushback-theme", html.dataset.theme);
    } catch {
      /* no memory here: it holds for this page */
    }
    label();
  });
  system.addEventListener("change", label);
  label();

  // The contents, where there is no room for them beside the text.
  const menu = document.querySelector("button.menu");
  const course = document.querySelector("nav.course");
  const show = (open) => {
    menu.setAttribute("aria-expanded", String(open));
    course.classList.toggle("shown", open);
  };
  menu.addEventListener("click", () => show(menu.getAttribute("aria-expanded") !== "true"));
  course.addEventListener("click", (event) => event.target.closest("a") && show(false));
  document.addEventListener("keydown", (event) => {
    if (event.key !== "Escape" || !course.classList.contains("shown")) return;
    show(false);
    menu.focus();
  });
  const here = course.querySelector("[aria-current]");
  if (here)
    course.scrollTop = here.getBoundingClientRect().top - course.getBoundingClientRect().top - course.clientHeight / 3;

  // The section that is being read.
  const links = new Map(all(".sections a[href^='#']", course).map((a) => [decodeURIComponent(a.hash.slice(1)), a]));
  const headings = all("article h2[id]").filter((h) => links.has(h.id));
  const mark = () => {
    const current = headings.filter((h) => h.getBoundingClientRect().top < innerHeight / 3).at(-1);
    for (const [id, a] of links) a.classList.toggle("reading", id === current?.id);
  };
  let waiting = false;
  addEventListener(
    "scroll",
    () => {
      if (!waiting) requestAnimationFrame(() => ((waiting = false), mark()));
      waiting = true;
    },
    { passive: true },
  );
  mark();

  // What is wider than its place scrolls within it, by the keyboard, too.
  const scrollers = new ResizeObserver((entries) => {
    for (const { target } of entries) {
      if (target.scrollWidth > target.clientWidth) target.tabIndex = 0;
      else target.removeAttribute("tabindex");
    }
  });
  for (const element of all("article .table, article pre, article .formula")) scrollers.observe(element);

  // A link into what is folded opens it.
  const unfold = () => {
    const target = location.hash && document.getElementById(decodeURIComponent(location.hash.slice(1)));
    for (let at = target?.parentElement; at; at = at.parentElement) if (at.localName === "details") at.open = true;
    if (target) target.scrollIntoView();
  };
  addEventListener("hashchange", unfold);
  unfold();

  // On paper nothing is folded, and every picture is there.
  let opened = [];
  addEventListener("beforeprint", () => {
    opened = all("details:not([open])");
    for (const details of opened) details.open = true;
    for (const picture of all("img[loading=lazy]")) picture.loading = "eager";
  });
  addEventListener("afterprint", () => {
    for (const details of opened) details.open = false;
  });

  // A film plays when it is asked to.
  for (const play of all("button.play")) {
    const picture = play.parentElement.querySelector("img");
    const still = picture.getAttribute("src");
    play.hidden = false;
    play.addEventListener("click", () => {
      const playing = picture.getAttribute("src") !== still;
      picture.src = playing ? still : play.dataset.film;
      play.classList.toggle("playing", !playing);
      play.querySelector(".label").textContent = playing ? "Play the film" : "Stop the film";
    });
  }
})();
