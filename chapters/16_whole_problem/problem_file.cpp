#include "pushback/chapters/16_whole_problem/problem_file.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <utility>
#include <vector>

#include "pushback/common/basics/input.h"

namespace pushback {

namespace {

using Eigen::Index;
using Triplets = std::vector<Eigen::Triplet<double>>;

constexpr Index most_contacts = 1000000;
constexpr double largest = 1e100;  // so that squares and their sums stay finite

/// Reads a text word by word.
class Reader {
 public:
  explicit Reader(const std::string& text) : next_(text.data()), end_(text.data() + text.size()) {}

  /// Reads a number that messages call `what`(i, j), or `what`(i).
  double number(const char* what, Index i, Index j = -1) {
    const std::string_view word = next([&] { return place(what, i, j); });
    const char* begin = word.data() + (word.front() == '+' ? 1 : 0);
    double value = 0;
    const auto [stopped, error] = std::from_chars(begin, word.data() + word.size(), value);
    const bool whole = stopped == word.data() + word.size();
    if (whole && error == std::errc::result_out_of_range && tiny(word)) return 0;
    if (error != std::errc() || !whole || !(std::abs(value) <= largest))
      throw InvalidInput(
          fmt::format("{} is '{}': a number of at most {:g} is needed", place(what, i, j), shown(word), largest));
    return value;
  }
  /// Reads a whole number from `least` to `most`.
  Index count(const std::string& what, Index least, Index most) {
    const std::string_view word = next([&] { return what; });
    Index value = 0;
    const auto [stopped, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || stopped != word.data() + word.size() || value < least || value > most)
      throw InvalidInput(fmt::format(
          "{} is '{}': {} is needed", what, shown(word),
          least == most ? fmt::to_string(least) : fmt::format("a whole number from {} to {}", least, most)));
    return value;
  }
  /// Throws InvalidInput, before memory is allocated, if the rest of the text is too short for so many numbers: each takes at
  /// least one character and a separator.
  void need(Index numbers, const std::string& what) const {
    if (numbers > (end_ - next_ + 1) / 2)
      throw InvalidInput(
          fmt::format("{}: {} numbers are needed, but only {} characters follow", what, numbers, end_ - next_));
  }
  /// Whether the text has no further word.
  bool ended() {
    skip();
    return next_ == end_;
  }

 private:
  void skip() {
    while (next_ != end_ && std::isspace(static_cast<unsigned char>(*next_)) != 0) ++next_;
  }
  static std::string place(const char* what, Index i, Index j) {
    return j < 0 ? fmt::format("{}({})", what, i) : fmt::format("{}({}, {})", what, i, j);
  }
  template <class What>
  std::string_view next(const What& what) {
    skip();
    if (next_ == end_) throw InvalidInput(fmt::format("the file ends where {} should stand", what()));
    const char* begin = next_;
    while (next_ != end_ && std::isspace(static_cast<unsigned char>(*next_)) == 0) ++next_;
    return {begin, static_cast<std::size_t>(next_ - begin)};
  }
  /// Whether a number out of range is too near to 0 for a double, not too large.
  static bool tiny(std::string_view word) {
    const std::size_t e = word.find_first_of("eE");
    return e != std::string_view::npos ? word.substr(e + 1).starts_with('-') : true;
  }
  /// At most 40 printable characters of a word, because the file may not be text.
  static std::string shown(std::string_view word) {
    std::string part(word.substr(0, 40));
    for (char& c : part)
      if (std::isprint(static_cast<unsigned char>(c)) == 0) c = '?';
    return part + (word.size() > 40 ? "..." : "");
  }

