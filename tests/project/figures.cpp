/// The figures of the pages: what is committed is what the program draws, each is sound XML, no label is cut off or lies on
/// another, and each stands on a page.
#include <fmt/format.h>

#include <map>

#include "pushback/common/render/canvas.h"
#include "pushback/tools/figures/figures.h"
#include "pushback/tools/figures/two_point_column.h"
#include "tests/project/links.h"

/// The root of the sources, as seen from the working directory of the tests.
#ifndef SOURCE_DIR
#define SOURCE_DIR "."
#endif

using namespace pushback;
using namespace pushback::figures;

namespace {

const fs::path folder = fs::path(SOURCE_DIR) / "docs/figures";

/// An element of XML, or a piece of text: then it has no name.
struct Node {
  std::string name = {}, text = {};
  std::map<std::string, std::string> attributes = {};
  std::vector<Node> children = {};

  double number(const std::string& attribute) const { return std::stod(attributes.at(attribute)); }
  bool has(const std::string& attribute) const { return attributes.contains(attribute); }
};

/// Reads XML as far as the figures use it. Throws std::runtime_error where it is not well-formed.
class Reader {
 public:
  explicit Reader(std::string text) : text_(std::move(text)) {}
  Node document() {
    blanks();
    const Node root = element();
    blanks();
    if (at_ != text_.size()) fail("something behind the root");
    return root;
  }

 private:
  Node element() {
    expect('<');
    Node node{.name = name()};
    while (blanks(), peek() != '>' && peek() != '/') {
      const std::string attribute = name();
      expect('=');
      expect('"');
      const std::string value = until('"');
      expect('"');
      if (!node.attributes.emplace(attribute, value).second) fail("an attribute twice: " + attribute);
    }
    if (peek() == '/') {
      expect('/');
      expect('>');
      return node;
    }
    expect('>');
    while (text_.compare(at_, 2, "</") != 0) {
      if (peek() == '<') node.children.push_back(element());
      else node.children.push_back({.text = until('<')});
    }
    at_ += 2;
    if (name() != node.name) fail("the end of " + node.name + " is missing");
    expect('>');
    return node;
  }
  std::string name() {
    const std::size_t begin = at_;
    while (at_ < text_.size() &&
           (std::isalnum(static_cast<unsigned char>(text_[at_])) != 0 || text_[at_] == '-' || text_[at_] == ':'))
      ++at_;
    if (at_ == begin) fail("a name is missing");
    return text_.substr(begin, at_ - begin);
  }
  /// What stands before `end`, with the entities replaced.
  std::string until(char end) {
    std::string found;
    while (peek() != end) {
      if (peek() == '<') fail("< within text");
      if (peek() != '&') {
        found += text_[at_++];
        continue;
      }
      const std::size_t semicolon = text_.find(';', at_);
      const std::string entity = text_.substr(at_, semicolon - at_);
      if (entity != "&amp" && entity != "&lt" && entity != "&gt") fail("unknown entity " + entity);
      found += entity == "&amp" ? '&' : entity == "&lt" ? '<' : '>';
      at_ = semicolon + 1;
    }
    return found;
  }
  void blanks() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
  }
  char peek() const {
    if (at_ >= text_.size()) fail("the text ends");
    return text_[at_];
  }
  void expect(char c) {
    if (peek() != c) fail(std::string("expected ") + c);
    ++at_;
  }
  [[noreturn]] void fail(const std::string& why) const {
    throw std::runtime_error(why + " at byte " + std::to_string(at_));
  }

  std::string text_;
  std::size_t at_ = 0;
};

/// Where the letters of a label are, px, by the widths of DejaVu Sans: few fonts are wider.
struct Label {
  std::string words = {};
  double left = 0, right = 0, top = 0, bottom = 0, smallest = 1e9;

  bool on(const Label& other) const {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
  }
};

Label label_of(const Node& text) {
  const double size = text.number("font-size");
  Label label;
  double width = 0, fall = 0, largest = 0, lowest = 0;
  const auto add = [&](const std::string& letters, double letter_size, bool bold) {
    label.words += letters;
    label.smallest = std::min(label.smallest, letter_size);
    largest = std::max(largest, letter_size);
    lowest = std::max(lowest, fall + 0.2 * letter_size);
    width +=
        text_width(letters, float(1.164 * letter_size), bold);  // from ascender to descender it is 1.164 times the size
  };
  for (const Node& child : text.children) {
    if (child.has("dy")) fall += child.number("dy");
    const double own = child.has("font-size") ? child.number("font-size") : size;
    add(child.name.empty() ? child.text : child.children.at(0).text, own, text.has("font-weight"));
  }
  const std::string anchor = text.has("text-anchor") ? text.attributes.at("text-anchor") : "";
  label.left = text.number("x") - (anchor == "middle" ? width / 2 : anchor == "end" ? width : 0);
  label.right = label.left + width;
  label.top = text.number("y") - 0.75 * largest;
  label.bottom = text.number("y") + lowest;
  return label;
}

