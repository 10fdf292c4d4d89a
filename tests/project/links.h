/// Links in pages of Markdown, and what is wrong with them: files, anchors, pictures. What is elsewhere in the world is not
/// asked for, only looked at.
#pragma once

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/call.h"

/// The text with what stands in fences and in `code` blanked out: nothing there is a link.
inline std::string without_code(const std::string& text) {
  std::string plain;
  bool fenced = false;
  for (std::string line : lines_of(text)) {
    const bool fence = line.starts_with("```");
    if (fence || fenced) line.clear();
    fenced = fenced != fence;
    plain += line + "\n";
  }
  static const std::regex code("`[^`\n]+`");
  return std::regex_replace(plain, code, "`");
}

/// GitHub's anchor of a heading: in small letters, without marks; blanks and hyphens are hyphens, and a word's underscore stays.
inline std::string anchor_of(std::string heading) {
  static const std::regex link(R"(!?\[([^\]]*)\]\([^)]*\))");
  heading = std::regex_replace(heading, link, "$1");
  // Outside of ASCII our headings have letters, which stay, and these marks, which do not.
  for (const std::string mark : {"–", "—", "’", "‘", "“", "”", "…", "·", "×", "→", "²"}) {
    for (std::size_t at = heading.find(mark); at != std::string::npos; at = heading.find(mark, at))
      heading.erase(at, mark.size());
  }
  std::string anchor;
  for (const unsigned char c : heading) {
    if (c >= 0x80 || c == '_' || c == '-') anchor += static_cast<char>(c);
    else if (c == ' ') anchor += '-';
    else if (std::isalnum(c) != 0) anchor += static_cast<char>(std::tolower(c));
  }
  return anchor;
}

/// All anchors of a page. A heading that comes again has a number behind it.
inline std::set<std::string> anchors_in(const std::string& page) {
  std::set<std::string> anchors;
  std::map<std::string, int> times;
  bool fenced = false;
  for (const std::string& line : lines_of(page)) {
    if (line.starts_with("```")) fenced = !fenced;
    const std::size_t hashes = line.find_first_not_of('#');
    if (fenced || hashes == 0 || hashes == std::string::npos || hashes > 6 || line[hashes] != ' ') continue;
    const std::string anchor = anchor_of(line.substr(hashes + 1));
    const int before = times[anchor]++;
    anchors.insert(before == 0 ? anchor : anchor + "-" + std::to_string(before));
  }
  return anchors;
}

/// The targets of [text](target) and ![text](target), in their order.
inline std::vector<std::string> targets_in(const std::string& page) {
  const std::string plain = without_code(page);
  std::vector<std::string> targets;
  for (std::size_t at = plain.find("]("); at != std::string::npos; at = plain.find("](", at + 2)) {
    int open = 1;
    std::size_t end = at + 2;
    while (end < plain.size() && open > 0) open += plain[end] == '(' ? 1 : plain[end] == ')' ? -1 : 0, ++end;
    targets.push_back(plain.substr(at + 2, end - at - 3));
  }
  return targets;
}

/// What is wrong with this link on this page; empty if nothing is.
inline std::string wrong_with(const std::string& target, const fs::path& page) {
  static const std::regex elsewhere(R"((https?://[A-Za-z0-9-]+(\.[A-Za-z0-9-]+)+(/[^\s<>]*)?|mailto:[^\s@]+@[^\s@]+))");
  if (target.find(':') != std::string::npos)
    return std::regex_match(target, elsewhere) ? "" : "no address has this form";
  const std::size_t hash = target.find('#');
  const fs::path file = hash == 0 ? page : page.parent_path() / target.substr(0, hash);
  if (target.empty() || !fs::exists(file)) return "there is no such file";
  if (hash == std::string::npos) return "";
  const std::string anchor = target.substr(hash + 1);
  if (file.extension() != ".md") return "an anchor in what is no page";
  return anchors_in(text_of(file)).contains(anchor) ? "" : "there is no such heading";
}

/// "page: target: what is wrong", for each link that leads nowhere.
inline std::vector<std::string> wrong_links(const fs::path& page) {
  std::vector<std::string> wrong;
  for (const std::string& target : targets_in(text_of(page))) {
    const std::string why = wrong_with(target, page);
    if (!why.empty()) wrong.push_back(page.string() + ": " + target + ": " + why);
  }
  return wrong;
}

/// All pages below a folder, but for what was built and what is hidden.
inline std::vector<fs::path> pages_in(const fs::path& folder) {
  std::vector<fs::path> pages;
  for (auto at = fs::recursive_directory_iterator(folder); at != fs::recursive_directory_iterator(); ++at) {
    const std::string name = at->path().filename().string();
    if (at->is_directory() && (name == "build" || name == "node_modules" || name.starts_with('.')))
      at.disable_recursion_pending();
    else if (at->path().extension() == ".md") pages.push_back(at->path());
  }
  std::sort(pages.begin(), pages.end());
  return pages;
}
