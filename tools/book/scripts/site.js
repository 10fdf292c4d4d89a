/* What a page of the book does besides being read: the menu, the colours, films. Nothing here is needed to read it. */
(() => {
  const html = document.documentElement;

  // Light or dark: as the system has it, until somebody chooses.
  const system = matchMedia("(prefers-color-scheme: dark)");
  const button = document.querySelector("button.theme");
  const isDark = () => (html.dataset.theme ? html.dataset.theme === "dark" : system.matches);
  const label = () => {
    button.setAttribute("aria-pressed", String(isDark()));
    html.dispatchEvent(new CustomEvent("theme"));
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
  menu.addEventListener("click", () => show(!course.classList.contains("shown")));
  course.addEventListener("click", (event) => event.target.closest("a") && show(false));
  document.addEventListener("keydown", (event) => {
    if (event.key !== "Escape" || !course.classList.contains("shown")) return;
    show(false);
    menu.focus();
  });
  const here = course.querySelector("[aria-current]");
  if (here) course.scrollTop = here.offsetTop - course.clientHeight / 3;

  // What is wider than its place scrolls within it, by the keyboard, too, and shows on which side there is more.
  const measure = (element) => {
    const beyond = element.scrollWidth - element.clientWidth;
    if (!element.href) element.tabIndex = beyond > 0 ? 0 : -1;
    element.classList.toggle("more-left", element.scrollLeft > 1);
    element.classList.toggle("more-right", beyond - element.scrollLeft > 1);
  };
  const pictures = [...document.querySelectorAll("figure:is(.sheet, .plot, .drawing) > a")];
  const wide = [...document.querySelectorAll("article :is(.table, pre, .formula)"), ...pictures];
  const scrollers = new ResizeObserver((entries) => entries.forEach(({ target }) => measure(target)));
  for (const element of wide) {
    scrollers.observe(element);
    element.addEventListener("scroll", () => measure(element), { passive: true });
  }
  document.fonts.ready.then(() => wide.forEach(measure));

  // On a telephone a picture with words is enlarged in its place, around the point that was tapped.
  for (const picture of pictures)
    picture.addEventListener("click", (event) => {
      if (!matchMedia("(max-width: 40rem)").matches) return;
      event.preventDefault();
      const { left, width } = picture.getBoundingClientRect();
      if (picture.classList.toggle("large"))
        picture.scrollLeft = ((event.clientX - left) / width) * picture.scrollWidth - width / 2;
      measure(picture);
    });

  // A link into what is folded opens it; on paper nothing is folded.
  const folds = [...document.querySelectorAll("article details")];
  const unfold = () => {
    const target = location.hash && document.getElementById(decodeURIComponent(location.hash.slice(1)));
    for (const fold of folds) if (fold.contains(target || null)) fold.open = true;
    if (target) target.scrollIntoView();
  };
  addEventListener("hashchange", unfold);
  unfold();
  addEventListener("beforeprint", () => folds.forEach((fold) => (fold.open = true)));

  // A symbol that is pointed at, or has the focus, is lit in formulas, code and pictures. A click keeps it lit.
  let kept = "";
  const light = (symbol) => {
    if (symbol === (html.dataset.lit ?? "")) return;
    html.dataset.lit = symbol;
    for (const one of document.querySelectorAll("[data-symbol]"))
      one.classList.toggle("lit", one.dataset.symbol === symbol);
    html.dispatchEvent(new CustomEvent("lit"));
  };
  const symbolAt = ({ target }) => target.closest?.("[data-symbol]")?.dataset.symbol ?? "";
  document.addEventListener("pointerover", (event) => {
    if (event.pointerType !== "touch") light(symbolAt(event) || kept); // a finger that scrolls points at nothing
  });
  document.addEventListener("focusin", (event) => light(symbolAt(event)));
  document.addEventListener("click", (event) => light((kept = symbolAt(event))));

  // A film plays when it is asked to.
  for (const play of document.querySelectorAll("button.play")) {
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
