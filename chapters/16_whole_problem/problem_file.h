/// Contact problems as text files, in the format of Siconos.
///
///   3   number of contacts   storage   rows   columns   W   q   mu        (all separated by white space)
///
/// With storage 0, W is dense, with its rows, its columns, and its numbers column by column. With storage 1, W has sparse blocks:
///   the number of blocks, of block rows, of block columns
///   the end of each block row and of each block column
///   the lengths of the two lists that follow
///   the index in the list of blocks at which each block row begins, and the block column of each block
///   for each block its index and its nine numbers, column by column
/// Some files have a 0 after mu, or a 1 and an initial guess, which is not read.
/// Siconos (Inria), numerics: frictionContact_printInFile, SBM_write_in_file.
#pragma once

#include <filesystem>
#include <string>

#include "pushback/engine/direct/contact_problem.h"

namespace pushback {

/// Throws InvalidInput with the reason, such as a text that is cut short, a word that is not a number, sizes that do not agree,
/// or a mu below 0.
ContactProblem read_problem(const std::string& text);
/// The same for a file. The message of an InvalidInput contains the file's name.
ContactProblem read_problem_file(const std::filesystem::path& file);

/// The problem with storage 1. Each number has enough digits to give the same bits when it is read.
std::string problem_text(const ContactProblem& problem);

/// The text that --write writes, for another program to check. It has the number of contacts on a line, then a line for each
/// contact, in the order of the problem, with r_n r_t1 r_t2 in N s and u_n u_t1 u_t2 = (W r + q) in m/s. Each number has 17 digits,
/// which preserve its bits.
std::string solution_text(const ContactProblem& problem, const Vector& r);

}  // namespace pushback