  const char *next_, *end_;
};

void read_dense(Reader& in, Index size, Triplets& entries) {
  in.count("rows of the dense matrix", size, size);
  in.count("columns of the dense matrix", size, size);
  in.need(size * size, "W");
  for (Index column = 0; column < size; ++column)
    for (Index row = 0; row < size; ++row) {
      const double value = in.number("W", row, column);
      if (value != 0 || row / 3 == column / 3)
        entries.emplace_back(static_cast<int>(row), static_cast<int>(column), value);
    }
}

void read_blocks(Reader& in, Index contacts, Triplets& entries) {
  const Index blocks = in.count("number of blocks", 0, contacts * contacts);
  in.count("number of block rows", contacts, contacts);
  in.count("number of block columns", contacts, contacts);
  in.need(3 * contacts + blocks * 11, "W");
  for (const char* side : {"row", "column"})
    for (Index c = 0; c < contacts; ++c) in.count(fmt::format("end of block {} {}", side, c), 3 * (c + 1), 3 * (c + 1));
  in.count("length of the list of block rows", contacts + 1, contacts + 1);
  in.count("length of the list of block columns", blocks, blocks);
  std::vector<Index> begin, column;
  for (Index c = 0; c <= contacts; ++c) {
    const std::string what = c < contacts ? fmt::format("first block of block row {}", c) : "end of the last block row";
    begin.push_back(in.count(what, c == 0 ? 0 : begin.back(), c == 0 ? 0 : blocks));
  }
  if (begin.back() != blocks)
    throw InvalidInput(
        fmt::format("end of the last block row is {}: {}, the number of blocks, is needed", begin.back(), blocks));
  for (Index i = 0; i < blocks; ++i)
    column.push_back(in.count(fmt::format("block column of block {}", i), 0, contacts - 1));
  std::vector<Index> seen_in_row(static_cast<std::size_t>(contacts), -1);
  for (Index row = 0; row < contacts; ++row) {
    for (Index i = begin[static_cast<std::size_t>(row)]; i < begin[static_cast<std::size_t>(row) + 1]; ++i) {
      const Index at = column[static_cast<std::size_t>(i)];
      if (std::exchange(seen_in_row[static_cast<std::size_t>(at)], row) == row)
        throw InvalidInput(fmt::format("block ({}, {}) is given twice: each at most once is needed", row, at));
      in.count("number of a block", i, i);
      for (Index entry = 0; entry < 9; ++entry) {
        const Index r = 3 * row + entry % 3, c = 3 * at + entry / 3;
        entries.emplace_back(static_cast<int>(r), static_cast<int>(c), in.number("W", r, c));
      }
    }
  }
}

Vector read_numbers(Reader& in, const char* what, Index count) {
  in.need(count, what);
  Vector numbers(count);
  for (Index i = 0; i < count; ++i) numbers[i] = in.number(what, i);
  return numbers;
}

}  // namespace

ContactProblem read_problem(const std::string& text) {
  Reader in(text);
  in.count("dimension", 3, 3);
  const Index contacts = in.count("number of contacts", 1, most_contacts);
  const Index size = 3 * contacts;
  const Index storage = in.count("storage", 0, 1);
  in.count("number of rows", size, size);
  in.count("number of columns", size, size);
  Triplets entries;
  if (storage == 0) read_dense(in, size, entries);
  else read_blocks(in, contacts, entries);
  for (int i = 0; i < static_cast<int>(size); ++i)  // all nine entries of each diagonal block, given or not
    for (int j = i - i % 3; j < i - i % 3 + 3; ++j) entries.emplace_back(i, j, 0);
  ContactProblem problem;
  problem.q = read_numbers(in, "q", size);
  problem.mu = read_numbers(in, "mu", contacts);
  if (!in.ended() && in.count("what follows the last mu", 0, 1) == 0 && !in.ended())
    throw InvalidInput("after the last mu and a 0, the end of the file is needed");
  problem.w.resize(size, size);
  problem.w.setFromTriplets(entries.begin(), entries.end());
  for (Index i = 0; i < size; ++i)
    if (problem.w.coeff(i, i) < 0)
      throw InvalidInput(
          fmt::format("W({0}, {0}) is {1}: 0 or more is needed on the diagonal", i, problem.w.coeff(i, i)));
  for (Index c = 0; c < contacts; ++c) require_not_negative(fmt::format("mu({})", c), static_cast<Real>(problem.mu[c]));
  return problem;
}

ContactProblem read_problem_file(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::error_code error;
  if (!in || !std::filesystem::is_regular_file(file, error))
    throw InvalidInput(fmt::format("file '{}' cannot be read: a contact problem is needed", file.string()));
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  try {
    return read_problem(text);
  } catch (const InvalidInput& problem) {
    throw InvalidInput(fmt::format("{}: {}", file.string(), problem.what()));
  }
}

std::string problem_text(const ContactProblem& problem) {
  const Index contacts = problem.contacts();
  std::string begins = "0", columns, blocks;
  Index count = 0;
  for (Index row = 0; row < contacts; ++row) {
    std::vector<std::pair<Index, Eigen::Matrix3d>> found;  // few, in any order
    for (Index i = 0; i < 3; ++i) {
      for (SparseMatrix::InnerIterator it(problem.w, 3 * row + i); it; ++it) {
        const Index column = it.col() / 3;
        auto at = std::find_if(found.begin(), found.end(), [&](const auto& block) { return block.first == column; });
        if (at == found.end()) at = found.insert(at, {column, Eigen::Matrix3d::Zero()});
        at->second(i, it.col() % 3) = it.value();
      }
    }
    std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [column, block] : found) {
      columns += fmt::format("{} ", column);
      blocks += fmt::format("{}\n", count++);
      for (Index i = 0; i < 9; ++i) blocks += fmt::format("{}\n", block(i % 3, i / 3));
    }
    begins += fmt::format(" {}", count);
  }
  std::string ends;
  for (Index c = 1; c <= contacts; ++c) ends += fmt::format("{} ", 3 * c);
  std::string text = fmt::format("3\n{0}\n1\n{1}\n{1}\n{2}\n{0}\n{0}\n", contacts, 3 * contacts, count);
  text += fmt::format("{0}\n{0}\n{1}\n{2}\n{3}\n{4}\n{5}", ends, contacts + 1, count, begins, columns, blocks);
  for (const double value : problem.q) text += fmt::format("{} ", value);
  text += "\n";
  for (const double value : problem.mu) text += fmt::format("{} ", value);
  return text + "\n";
}

std::string solution_text(const ContactProblem& problem, const Vector& r) {
  const Vector u = problem.speeds(r);
  std::string text = fmt::format("{}\n", problem.contacts());
  for (Index i = 0; i < r.size(); i += 3)
    text += fmt::format("{:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g}\n", r[i], r[i + 1], r[i + 2], u[i], u[i + 1],
                        u[i + 2]);
  return text;
}

}  // namespace pushback
