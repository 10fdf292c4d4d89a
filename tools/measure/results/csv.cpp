#include "pushback/tools/measure/results/csv.h"

namespace pushback {

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

std::vector<std::vector<std::string>> csv_fields(const std::string& text) {
  std::vector<std::vector<std::string>> lines;
  bool quoted = false, begins = true;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (begins) lines.push_back({""});
    begins = false;
    if (text[i] == '"' && quoted && text[i + 1] == '"') lines.back().back() += text[++i];
    else if (text[i] == '"') quoted = !quoted;
    else if (text[i] == ',' && !quoted) lines.back().emplace_back();
    else if (text[i] == '\n' && !quoted) begins = true;
    else lines.back().back() += text[i];
  }
  return lines;
}

}  // namespace pushback
