#include "pushback/tools/measure/study/record.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "pushback/common/basics/input.h"
#include "pushback/tools/measure/results/csv.h"

namespace pushback::study {

namespace {

constexpr const char* no_measure = "–";

double not_negative(const std::string& word) {
  const double number = csv_number<double>(word);
  if (!(number >= 0)) throw InvalidInput(fmt::format("there is '{}' where a number from 0 on is needed", word));
  return number;
}

}  // namespace

std::string error_text(const Measured& one) {
  return one.late ? "late" : std::isfinite(one.error) ? fmt::format("{:.4e}", one.error) : "lost";
}

std::string row_solves_text(const Measured& one) {
  return one.row_solves ? fmt::format("{:.4e}", *one.row_solves) : no_measure;
}

void read_error(const std::string& word, Measured& into) {
  into.late = word == "late";
  into.error = into.late || word == "lost" ? std::numeric_limits<double>::infinity() : not_negative(word);
}

void read_row_solves(const std::string& word, Measured& into) {
  into.row_solves.reset();
  if (word != no_measure) into.row_solves = not_negative(word);
}

std::string line_of(const Measured& once) {
  return fmt::format("{} error {} seconds {:.4e} row-solves {}", once.setting(), error_text(once), once.median(),
                     row_solves_text(once));
}

void add_line(const std::string& line, Measured& into) {
  try {
    std::istringstream in(line);
    std::string setting, word, error, time, row_solves;
    in >> setting >> word >> error >> word >> time >> word >> row_solves;
    if (setting != into.setting()) throw InvalidInput(fmt::format("there is '{}'", setting));
    read_error(error, into);
    read_row_solves(row_solves, into);
    const double seconds = not_negative(time);
    if (std::isfinite(into.error) && seconds == 0) throw InvalidInput("it has taken no time");
    into.seconds.insert(std::upper_bound(into.seconds.begin(), into.seconds.end(), seconds), seconds);
  } catch (const InvalidInput& problem) {
    throw std::runtime_error(
        fmt::format("{} printed no measurement of {}: '{}': {}", into.engine, into.setting(), line, problem.what()));
  }
}

}  // namespace pushback::study
