/// A Measured as text: the line that a program prints, and the words that stand for missing numbers.
#pragma once

#include "pushback/chapters/19_accuracy_and_time/front.h"

namespace pushback::study {

/// m, or "late" or "lost".
std::string error_text(const Measured& one);
/// "–" where rows are no measure.
std::string row_solves_text(const Measured& one);
/// Both back again. Throws InvalidInput where a word is none of these.
void read_error(const std::string& word, Measured& into);
void read_row_solves(const std::string& word, Measured& into);

/// "full/4/16 error 1.2345e-03 seconds 4.5678e-02 row-solves 6.7890e+06", of what was played once.
std::string line_of(const Measured& once);
/// Adds to a setting what such a line says of it. Throws std::runtime_error, with the engine and the line, where it is none.
void add_line(const std::string& line, Measured& into);

}  // namespace pushback::study