std::vector<Label> labels_in(const Node& node) {
  std::vector<Label> labels;
  if (node.name == "text") labels.push_back(label_of(node));
  for (const Node& child : node.children) {
    for (Label& label : labels_in(child)) labels.push_back(std::move(label));
  }
  return labels;
}

}  // namespace

TEST_CASE("docs/figures/ holds what ./course figures draws, and nothing else") {
  if (sizeof(Real) != sizeof(double)) return;  // the figures are those of double
  std::set<std::string> drawn, there;
  for (const Figure& figure : all_figures()) {
    INFO(figure.file);
    drawn.insert(figure.file);
    CHECK(text_of(folder / figure.file) == figure.draw());
  }
  for (const auto& entry : fs::directory_iterator(folder)) there.insert(entry.path().filename().string());
  CHECK(there == drawn);
}

TEST_CASE("a reader of XML refuses what is not well-formed") {
  CHECK(Reader("<a b=\"c\"><d/>e &lt; f</a>\n").document().children.at(1).text == "e < f");
  for (const char* wrong : {"<a>", "<a></b>", "<a", "<a b></a>", "<a b=c/>", "<a b=\"1\" b=\"2\"/>", "<a>&nbsp;</a>",
                            "<a b=\"<\"/>", "<a/><b/>", "text"}) {
    INFO(wrong);
    CHECK_THROWS_AS(Reader(wrong).document(), std::runtime_error);
  }
}

TEST_CASE("in no figure is a label cut off, too small to read, or on another one") {
  for (const Figure& figure : all_figures()) {
    const Node svg = Reader(text_of(folder / figure.file)).document();
    const double width = svg.number("width"), height = svg.number("height");
    CHECK(svg.attributes.at("viewBox") == fmt::format("0 0 {} {}", width, height));
    CHECK(width == 830);
    CHECK(svg.children.at(1).name == "title");
    const std::vector<Label> labels = labels_in(svg);
    CHECK(labels.size() > 4);
    for (std::size_t i = 0; i < labels.size(); ++i) {
      INFO(figure.file << ": " << labels[i].words << ", " << labels[i].left << " to " << labels[i].right);
      CHECK(labels[i].left >= 4);
      CHECK(labels[i].right <= width - 4);
      CHECK(labels[i].top >= 4);
      CHECK(labels[i].bottom <= height - 4);
      CHECK(labels[i].smallest >= 12);  // of what is set below or above the line
      for (std::size_t j = 0; j < i; ++j) {
        INFO(labels[j].words << ", " << labels[j].left << " to " << labels[j].right);
        CHECK_FALSE(labels[i].on(labels[j]));
      }
    }
  }
}

TEST_CASE("each figure stands on a page, with words for who cannot see it") {
  std::string pages;
  for (const fs::path& page : pages_in(SOURCE_DIR)) pages += text_of(page);
  for (const Figure& figure : all_figures()) {
    INFO(figure.file);
    const std::size_t at = pages.find("figures/" + std::string(figure.file) + ")");
    REQUIRE(at != std::string::npos);
    const std::size_t begin = pages.rfind("![", at) + 2, end = pages.find("](", begin);
    CHECK(end < at);
    CHECK(end - begin > 80);
    const std::string told = pages.substr(begin, end - begin);
    for (const Label& label : labels_in(Reader(text_of(folder / figure.file)).document())) {
      const std::size_t off = label.words.find("° off"),
                        number = off == std::string::npos ? off : label.words.rfind(' ', off);
      if (off == std::string::npos || label.words[number + 1] == '0') continue;
      INFO(label.words);
      CHECK(contains(told, label.words.substr(number + 1, off - number)));
    }
  }
}

TEST_CASE("the figure of the two points shows the numbers of chapter 02's table") {
  const TwoPointColumn::Solved sums = solved_in_turn(false), each = solved_in_turn(true);
  const std::string page = text_of(fs::path(SOURCE_DIR) / "chapters/02_clamping/README.md");
  const TwoPointColumn column;
  CHECK(column.coupling(0, 0) == Approx(1.3));
  CHECK(column.coupling(0, 1) == Approx(0.7));
  for (std::size_t stop = 1; stop < 5; ++stop) {
    for (const Real sum : sums.sums[stop]) {
      if (sum > 0) CHECK(contains(page, fmt::format("{:.3f}", sum)));
    }
    for (const Real speed : sums.speeds[stop]) {
      if (std::abs(speed) > 0.01) CHECK(contains(page, fmt::format("{:.3f}", std::abs(speed))));
    }
  }
  // The sum's error falls by (K12/K11)^2 in each iteration; with each correction clamped, nothing moves after the first.
  const Real factor = Real(0.7 * 0.7 / (1.3 * 1.3));
  for (std::size_t stop = 4; stop + 2 < sums.sums.size(); stop += 2)
    CHECK(sums.sums[stop + 2][1] - Real(0.5) == Approx(factor * (sums.sums[stop][1] - Real(0.5))));
  for (const auto& [first, second] : std::vector(each.sums.begin() + 2, each.sums.end())) {
    CHECK(first == Approx(1 / Real(1.3)));
    CHECK(second == Approx(Real(0.6) / (Real(1.3) * Real(1.3))));
  }
}
