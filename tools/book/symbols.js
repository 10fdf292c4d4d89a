/// Symbols that formulas, code and pictures of a page share: site.js lights one everywhere when a reader points at it.

/// The identifiers of each symbol in the code of chapters 01 to 07.
const symbolOf = { n: "n", normal: "n", depth: "d", impulse: "λ", lambda: "λ", beta: "β", beta_: "β" };
const symbols = [...new Set(Object.values(symbolOf))];
const identifier = new RegExp(`(<i class=c>.*?</i>|<[^>]*>)|\\b(${Object.keys(symbolOf).join("|")})\\b`, "gs"); // (comment or tag)

const marked = (symbol, text) => `<span data-symbol="${symbol}">${text}</span>`;

/// Marks each symbol of a page's HTML. Of each one the first that is a formula by itself can have the focus.
export function withSymbols(html) {
  // An n in a subscript is a word: the normal part.
  const inFormula = (all, open, tight, letters) =>
    `${open}${letters.replace(/[ndλβ]/g, (letter) => (tight && letter === "n" ? letter : marked(letter, letter)))}</span>`;
  const inCode = (code) => code.replace(identifier, (all, other, name) => other ?? marked(symbolOf[name], name));
  const made = html
    .replace(/(<span class="mord mathnormal( mtight)?"[^>]*>)([^<]+)<\/span>/g, inFormula)
    .replace(/<label>(?=<span>([ndλβ])<)/g, '<label data-symbol="$1">')
    .replace(/(?<=<code[^>]*>).*?(?=<\/code>)/gs, inCode);
  return symbols.reduce(
    (text, symbol) =>
      text.replace(
        new RegExp(
          `<span class="katex">(?=<span class="katex-mathml"><math><semantics><mrow>(<mi mathvariant="normal">Σ</mi>)?<mi>${symbol}</mi></mrow>)`,
        ),
        `<span class="katex" data-symbol="${symbol}" tabindex="0">`,
      ),
    made,
  );
}
