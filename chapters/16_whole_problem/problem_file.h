/// Contact problems as text files, in the format of Siconos.
///
///   3, number of contacts, storage; rows, columns; the matrix W; q; mu        (all separated by white space)
///
/// Storage 0 is dense: rows, columns, the numbers column by column. Storage 1 is sparse blocks: number of blocks, of block
/// rows, of block columns; where each block row ends, where each block column ends; how long the two lists are that follow;
/// where the blocks of each block row begin in the list, and the block column of each; then for each block its number in
/// the list and its nine numbers, column by column. After mu some files have a 0, or a 1 and a first guess, which is not read.
/// Siconos (Inria), numerics: frictionContact_printInFile, SBM_write_in_file.
#pragma once

#include <filesystem>
#include <string>

#include "pushback/engine/direct/contact_problem.h"

namespace pushback {

/// Throws InvalidInput, saying what of the text is wrong: cut short, not a number, sizes that do not agree, a mu below 0.
ContactProblem read_problem(const std::string& text);
/// The same of a file; what it throws begins with the file's name.
ContactProblem read_problem_file(const std::filesystem::path& file);

/// With storage 1, every number in as many digits as give the same bits when read.
std::string problem_text(const ContactProblem& problem);

/// What --write leaves, for another program to check: the number of contacts on a line; then a line for each contact, in the
/// order of the problem, with r_n r_t1 r_t2 in N s and u_n u_t1 u_t2 = (W r + q) in m/s, each in 17 digits: the same bits.
std::string solution_text(const ContactProblem& problem, const Vector& r);

}  // namespace pushback
