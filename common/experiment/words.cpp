#include "pushback/common/experiment/words.h"

#include <fmt/format.h>

#include <cctype>
#include <cmath>

#include "pushback/common/experiment/scene.h"

namespace pushback {

std::string in_words(Real value, const std::string& unit) {
  if (!std::isfinite(value)) return "–";
  std::string text;
  const Real size = std::abs(value);
  if (size == 0) text = "0";
  else if (size < 1e-6) text = "< 1e-6";
  else if (size < 1e-3 || size >= 1e6) text = fmt::format("{:.2e}", value);
  else if (size >= 1000) text = fmt::format("{:.0f}", value);
  else text = fmt::format("{:.3g}", value);
  return unit.empty() ? text : text + " " + unit;
}

std::string slug(std::string name) {
  static const std::vector<std::pair<std::string, std::string>> spelling{
      {"β", "beta"}, {"μ", "mu"}, {"Σ", "sum-"}, {"λ", "lambda"}, {"θ", "theta"}, {"ω", "omega"}, {"≥", "at-least"}};
  for (const auto& [symbol, word] : spelling) {
    for (std::size_t at = name.find(symbol); at != std::string::npos; at = name.find(symbol, at))
      name.replace(at, symbol.size(), word);
  }
  std::string out;
  for (const unsigned char c : name) {
    const bool keep = c < 0x80 && (std::isalnum(c) != 0 || c == '.');
    if (keep) out += static_cast<char>(std::tolower(c));
    else if (!out.empty() && out.back() != '-') out += '-';
  }
  while (!out.empty() && out.back() == '-') out.pop_back();
  return out;
}

std::string key_of(const Scene& scene) {
  return slug(scene.key.empty() ? scene.name : scene.key);
}

}  // namespace pushback
